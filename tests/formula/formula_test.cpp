// Formulas: brackets, LaTeX, numbers and words. The text of any nesting of operations must have the
// value of the tree.
#include "elgen/formula.hpp"

#include <catch2/catch.hpp>

#include "formula/drawing.hpp"
#include "formula/formula_text.hpp"
#include "formula/written_values.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

using Texts = std::vector<std::string>;

Formula symbol(const std::string& name) { return symbol_formula(name, read_latex(name)); }

const Formula a = symbol("a");
const Formula b = symbol("b");
const Formula c = symbol("c");
const Formula two = number_formula(2);

std::string latex_of(const Formula& formula) { return to_latex(glyphs_of(formula)); }

Formula number(const char* text) { return number_formula(cln::cl_RA(text)); }

/// An operation with the operand x. The other operand is y, if the operation has two.
struct Nesting {
  const char* name;
  Formula (*build)(const Formula& x, const Formula& y);
};

const std::vector<Nesting> nestings{
    {"x + y",
     [](const Formula& x, const Formula& y) {
       return sum_of({x, y});
     }},
    {"y + x",
     [](const Formula& x, const Formula& y) {
       return sum_of({y, x});
     }},
    {"x - y",
     [](const Formula& x, const Formula& y) {
       return sum_of({x, negative_of(y)});
     }},
    {"y - x",
     [](const Formula& x, const Formula& y) {
       return sum_of({y, negative_of(x)});
     }},
    {"-x", [](const Formula& x, const Formula&) { return negative_of(x); }},
    {"x y",
     [](const Formula& x, const Formula& y) {
       return product_of({x, y});
     }},
    {"y x",
     [](const Formula& x, const Formula& y) {
       return product_of({y, x});
     }},
    {"x/y", [](const Formula& x, const Formula& y) { return quotient_of(x, y); }},
    {"y/x", [](const Formula& x, const Formula& y) { return quotient_of(y, x); }},
    {"x^y", [](const Formula& x, const Formula& y) { return power_of(x, y); }},
    {"y^x", [](const Formula& x, const Formula& y) { return power_of(y, x); }},
    {"x^2", [](const Formula& x, const Formula&) { return power_of(x, two); }},
    {"x^-1", [](const Formula& x, const Formula&) { return power_of(x, number("-1")); }},
    {"y x^-1",
     [](const Formula& x, const Formula& y) {
       return product_of({y, power_of(x, number("-1"))});
     }},
    {"sqrt x", [](const Formula& x, const Formula&) { return root_of(x); }},
    {"sin x", [](const Formula& x, const Formula&) { return call_of(FunctionId::sin, {x}); }},
};

/// Every operation applied to a and b, and numbers.
Formulas operations_and_numbers() {
  Formulas all{a, two, number("2/3"), number("-2"), number("-2/3"), digits_formula("2.5e-03")};
  for (const Nesting& place : nestings) all.push_back(place.build(a, b));
  return all;
}

/// True if x and y agree to 1e-10; a missing bracket changes the first digits.
bool is_near(const Value& x, const Value& y) {
  return std::abs(x - y) <= 1e-10 * std::max(1.0, std::abs(x));
}

/// A message for each notation of `formula` with another value than the tree, or with no value.
Texts wrong_notations(const Formula& formula) {
  const Value value = value_of_tree(formula);
  const std::string text = text_of(formula);
  const TextBlock drawn = draw_glyphs(glyphs_of(formula), Alphabet::ascii, FractionStyle::in_line);
  Texts wrong;
  const auto expect = [&](const std::string& printed, const auto& value_of) {
    try {
      if (is_near(value, value_of(printed))) return;
      wrong.push_back(text + " is printed as " + printed);
    } catch (const std::invalid_argument& problem) {
      wrong.push_back(text + " is printed as " + printed + ": " + problem.what());
    }
  };
  expect(text, value_of_text);
  expect(latex_of(formula), value_of_line);
  expect(drawn.lines[drawn.base], value_of_line);
  return wrong;
}

}  // namespace

TEST_CASE("brackets are printed only if precedence requires them, in the model language") {
  const OperatorSpelling& n = model_spelling;
  const FormulaText x{"a"};
  const FormulaText y{"b"};
  const FormulaText z{"c"};
  CHECK(sum_text({{x}, {sum_text({{y}, {z, true}})}}).text == "a + (b - c)");
  CHECK(sum_text({{sum_text({{x}, {y}})}, {z}}).text == "a + b + c");
  CHECK(product_text(n, {sum_text({{x}, {y}}), power_text(z, {"2"})}).text == "(a + b)*c^2");
  CHECK(quotient_text(n, x, product_text(n, {y, z})).text == "a/(b*c)");
  CHECK(negation_text(sum_text({{x}, {y}})).text == "-(a + b)");
  CHECK(named_call_text("sqrt", {sum_text({{x}, {y}})}).text == "sqrt(a + b)");
  CHECK(power_text(named_call_text("sin", {x}), {"2"}).text == "sin(a)^2");
}

