// Expression trees: precedence, chains, spans, depth, and printing and parsing back. Messages of
// the grammar: code, column, the token found, and a hint.
#include "parse/expression_parser.hpp"

#include <rapidcheck.h>

#include <catch2/catch.hpp>

#include "parse_testing.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

ExpressionSyntax parsed(const SourcePointer& source) {
  auto result = parse_expression(source, {});
  REQUIRE(result);
  return std::move(*result);
}

Limits depth(std::uint64_t levels) {
  Limits limits;
  limits.expression_depth = levels;
  return limits;
}

bool same_tree(const ExpressionSyntax& a, const ExpressionSyntax& b) {
  if (a.kind != b.kind || a.text != b.text || a.value != b.value) return false;
  if (a.operands.size() != b.operands.size()) return false;
  for (std::size_t i = 0; i < a.operands.size(); ++i) {
    if (!same_tree(a.operands[i], b.operands[i])) return false;
  }
  return true;
}

/// A random expression of the grammar.
std::string random_expression(int depth) {
  const int choice = *rc::gen::inRange(0, depth > 0 ? 9 : 3);
  const auto inner = [&] { return random_expression(depth - 1); };
  switch (choice) {
    case 0:
      return *rc::gen::element<std::string>("x", "theta_1", "t", "q[i]");
    case 1:
      return std::to_string(*rc::gen::inRange(0, 1000));
    case 2:
      return std::to_string(*rc::gen::inRange(0, 1000)) + "e-2";
    case 3:
      return inner() + " + " + inner();
    case 4:
      return inner() + " - " + inner();
    case 5:
      return inner() + "*" + inner();
    case 6:
      return "(" + inner() + ")/(" + inner() + ")";
    case 7:
      return "-" + inner();
    default:
      return "atan2((" + inner() + ")^2, p[" + inner() + "])";
  }
}

struct GrammarRow {
  std::string input;
  Code code;
  std::uint32_t begin;
  std::string message;
  std::string hint;
};

}  // namespace

TEST_CASE("precedence and associativity", "[parse]") {
  struct Row {
    std::string_view input;
    std::string_view tree;
  };
  const auto row = GENERATE(values<Row>({
      {"a + b*c", "(a + (b * c))"},
      {"a - b - c", "(a + (-b) + (-c))"},
      {"a*b*c", "(a * b * c)"},
      {"a/b/c", "((a / b) / c)"},
      {"a*b/c*d", "(((a * b) / c) * d)"},
      {"1/2*m", "((1 / 2) * m)"},
      {"-x^2", "(-(x^2))"},
      {"-x*y", "((-x) * y)"},
      {"x^-1", "(x^(-1))"},
      {"2^3^2", "(2^(3^2))"},
      {"x^-y^2", "(x^(-(y^2)))"},
      {"--x", "(-(-x))"},
      {"x--y", "(x + (-(-y)))"},
      {"2*-x", "(2 * (-x))"},
      {"(a + b) + c", "((a + b) + c)"},
      {"a + (b + c)", "(a + (b + c))"},
      {"sin(x)^2", "(sin(x)^2)"},
      {"atan2(y, x)", "atan2(y, x)"},
      {"f()", "f()"},
      {"sum(i, 1, n, m[i])", "sum(i, 1, n, m[i])"},
      {"x(p[i-1])", "x(p[(i + (-1))])"},
      {"((x))", "x"},
      {"q [i]", "q[i]"},
      {"0.10", "0.1"},
  }));
  CHECK(expression_answer(row.input) == row.tree);
}

TEST_CASE("every node knows its span", "[parse]") {
  const SourcePointer source = make_source("test", " (a + b)^2 - sin( x )");
  const ExpressionSyntax sum = parsed(source);
  CHECK(covered_text(sum.span) == "(a + b)^2 - sin( x )");
  CHECK(covered_text(sum.token) == "-");
  const ExpressionSyntax& power = sum.operands.at(0);
  CHECK(covered_text(power.span) == "(a + b)^2");
  CHECK(covered_text(power.token) == "^");
  CHECK(covered_text(power.operands.at(0).span) == "(a + b)");
  CHECK(covered_text(power.operands.at(0).token) == "+");
  const ExpressionSyntax& negated = sum.operands.at(1);
  CHECK(covered_text(negated.span) == "- sin( x )");
  CHECK(covered_text(negated.operands.at(0).span) == "sin( x )");
  CHECK(covered_text(negated.operands.at(0).token) == "sin");
}

