// The trees of expressions: precedence, chains, places, depth, and print -> parse -> the same tree.
#include "parse/expression_parser.hpp"

#include <rapidcheck.h>

#include <catch2/catch.hpp>

#include "parse_testing.hpp"

using namespace elgen;
using testing::expression_answer;
using testing::repeated;

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

/// Random text of the grammar.
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
      {"x(p[i-1])", "x(p[(i + (-1))])"},
      {"((x))", "x"},
      {"q [i]", "q[i]"},
      {"0.10", "0.1"},
  }));
  CHECK(expression_answer(row.input) == row.tree);
}

TEST_CASE("every node knows its place", "[parse]") {
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
    std::string past;  ///< where the fourth level is noticed
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

TEST_CASE("levels on both sides of a quotient are counted together", "[parse]") {
  CHECK(expression_answer("((x)/y/y)", depth(4)) != "E902 1:7");
  CHECK(expression_answer("((x)/y/y)", depth(3)) == "E902 1:7");
}

TEST_CASE("the default depth holds at 200", "[parse]") {
  CHECK(expression_answer(repeated("(", 200) + "x" + repeated(")", 200)) == "x");
  CHECK(expression_answer(repeated("(", 201) + "x" + repeated(")", 201)) == "E902 1:201");
}

TEST_CASE("a raised limit ends before the stack does", "[parse]") {
  const Limits limits = depth(1'000'000);
  const auto most = deepest_expression;
  CHECK(expression_answer(repeated("(", most) + "x" + repeated(")", most), limits) == "x");
  CHECK(expression_answer(repeated("-f(", 100'000), limits) == "E902 1:1501");
}

TEST_CASE("sums and products of any length are one node", "[parse]") {
  const SourcePointer source = make_source("test", repeated("x - ", 99'999) + "x");
  CHECK(parsed(source).operands.size() == 100'000);
  const SourcePointer product = make_source("test", repeated("x*", 99'999) + "x");
  CHECK(parsed(product).operands.size() == 100'000);
}

TEST_CASE("print, parse: the same tree", "[parse]") {
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

TEST_CASE("random bytes are answered with a tree or an error inside them", "[parse]") {
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
