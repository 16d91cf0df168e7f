// Constants: their forms, formulas, reading back, and values.
#include <catch2/catch.hpp>
#include <cmath>

#include "elgen/constant.hpp"
#include "elgen/evaluate.hpp"
#include "elgen/formula.hpp"
#include "formula/glyphs.hpp"
#include "numbers/enclosed_number.hpp"
#include "support/graph_reader.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

const ConstantForm pi{.kind = ConstantKind::pi, .operands = {}};

ConstantForm sum(std::vector<ConstantOperand> terms) {
  return {.kind = ConstantKind::sum, .operands = std::move(terms)};
}

ConstantForm product(std::vector<ConstantOperand> factors) {
  return {.kind = ConstantKind::product, .operands = std::move(factors)};
}

ConstantForm call(FunctionId function, ConstantForm argument, std::int32_t sign = 1) {
  return {
      .kind = ConstantKind::call, .function = function, .operands = {{std::move(argument), sign}}};
}

ConstantForm number(const char* text) { return rational_form(cln::cl_RA(text)); }

double value(const std::string& text) {
  const auto constant = read_constant(text);
  REQUIRE(constant);
  return to_double(constant->value);
}

}  // namespace

TEST_CASE("forms are printed with the brackets that they need") {
  const ConstantForm cosine = call(FunctionId::cos, number("1"));
  CHECK(text_of(sum({{number("1"), 1}, {cosine, -1}})) == "1 - cos(1)");
  CHECK(text_of(sum({{number("1"), 1}, {sum({{number("2"), 1}, {pi, 1}}), -1}})) == "1 - (2 + pi)");
  CHECK(text_of(sum({{cosine, -1}, {pi, 1}})) == "-cos(1) + pi");
  CHECK(text_of(product({{number("1/2"), 1}, {pi, 1}})) == "1/2*pi");
  CHECK(text_of(product({{number("-1/2"), 1}, {pi, 1}})) == "-1/2*pi");
  CHECK(text_of(product({{sum({{number("1"), 1}, {pi, 1}}), 2}, {pi, -1}})) ==
        "(1 + pi)^2*pi^(-1)");
  CHECK(text_of(product({{sum({{number("1"), 1}, {pi, 1}}), 1}, {pi, 1}})) == "(1 + pi)*pi");
  CHECK(text_of(call(FunctionId::exp, sum({{number("1"), 1}, {cosine, 1}}), -1)) ==
        "exp(-1 - cos(1))");
  CHECK(text_of(call(FunctionId::log, number("1/2"))) == "log(1/2)");
}

TEST_CASE("a sign moves into a form and back") {
  const ConstantForm difference = sum({{number("1"), 1}, {pi, -1}});
  CHECK(text_of(negated_form(difference)) == "-1 + pi");
  CHECK(negated_form(negated_form(difference)) == difference);
  CHECK(text_of(negated_form(product({{number("1/2"), 1}, {pi, 1}}))) == "-1/2*pi");
  CHECK(text_of(negated_form(product({{pi, 1}, {difference, 1}}))) == "pi*(-1 + pi)");
  CHECK(text_of(negated_form(product({{pi, 1}, {difference, 2}}))) == "-pi*(1 - pi)^2");
  CHECK(text_of(negated_form(call(FunctionId::log, number("1/2")))) == "-log(1/2)");
  CHECK(negated_form(negated_form(pi)) == pi);
}

TEST_CASE("the text of a form is read back to the same form and value") {
  for (const char* text :
       {"1-cos(1)", "2+pi", "2*pi", "exp(-1-cos(1))", "exp(-1+cos(1))", "(1+pi)^2*pi^(-1)",
        "-log(1/2)", "sqrt(2+sqrt(3))", "atan2(-1,-pi)", "1/2*sqrt(3)"}) {
    const auto constant = read_constant(text);
    REQUIRE(constant);
    const auto again = read_constant(text_of(constant->form));
    REQUIRE(again);
    CHECK(again->form == constant->form);
    CHECK(again->value == constant->value);
  }
}

TEST_CASE("constants are found by form, never by value") {
  std::vector<Constant> constants;
  CHECK(intern_constant(rational_constant(2), constants) == 0);
  const auto root = read_constant("sqrt(2)");
  const auto power = read_constant("sqrt(2)^(-1)*2");
  REQUIRE(root);
  REQUIRE(power);
  CHECK(intern_constant(*root, constants) == 1);
  CHECK(intern_constant(*power, constants) == 2);
  CHECK(intern_constant(*root, constants) == 1);
  CHECK(constants.size() == 3);
}

