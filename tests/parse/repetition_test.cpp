// Repetitions: index, low, high, each with its place.
#include "parse/repetition.hpp"

#include <catch2/catch.hpp>

#include "parse_testing.hpp"

using namespace elgen;

namespace {

std::string repetition(std::string_view value) {
  const std::string all = testing::model_answer(
      "format = 1\nmodel.name = \"m\"\n[[coordinate]]\nname = \"x\"\nfor = " + std::string(value));
  const std::size_t begin = all.find("for = ");
  return begin == std::string::npos ? all : all.substr(begin + 6, all.size() - begin - 7);
}

}  // namespace

TEST_CASE("a repetition is an index and its bounds", "[parse]") {
  CHECK(repetition("\"i in 1..n\"") == "[{index = i, low = 1, high = n}]");
  CHECK(repetition("\"i in 0 .. 2*n - 1\"") == "[{index = i, low = 0, high = ((2 * n) + (-1))}]");
  CHECK(repetition("[\"i in 1..n\", \"j in i..n\"]") ==
        "[{index = i, low = 1, high = n}, {index = j, low = i, high = n}]");
}

TEST_CASE("malformed repetitions are refused where they are", "[parse]") {
  CHECK(repetition("\"i in 1:n\"") == "E210 5:8");
  CHECK(repetition("\"i = 1..n\"") == "E210 5:8");
  CHECK(repetition("\"1..n\"") == "E210 5:8");
  CHECK(repetition("\"\"") == "E210 5:8");
  CHECK(repetition("3") == "E104 5:7");
  CHECK(repetition("\"i in ..n\"") == "E310 5:12");
  CHECK(repetition("\"i in 1..\"") == "E310 5:16");
  CHECK(repetition("\"i in 1..2n\"") == "E303 5:17");
  CHECK(repetition("\"i\\u0020in 1..2n\"") == "E303 5:22");
}

TEST_CASE("each part of a repetition has its place", "[parse]") {
  const SourcePointer source = make_source(
      "test", "format = 1\nmodel.name = \"m\"\n[[coordinate]]\nname = \"x\"\nfor = \"i in 1..n\"");
  const auto model = parse_model(source, {});
  REQUIRE(model);
  const KeySyntax* key = model->entries.back().find("for");
  REQUIRE(key != nullptr);
  const auto& parts = key->value.items.at(0).entries;
  REQUIRE(parts.size() == 3);
  CHECK(covered_text(parts[0].value.span) == "i");
  CHECK(covered_text(parts[1].value.expression.span) == "1");
  CHECK(covered_text(parts[2].value.expression.span) == "n");
}