TEST_CASE("nested trees follow the same rules, with brackets around nested sums") {
  CHECK(text_of(sum_of({a, sum_of({b, negative_of(c)})})) == "a + (b - c)");
  CHECK(text_of(sum_of({sum_of({a, b}), c})) == "(a + b) + c");
  CHECK(text_of(product_of({sum_of({a, b}), power_of(c, two)})) == "(a + b)*c^2");
  CHECK(text_of(quotient_of(a, product_of({b, c}))) == "a/(b*c)");
  CHECK(text_of(negative_of(sum_of({a, b}))) == "-(a + b)");
  CHECK(text_of(root_of(sum_of({a, b}))) == "sqrt(a + b)");
  CHECK(text_of(power_of(call_of(FunctionId::sin, {a}), two)) == "sin(a)^2");
}

TEST_CASE("LaTeX stacks fractions and puts exponents on functions") {
  CHECK(latex_of(quotient_of(sum_of({a, b}), c)) == "\\frac{a + b}{c}");
  CHECK(latex_of(power_of(call_of(FunctionId::sin, {a}), two)) == "\\sin^{2} a");
  CHECK(latex_of(call_of(FunctionId::cos, {sum_of({a, b})})) == "\\cos(a + b)");
  CHECK(latex_of(root_of(a)) == "\\sqrt{a}");
}

TEST_CASE("in LaTeX functions come last, so that no factor is read as part of an argument") {
  const Formula sine = call_of(FunctionId::sin, {a});
  CHECK(latex_of(product_of({sine, sum_of({b, c}), c})) == "(b + c) c \\sin a");
  CHECK(latex_of(product_of({two, sine, sine})) == "2 \\sin a \\sin a");
  CHECK(latex_of(product_of({sine, negative_of(b)})) == "-b \\sin a");
  CHECK(text_of(product_of({sine, b})) == "sin(a)*b");
  CHECK(product_text(code_spelling, {named_call_text("sin", {{"a"}}), {"b"}}).text == "sin(a) * b");
}

TEST_CASE("log1p, expm1, hypot and Stumpff functions are printed in mathematical notation") {
  const auto call = [](FunctionId function, Formulas arguments) {
    return call_of(function, std::move(arguments));
  };
  CHECK(latex_of(call(FunctionId::log1p, {a})) == "\\ln(1 + a)");
  CHECK(latex_of(call(FunctionId::expm1, {sum_of({a, b})})) == "\\exp(a + b) - 1");
  CHECK(latex_of(call(FunctionId::hypot, {a, sum_of({b, c})})) == "\\sqrt{a^{2} + (b + c)^{2}}");
  CHECK(latex_of(call(FunctionId::stumpff, {a, number("1")})) == "\\mathrm{sinc}(a)");
  CHECK(latex_of(call(FunctionId::stumpff, {a, number("3")})) == "\\mathrm{stumpff}(a, 3)");
  CHECK(latex_of(call(FunctionId::stumpff, {a, number("-1")})) == "\\mathrm{stumpff}(a, -1)");
  CHECK(latex_of(power_of(call(FunctionId::stumpff, {a, two}), two)) == "\\mathrm{cosc}^{2}(a)");
  CHECK(latex_of(call(FunctionId::sign, {a})) == "\\mathrm{sgn}(a)");
  CHECK(text_of(call(FunctionId::hypot, {a, b})) == "hypot(a, b)");
  CHECK(text_of(call(FunctionId::stumpff, {a, two})) == "cosc(a)");
}

TEST_CASE("only a leading sign has no brackets") {
  const OperatorSpelling& n = code_spelling;
  const FormulaText x{"a"};
  const FormulaText y{"b"};
  CHECK(product_text(n, {negation_text(x), y}).text == "-a * b");
  CHECK(negation_text(product_text(n, {x, y})).text == "-a * b");
  CHECK(product_text(n, {x, negation_text(y)}).text == "a * (-b)");
  CHECK(sum_text({{{"c"}}, {negation_text(product_text(n, {x, y})), true}}).text == "c - (-a * b)");
  CHECK(negation_text(negation_text(x)).text == "-(-a)");
}

