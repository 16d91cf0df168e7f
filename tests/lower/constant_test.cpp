#include "elgen/constant.hpp"

#include <catch2/catch.hpp>

#include "support/constant_reader.hpp"

using namespace elgen;

namespace {

const ConstantForm pi{.kind = ConstantKind::pi, .parts = {}};

ConstantForm sum(std::vector<ConstantPart> terms) {
  return {.kind = ConstantKind::sum, .parts = std::move(terms)};
}

ConstantForm product(std::vector<ConstantPart> factors) {
  return {.kind = ConstantKind::product, .parts = std::move(factors)};
}

ConstantForm call(FunctionId function, ConstantForm argument, std::int32_t sign = 1) {
  return {.kind = ConstantKind::call, .function = function, .parts = {{std::move(argument), sign}}};
}

ConstantForm number(const char* text) { return rational_form(cln::cl_RA(text)); }

}  // namespace

TEST_CASE("forms are written with the brackets that they need") {
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

TEST_CASE("a sign moves inside, and back again") {
  const ConstantForm difference = sum({{number("1"), 1}, {pi, -1}});
  CHECK(text_of(negated(difference)) == "-1 + pi");
  CHECK(negated(negated(difference)) == difference);
  CHECK(text_of(negated(product({{number("1/2"), 1}, {pi, 1}}))) == "-1/2*pi");
  CHECK(text_of(negated(product({{pi, 1}, {difference, 1}}))) == "pi*(-1 + pi)");
  CHECK(text_of(negated(product({{pi, 1}, {difference, 2}}))) == "-pi*(1 - pi)^2");
  CHECK(text_of(negated(call(FunctionId::log, number("1/2")))) == "-log(1/2)");
  CHECK(negated(negated(pi)) == pi);
}

TEST_CASE("what forms say is what they are worth") {
  for (const char* text :
       {"1-cos(1)", "2+pi", "2*pi", "exp(-1-cos(1))", "exp(-1+cos(1))", "(1+pi)^2*pi^(-1)",
        "-log(1/2)", "sqrt(2+sqrt(3))", "atan2(-1,-pi)", "1/2*sqrt(3)"}) {
    const auto constant = test::read_constant(text);
    REQUIRE(constant);
    const auto again = test::read_constant(text_of(constant->form));
    REQUIRE(again);
    CHECK(again->form == constant->form);
    CHECK(again->value == constant->value);
  }
}

TEST_CASE("constants are found by form, never by value") {
  std::vector<Constant> constants;
  CHECK(position_of(rational_constant(2), constants) == 0);
  const auto root = test::read_constant("sqrt(2)");
  const auto power = test::read_constant("sqrt(2)^(-1)*2");
  REQUIRE(root);
  REQUIRE(power);
  CHECK(position_of(*root, constants) == 1);
  CHECK(position_of(*power, constants) == 2);
  CHECK(position_of(*root, constants) == 1);
  CHECK(constants.size() == 3);
}
