// Options: words and assignments keep their places.
#include "check/expressions/options.hpp"

#include <catch2/catch.hpp>

namespace elgen {
namespace {

TEST_CASE("words are split at commas and keep their places") {
  const SourcePointer one = make_source("command line", "a, b c ,d");
  const SourcePointer two = make_source("command line", "e");
  const std::vector<OptionWord> words = words_of({one, two});
  REQUIRE(words.size() == 4);
  CHECK(words[1].text == "b c");
  CHECK(words[1].span.begin == 3);
  CHECK(words[1].span.end == 6);
  CHECK(words[3].span.source == two.get());
  CHECK(words_of({make_source("command line", "a,")}).back().text.empty());
  CHECK(words_of({}).empty());
}

TEST_CASE("commas in brackets split nothing") {
  const SourcePointer source = make_source("command line", "e=[1, 0], x=max(1, (2)),y");
  const std::vector<OptionWord> words = words_of({source});
  REQUIRE(words.size() == 3);
  CHECK(words[0].text == "e=[1, 0]");
  CHECK(words[1].text == "x=max(1, (2))");
  CHECK(words[2].span.begin == 24);
}

TEST_CASE("assignments are split at the first equals sign") {
  const SourcePointer source = make_source("command line", "g, m = 1/2 ");
  const std::vector<OptionWord> words = words_of({source});
  const Assignment whole = split_assignment(words[0]);
  CHECK(whole.name.text == "g");
  CHECK(whole.value.begin == whole.value.end);
  const Assignment parts = split_assignment(words[1]);
  CHECK(parts.name.text == "m");
  CHECK(covered_text(parts.value) == "1/2");
  CHECK(parts.value.begin == 7);
}

TEST_CASE("sizes of the option are set one after another") {
  const Limits limits;
  Context context(limits);
  context.sizes = {{"n", 1}, {"m", 1}};
  SceneOptions options;
  options.sizes = {make_source("command line", "n=3,m=4,n=5")};
  read_sizes(context, {}, nullptr, options);
  CHECK(context.sizes == Sizes{{"m", 4}, {"n", 5}});
  CHECK(context.report.errors() == 0);
}

TEST_CASE("sizes are integers that sums and products of two can hold") {
  const auto answer = [](const std::string& option) {
    const Limits limits;
    Context context(limits);
    context.sizes = {{"n", 1}};
    SceneOptions options;
    options.sizes = {make_source("command line", option)};
    read_sizes(context, {}, nullptr, options);
    return context.report.errors() == 0 ? std::to_string(context.sizes["n"])
                                        : context.report.sorted().front().message;
  };
  CHECK(answer("n=1000000000") == "1000000000");
  CHECK(answer("n=-1000000000") == "-1000000000");
  CHECK(answer("n=1000000001") == "`1000000001` is beyond 1000000000");
  CHECK(answer("n=-9223372036854775807") == "`-9223372036854775807` is beyond 1000000000");
  CHECK(answer("n=99999999999999999999") == "`99999999999999999999` is beyond 1000000000");
  CHECK(answer("n=2.5") == "`n=2.5` is not of the form `n=20`");
  CHECK(answer("n") == "`n` is not of the form `n=20`");
}

}  // namespace
}  // namespace elgen