TEST_CASE("exact constants are printed in both notations") {
  struct Notations {
    const char* text;
    const char* latex;
  };
  const Notations row =
      GENERATE(values<Notations>({{"1/2", "\\frac{1}{2}"},
                                  {"981/100", "9.81"},
                                  {"200000000000000000/3", "\\frac{200000000000000000}{3}"},
                                  {"sqrt(2)", "\\sqrt{2}"},
                                  {"pi", "\\pi"},
                                  {"1/2*pi", "\\frac{1}{2} \\pi"},
                                  {"1 - cos(1)", "1 - \\cos 1"},
                                  {"2*(1 + pi)^2", "2 (1 + \\pi)^{2}"},
                                  {"sqrt(3)^(-1)", "\\frac{1}{\\sqrt{3}}"},
                                  {"exp(-1 - pi)", "\\exp(-1 - \\pi)"}}));
  const auto constant = read_constant(row.text);
  REQUIRE(constant);
  CHECK(text_of(constant_formula(constant->form)) == row.text);
  CHECK(to_latex(glyphs_of(constant_formula(constant->form))) == row.latex);
}

TEST_CASE("a constant sum is bracketed as a factor") {
  const auto sum = read_constant("1 + pi");
  REQUIRE(sum);
  CHECK(text_of(product_of({constant_formula(sum->form), name_formula("x")})) == "(1 + pi)*x");
}

TEST_CASE("constants are read in the form that the graph gives them") {
  struct Row {
    const char* text;
    const char* form;
  };
  const Row row = GENERATE(values<Row>({{"pi*1/2", "1/2*pi"},
                                        {"2/4", "1/2"},
                                        {"exp(1)+cos(1)-1", "-1 + cos(1) + exp(1)"},
                                        {"-log(1/2)", "-log(1/2)"},
                                        {"sqrt(8)/2", "1/2*sqrt(8)"},
                                        {"sqrt(9/4)", "3/2"}}));
  const auto constant = read_constant(row.text);
  REQUIRE(constant);
  CHECK(text_of(constant->form) == row.form);
}

TEST_CASE("expressions that are not constants are rejected") {
  CHECK_FALSE(read_constant("x"));
  CHECK_FALSE(read_constant("1/0"));
  CHECK_FALSE(read_constant("2^pi"));
  CHECK_FALSE(read_constant("sin(1"));
  CHECK_FALSE(read_constant("cos(1, 2)"));
}

TEST_CASE("calls have the values of the C library") {
  // libm is not correctly rounded.
  const auto close = [](double x) {
    return Approx(x).epsilon(4 * std::numeric_limits<double>::epsilon());
  };
  const double x = 0.3;
  const std::pair<const char*, double> rows[] = {
      {"sin(3/10)", std::sin(x)},
      {"cos(3/10)", std::cos(x)},
      {"tan(3/10)", std::tan(x)},
      {"asin(3/10)", std::asin(x)},
      {"acos(3/10)", std::acos(x)},
      {"acos(-1)", std::acos(-1.0)},
      {"atan(3/10)", std::atan(x)},
      {"sinh(3/10)", std::sinh(x)},
      {"cosh(3/10)", std::cosh(x)},
      {"tanh(3/10)", std::tanh(x)},
      {"exp(3/10)", std::exp(x)},
      {"log(3/10)", std::log(x)},
      {"atan2(1,-2)", std::atan2(1.0, -2.0)},
      {"sqrt(2)*pi^(-1)", std::sqrt(2.0) / std::acos(-1.0)}};
  for (const auto& [text, expected] : rows) {
    INFO(text);
    CHECK(value(text) == close(expected));
  }
}

TEST_CASE("200 correct digits despite cancellation") {
  // The angle of sin(10^30) needs 30 more digits; 1 - cos(1e-60) loses 120 digits.
  for (const char* text : {"sin(1000000000000000000000000000000)",
                           "1-cos(1/1000000000000000000000000000000000000000000000000000000000000)",
                           "exp(1)*pi-tan(7/5)"}) {
    const auto constant = read_constant(text);
    REQUIRE(constant);
    const auto enclosure = enclosed_value(constant->form);
    REQUIRE(enclosure);
    CHECK(enclosure->error <= cln::abs(enclosure->value) * cln::expt(cln::cl_RA(10), -200));
    CHECK(sign_of(*enclosure).has_value());
  }
}

TEST_CASE("a sum that cancels has an unknown sign, an exact zero has sign 0") {
  const auto noise = read_constant("sqrt(2)*sqrt(3)-sqrt(6)");
  REQUIRE(noise);
  CHECK(cln::zerop(noise->value));
  CHECK_FALSE(sign_of(*enclosed_value(noise->form)));
  CHECK(noise->form.kind == ConstantKind::sum);
  CHECK(sign_of(*enclosed_value(rational_form(0))) == 0);
}

TEST_CASE("constants without a real value have none") {
  CHECK_FALSE(enclosed_value(call(FunctionId::log, number("0"))));
  CHECK_FALSE(enclosed_value(call(FunctionId::log, number("-1"))));
  CHECK_FALSE(enclosed_value(call(FunctionId::asin, number("2"))));
  CHECK_FALSE(enclosed_value(call(FunctionId::acos, number("-2"))));
  CHECK_FALSE(enclosed_value(call(FunctionId::exp, number("1000000"))));
  CHECK_FALSE(read_constant("sqrt(-2)"));
  CHECK_FALSE(read_constant("(sqrt(2)*sqrt(3)-sqrt(6))^(-1)"));
}