TEST_CASE("depth counts brackets, calls, indices, signs, powers and quotients", "[parse]") {
  struct Row {
    std::string opening;
    std::string middle;
    std::string closing;
    std::string past;  ///< code and place of the error at the fourth level
  };
  const auto row = GENERATE(values<Row>({
      {"(", "x", ")", "E902 1:4"},
      {"f(", "x", ")", "E902 1:8"},
      {"p[", "x", "]", "E902 1:8"},
      {"-", "x", "", "E902 1:4"},
      {"x^", "x", "", "E902 1:8"},
      {"", "x", "/x", "E902 1:8"},
  }));
  const auto nested = [&](std::size_t levels) {
    return repeated(row.opening, levels) + row.middle + repeated(row.closing, levels);
  };
  const std::string at_limit = expression_answer(nested(3), depth(3));
  CHECK(at_limit.substr(0, 4) != "E902");
  CHECK(expression_answer(nested(4), depth(3)) == row.past);
}

TEST_CASE("levels on both sides of a quotient add up", "[parse]") {
  CHECK(expression_answer("((x)/y/y)", depth(4)) != "E902 1:7");
  CHECK(expression_answer("((x)/y/y)", depth(3)) == "E902 1:7");
}

TEST_CASE("the default limit of depth is 200", "[parse]") {
  CHECK(expression_answer(repeated("(", 200) + "x" + repeated(")", 200)) == "x");
  CHECK(expression_answer(repeated("(", 201) + "x" + repeated(")", 201)) == "E902 1:201");
}

