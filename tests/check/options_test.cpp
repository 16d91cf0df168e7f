// Options, split into parts that point into their text, and the sizes that they set.
#include "check/expressions/options.hpp"

#include <catch2/catch.hpp>

#include "check_testing.hpp"

namespace elgen::test {

namespace {

const std::string free_masses = R"toml(format = 1
[model]
name = "masses"
[sizes]
n = 2
[[coordinate]]
for = "i in 1..n"
name = "x[i]"
[energy]
T = "sum(i, 1, n, dot(x[i])^2)"
)toml";

const std::string scene_head = "format = 1\nmodel = \"a.toml\"\nname = \"s\"\n";

std::size_t coordinates(const Wanted& wanted) {
  return checked(free_masses, wanted).model.coordinates.size();
}

}  // namespace

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

TEST_CASE("sizes of the option win over those of the model") {
  const Limits limits;
  Context context(limits);
  context.sizes = {{"n", 1}, {"m", 1}};
  SceneOptions options;
  options.sizes = {make_source("command line", "m=4,n=5")};
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

TEST_CASE("a scene overrides sizes, an option overrides both") {
  Wanted wanted;
  CHECK(coordinates(wanted) == 2);
  wanted.scene = scene_head + "[sizes]\nn = 3\n";
  CHECK(coordinates(wanted) == 3);
  wanted.sizes = {"n=5"};
  CHECK(coordinates(wanted) == 5);
}

TEST_CASE("unknown sizes are reported where they are written") {
  Wanted wanted;
  wanted.scene = scene_head + "[sizes]\nm = 3\n";
  CHECK(messages(free_masses, wanted) == "E605 5:1 unknown size `m`\n");
  wanted.scene.clear();
  wanted.sizes = {"n=3, size=2"};
  CHECK(messages(free_masses, wanted) == "E605 1:6 unknown size `size`\n");
}

TEST_CASE("malformed sizes are reported") {
  for (const char* size : {"n", "n=", "n=x", "n=2.5"}) {
    Wanted wanted;
    wanted.sizes = {size};
    CHECK(messages(free_masses, wanted) ==
          "E606 1:1 `" + std::string(size) + "` is not of the form `n=20`\n");
  }
  Wanted wanted;
  for (const char* size : {"99999999999", "-99999999999"}) {
    wanted.sizes = {std::string("n=") + size};
    CHECK(messages(free_masses, wanted) ==
          "E606 1:3 `" + std::string(size) + "` is beyond 1000000000\n");
  }
}

TEST_CASE("a size may be too small for a repetition") {
  CHECK(messages(free_masses, {.sizes = {"n=0"}}) == "E209 7:8 from 1 to 0 there is no element\n");
}

TEST_CASE("a size is a name of the model") {
  CHECK(messages(free_masses + "[parameters]\nn = 3\n") ==
        "E203 12:1 `n` is already a size | first at line 5\n");
}

}  // namespace elgen::test
