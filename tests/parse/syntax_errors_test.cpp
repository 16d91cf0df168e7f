// The messages of the grammar: code, column, what was met, and what to write.
#include "parse/syntax_errors.hpp"

#include <catch2/catch.hpp>

#include "parse_testing.hpp"

using namespace elgen;

namespace {

struct GrammarRow {
  std::string input;
  Code code;
  std::uint32_t begin;
  std::string message;
  std::string hint;
};

}  // namespace

TEST_CASE("errors of the grammar say what was met and what to write", "[parse]") {
  const auto row = GENERATE(values<GrammarRow>({
      {"x +", Code::E302, 3, "expression ends where an operand is expected", ""},
      {"x+*y", Code::E302, 2, "`*` where an operand is expected", ""},
      {"()", Code::E302, 1, "`)` where an operand is expected", ""},
      {"sin(x,)", Code::E302, 6, "`)` where an operand is expected", ""},
      {"+x", Code::E302, 0, "`+` where an operand is expected", ""},
      {"[1]", Code::E301, 0, "`[` where an operand is expected", "an index follows a name: `q[i]`"},
      {"2x", Code::E303, 1, "`x` follows `2` without an operator", "write `2*x`"},
      {"x 2", Code::E303, 2, "`2` follows `x` without an operator", "write `x*2`"},
      {"2(x)", Code::E303, 1, "`(` follows `2` without an operator",
       "a product is written with `*`"},
      {"(x)y", Code::E303, 3, "`y` follows `)` without an operator",
       "a product is written with `*`"},
      {"sin(x y)", Code::E303, 6, "`y` follows `x` without an operator", "write `x*y`"},
      {"1,5", Code::E306, 1, "`1,5` has a decimal comma", "write `1.5`"},
      {"(0,25)*x", Code::E306, 2, "`0,25` has a decimal comma", "write `0.25`"},
      {"1, 5", Code::E301, 1, "`,` outside the arguments of a function", ""},
      {"(x,y)", Code::E301, 2, "`,` outside the arguments of a function", ""},
      {"q[1,2]", Code::E306, 3, "`1,2` has a decimal comma", "write `1.2`"},
      {"q[1][2]", Code::E301, 4, "`[` after `]`", "a name takes one index: `q[i]`"},
      {"x)", Code::E304, 1, "`)` was never opened", ""},
      {"x]", Code::E304, 1, "`]` was never opened", ""},
      {"", Code::E310, 0, "empty expression", "write `0` for nothing"},
      {"  \n", Code::E310, 0, "empty expression", "write `0` for nothing"},
  }));
  INFO(row.input);
  const Diagnostic error = testing::expression_error(row.input);
  CHECK(error.code == row.code);
  CHECK(error.span.begin == row.begin);
  CHECK(error.message == row.message);
  CHECK(error.hint == row.hint);
}

TEST_CASE("an unbalanced bracket says where it opened", "[parse]") {
  struct Bracket {
    std::string input;
    std::uint32_t begin;
    std::uint32_t opened;
    std::string message;
  };
  const auto row = GENERATE(values<Bracket>({
      {"(x+1", 4, 0, "`(` is not closed"},
      {"2*sin(x", 7, 5, "`(` is not closed"},
      {"q[i", 3, 1, "`[` is not closed"},
      {"((x)", 4, 0, "`(` is not closed"},
      {"(x]", 2, 0, "`]` stands where `(` is to be closed"},
      {"q[i)", 3, 1, "`)` stands where `[` is to be closed"},
  }));
  INFO(row.input);
  const Diagnostic error = testing::expression_error(row.input);
  CHECK(error.code == Code::E304);
  CHECK(error.span.begin == row.begin);
  CHECK(error.message == row.message);
  REQUIRE(error.related);
  CHECK(error.related->begin == row.opened);
  CHECK(error.related_message == "opened here");
}

TEST_CASE("a decimal comma inside a call is an argument more", "[parse]") {
  CHECK(testing::expression_answer("sin(1,5)") == "sin(1, 5)");
}