TEST_CASE("a raised limit is capped before the stack overflows", "[parse]") {
  const Limits limits = depth(1'000'000);
  const auto most = max_expression_depth;
  CHECK(expression_answer(repeated("(", most) + "x" + repeated(")", most), limits) == "x");
  CHECK(expression_answer(repeated("-f(", 100'000), limits) == "E902 1:1501");
}

TEST_CASE("a sum or a product of any length is one node", "[parse]") {
  const SourcePointer source = make_source("test", repeated("x - ", 99'999) + "x");
  CHECK(parsed(source).operands.size() == 100'000);
  const SourcePointer product = make_source("test", repeated("x*", 99'999) + "x");
  CHECK(parsed(product).operands.size() == 100'000);
}

TEST_CASE("a printed tree is parsed to the same tree", "[parse]") {
  CHECK(rc::check("print, parse", [] {
    const SourcePointer source = make_source("test", random_expression(5));
    const auto tree = parse_expression(source, {});
    RC_ASSERT(tree);
    const SourcePointer printed = make_source("test", dump(*tree));
    const auto again = parse_expression(printed, {});
    RC_ASSERT(again);
    RC_ASSERT(same_tree(*tree, *again));
  }));
}

TEST_CASE("random bytes give a tree or an error inside the text", "[parse]") {
  CHECK(rc::check("random bytes", [] {
    const auto characters =
        rc::gen::element<char>('x', '1', '.', 'e', '+', '-', '*', '/', '^', '(', ')', '[', ']', ',',
                               ' ', '\n', '=', '#', '\0', '\xCF', '\x80', '\xFF');
    const SourcePointer source = make_source("test", *rc::gen::container<std::string>(characters));
    const auto result = parse_expression(source, {});
    RC_ASSERT(result || result.diagnostics.size() == 1);
    for (const Diagnostic& d : result.diagnostics) {
      RC_ASSERT(d.span.begin <= d.span.end);
      RC_ASSERT(d.span.end <= source->text.size());
    }
  }));
}

TEST_CASE("a syntax error names the token found and suggests a correction", "[parse]") {
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
      {"1, 5", Code::E301, 1, "`,` outside the arguments of a function",
       "a list is written `[\"x(P)\", \"y(P)\"]`"},
      {"(x,y)", Code::E301, 2, "`,` outside the arguments of a function",
       "a list is written `[\"x(P)\", \"y(P)\"]`"},
      {"q[1,2]", Code::E306, 3, "`1,2` has a decimal comma", "write `1.2`"},
      {"q[1][2]", Code::E301, 4, "`[` after `]`", "a name takes one index: `q[i]`"},
      {"x)", Code::E304, 1, "`)` was never opened", ""},
      {"x]", Code::E304, 1, "`]` was never opened", ""},
      {"cart.x", Code::E308, 4, "`.x` is not a number", "write `x(cart)`"},
      {"2*theta.dot", Code::E308, 7, "`.dot` is not a number", "write `dot(theta)`"},
      {"bob.mass", Code::E308, 3, "`.mass` is not a number",
       "numbers are written `12`, `0.5` or `1e-3`"},
      {"", Code::E310, 0, "empty expression", "write `0` for nothing"},
      {"  \n", Code::E310, 0, "empty expression", "write `0` for nothing"},
  }));
  INFO(row.input);
  const Diagnostic error = expression_error(row.input);
  CHECK(error.code == row.code);
  CHECK(error.span.begin == row.begin);
  CHECK(error.message == row.message);
  CHECK(error.hint == row.hint);
}

TEST_CASE("a function without brackets gets them, also with a power", "[parse]") {
  const auto row = GENERATE(values<GrammarRow>({
      {"sin theta", Code::E303, 4, "`theta` follows `sin`", "write `sin(theta)`"},
      {"cos dot(x) + 1", Code::E303, 4, "`dot` follows `cos`", "write `cos(dot(x))`"},
      {"l*sin 2*theta", Code::E303, 6, "`2` follows `sin`", "write `sin(2*theta)`"},
      {"cos 2 q[1]", Code::E303, 4, "`2` follows `cos`", "write `cos(…)`"},
      {"sqrt 2", Code::E303, 5, "`2` follows `sqrt`", "write `sqrt(2)`"},
      {"ln x", Code::E303, 3, "`x` follows `ln`", "write `log(x)`"},
      {"tan p(x", Code::E303, 4, "`p` follows `tan`", "write `tan(…)`"},
      {"sin^2(theta)", Code::E303, 5, "`(` follows `2`", "write `sin(theta)^2`"},
      {"(m*tan^2 x)", Code::E303, 9, "`x` follows `2`", "write `tan(x)^2`"},
      {"cos^ 3 (x + y)", Code::E303, 7, "`(` follows `3`", "write `cos(x + y)^3`"},
      {"sin^-1(x)", Code::E303, 6, "`(` follows `1`",
       "write `sin(x)^-1`, or `asin(x)` for the inverse function"},
      {"exp^-1(x)", Code::E303, 6, "`(` follows `1`", "write `exp(x)^-1`"},
      {"x^2(y)", Code::E303, 3, "`(` follows `2`", "a product is written with `*`"},
  }));
  INFO(row.input);
  const Diagnostic error = expression_error(row.input);
  CHECK(error.code == row.code);
  CHECK(error.span.begin == row.begin);
  CHECK(error.message == row.message + " without an operator");
  CHECK(error.hint == row.hint);
}

TEST_CASE("a number with a unit gets a table, an angle in degrees a multiple of pi", "[parse]") {
  struct Row {
    std::string input;
    std::string hint;
  };
  const std::string table = "a unit belongs to a parameter: `{ value = ";
  const auto row = GENERATE_COPY(values<Row>({
      {"1.5 kg", table + "1.5, unit = \"kg\" }`"},
      {"-9.81m/s^2", table + "-9.81, unit = \"m/s^2\" }`"},
      {"3 m s^-2", table + "3, unit = \"m*s^-2\" }`"},
      {"2 N/(m*s)", table + "2, unit = \"N/(m*s)\" }`"},
      {"5 mm", table + "\"0.001*5\", unit = \"m\" }`"},
      {"60 rpm", table + "\"pi/30*60\", unit = \"rad/s\" }`"},
      {"9.81 m/s²", table + "9.81, unit = \"…\" }`"},
      {"5 km/h", table + "5, unit = \"…\" }`"},
      {"2 m*x", "write `2*m`"},
      {"2 m + 1", "write `2*m`"},
      {"90deg", "angles are in rad: write `pi/2`"},
      {"cos(-45 degrees)", "angles are in rad: write `pi/4`"},
      {"33.5 deg", "angles are in rad: write `67*pi/360`"},
      {"0 deg", "angles are in rad: write `0`"},
  }));
  INFO(row.input);
  const Diagnostic error = expression_error(row.input);
  CHECK(error.code == Code::E303);
  CHECK(error.hint == row.hint);
}

TEST_CASE("an unbalanced bracket is reported where it opened", "[parse]") {
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
  const Diagnostic error = expression_error(row.input);
  CHECK(error.code == Code::E304);
  CHECK(error.span.begin == row.begin);
  CHECK(error.message == row.message);
  REQUIRE(error.related);
  CHECK(error.related->begin == row.opened);
  CHECK(error.related_message == "opened here");
}

TEST_CASE("a decimal comma inside a call is parsed as one more argument", "[parse]") {
  CHECK(expression_answer("sin(1,5)") == "sin(1, 5)");
}