TEST_CASE("numbers are exact") {
  CHECK(text_of(number("-981/100")) == "-981/100");
  for (const auto& [value, expected] :
       std::vector<std::pair<const char*, const char*>>{{"981/100", "9.81"},
                                                        {"1/2", "\\frac{1}{2}"},
                                                        {"2/5", "\\frac{2}{5}"},
                                                        {"17/20", "0.85"},
                                                        {"1/120", "\\frac{1}{120}"}}) {
    CHECK(latex_of(number(value)) == expected);
  }
}

TEST_CASE("relations, lists, words and signs") {
  struct Row {
    Formula formula;
    std::string text, latex;
  };
  const std::vector<Row> rows{
      {relation(a, sum_of({b, c})), "a = b + c", "a = b + c"},
      {tuple_of({a, negative_of(b)}), "(a, -b)", "(a, -b)"},
      {enumeration({a}), "a", "a"},
      {enumeration({a, b}), "a and b", "a \\text{ and } b"},
      {enumeration({a, b, c}), "a, b and c", "a, b \\text{ and } c"},
      {row_of({a, prose("; then"), b}), "a; then b", "a \\text{; then } b"},
      {row_of({prose("at"), {}, a, prose("")}), "at a", "\\text{at } a"},
      {plus_minus(sum_of({a, b})), "+-(a + b)", "\\pm (a + b)"},
      {absolute_value_of(sum_of({a, b})), "|a + b|", "\\left| a + b \\right|"},
      {product_of({group(negative_of(a)), b}), "(-a)*b", "(-a) b"},
      {digits_formula("-1.5e-07"), "-1.5e-07", "-1.5 \\cdot 10^{-7}"},
      {latex_formula("\\ddot{<q>}_{1}"), "ddot(q1)", "\\ddot{\\mathbf{q}}_{1}"},
      {power_of(symbol_formula("V", read_latex("V(r)"), true), two), "V^2", "(V(r))^{2}"},
      {power_of(symbol_formula("x", read_latex("x^{*}")), two), "x^2", "{x^{*}}^{2}"},
      {product_of({symbol_formula("m", read_latex("\\mathrm{mass}")), a, power_of(two, a)}),
       "m*a*2^a", "\\mathrm{mass} \\cdot a \\cdot 2^{a}"}};
  for (const Row& row : rows) {
    CHECK(text_of(row.formula) == row.text);
    CHECK(latex_of(row.formula) == row.latex);
    CHECK(to_latex(read_latex(row.latex)) == row.latex);
  }
  CHECK(row_of({{}, prose("")}).is_empty());
}

TEST_CASE("lines are parsed as people read them") {
  for (const auto& [line, text] : std::vector<std::pair<const char*, const char*>>{
           {"c \\sin^{2} a b", "c*sin(a*b)^2"},
           {"\\sin(a + b) c", "sin(a + b)*c"},
           {"2 \\sin a \\sin b", "2*sin(a)*sin(b)"},
           {"-\\frac{1}{2} a^{b}", "-(1/2*a^b)"},
           {"\\left( a - b \\right)^{-1} \\cdot 1.5", "1.5/(a - b)"},
           {"sqrt(a) - c/a b", "sqrt(a) - c/a*b"},
           {"sin^2 a/b + a^(b + c)", "sin(a)^2/b + a^(b + c)"}}) {
    INFO(line);
    CHECK(is_near(value_of_line(line), value_of_text(text)));
  }
  for (const char* const line : {"", "a +", "a^{b}^{c}", "\\frac{a}", "(a", "d", "a)"}) {
    INFO(line);
    CHECK_THROWS_AS(value_of_line(line), std::invalid_argument);
  }
}

TEST_CASE("a nested operation has the value of the tree in text, LaTeX and ASCII") {
  Texts wrong;
  for (const Formula& inner : operations_and_numbers()) {
    for (const Nesting& outer : nestings) {
      const Formula formula = outer.build(inner, c);
      for (const std::string& notation : wrong_notations(formula)) wrong.push_back(notation);
      CHECK(to_latex(read_latex(latex_of(formula))) == latex_of(formula));
    }
  }
  CHECK(wrong == Texts{});
}

TEST_CASE("a doubly nested operation has the value of the tree, too") {
  Texts wrong;
  for (const Formula& inner : operations_and_numbers()) {
    for (const Nesting& middle : nestings) {
      const Formula both = middle.build(inner, c);
      for (const Nesting& outer : nestings) {
        const Formula formula = outer.build(both, a);
        for (const std::string& notation : wrong_notations(formula)) wrong.push_back(notation);
      }
    }
  }
  CHECK(wrong == Texts{});
}
