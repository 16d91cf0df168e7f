// Pairs of expressions that are equal, and pairs that are not.
#include <catch2/catch.hpp>

#include "elgen/closed_forms.hpp"
#include "support/models.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

struct Pair {
  const char* left;
  const char* right;
};

CheckedModel model_of(const Pair& pair) {
  return checked_model(
      model_text("pair",
                 "[[coordinate]]\nname = \"x\"\n[[coordinate]]\nname = \"y\"\n"
                 "[parameters]\na = 2\nb = 3\n[define]\nboth = \"x + y\"\n"
                 "[energy]\nT = \"1/2*dot(x)^2 + 1/2*dot(y)^2\"\n[[output]]\nname = \"pair\"\n"
                 "value = [\"" +
                     std::string(pair.left) + "\", \"" + pair.right + "\"]\n"));
}

bool is_proved(const Pair& pair) {
  const Model model = model_of(pair).model;
  ClosedForms forms;
  const auto left = closed_form(forms, model, {}, model.outputs[0].values[0]);
  const auto right = closed_form(forms, model, {}, model.outputs[0].values[1]);
  REQUIRE(left);
  REQUIRE(right);
  return is_proved_equal(forms, *left, *right);
}

}  // namespace

TEST_CASE("identities are proved") {
  const std::vector<Pair> identities{
      {"sin(x)^2 + cos(x)^2", "1"},
      {"sin(2*x)", "2*sin(x)*cos(x)"},
      {"cos(x + y)", "cos(x)*cos(y) - sin(x)*sin(y)"},
      {"sin(x - y)", "-sin(y - x)"},
      {"sin(x/2)^2", "(1 - cos(x))/2"},
      {"cos(3*x)", "4*cos(x)^3 - 3*cos(x)"},
      {"tan(x)*cos(x)", "sin(x)"},
      {"1 + tan(x)^2", "1/cos(x)^2"},
      {"cos(pi/4 + x)", "sqrt(2)/2*(cos(x) - sin(x))"},
      {"cos(x + pi/2)", "-sin(x)"},
      {"sin(x + 2*pi)", "sin(x)"},
      {"cos(pi/12)", "(sqrt(6) + sqrt(2))/4"},
      {"sin(both)", "sin(x)*cos(y) + cos(x)*sin(y)"},
      {"sin(a*x)^2", "1 - cos(a*x)^2"},
      {"sin(x*y)^2", "1 - cos(x*y)^2"},
      {"sin(x/(1 + x^2))^2", "1 - cos(x/(1 + x^2))^2"},
      {"1/(a + b) + 1/(a - b)", "2*a/(a^2 - b^2)"},
      {"(a^2 - b^2)/(a - b)", "a + b"},
      {"1/(1/a + 1/b)", "a*b/(a + b)"},
      {"x/a + y/a", "(x + y)/a"},
      {"sin(x)/(1 - cos(x)^2)", "1/sin(x)"},
      {"sqrt(8)", "2*sqrt(2)"},
      {"sqrt(3/4)", "sqrt(3)/2"},
      {"sqrt(1 - x^2)^3", "(1 - x^2)*sqrt(1 - x^2)"},
      {"1/sqrt(1 - x^2)", "sqrt(1 - x^2)/(1 - x^2)"},
      {"(1 - x^2)^(3/2)", "(1 - x^2)*sqrt(1 - x^2)"},
      {"sinh(-x)", "-sinh(x)"},
      {"cosh(x - y)", "cosh(y - x)"},
      {"exp(x)*exp(x)", "exp(x)^2"},
      {"atan2(x, y) - atan2(x, y)", "0"},
  };
  for (const Pair& pair : identities) {
    INFO(pair.left << " = " << pair.right);
    CHECK(is_proved(pair));
  }
}

TEST_CASE("different expressions are never proved equal") {
  const std::vector<Pair> differences{
      {"sin(x)", "cos(x)"},
      {"sin(x)^2 - cos(x)^2", "1"},
      {"cos(x + y)", "cos(x - y)"},
      {"1/(a + b)", "1/a + 1/b"},
      {"sqrt(x^2)", "x"},
      {"cos(x/3)", "cos(x)"},
      {"sin(x)", "x"},
      {"cos(3/10)", "cos(3/10 + x)"},
      {"exp(x)", "exp(-x)"},
      {"sinh(x)", "sin(x)"},
      {"a", "b"},
      {"x^2", "x^3"},
  };
  for (const Pair& pair : differences) {
    INFO(pair.left << " and " << pair.right);
    CHECK_FALSE(is_proved(pair));
  }
}

TEST_CASE("fixed parameters are numbers") {
  const Model model = model_of({"a*x", "5*x"}).model;
  ClosedForms forms;
  const FixedParameters fixed{{0, {5}}};
  const auto left = closed_form(forms, model, fixed, model.outputs[0].values[0]);
  const auto right = closed_form(forms, model, fixed, model.outputs[0].values[1]);
  REQUIRE(left);
  CHECK(is_proved_equal(forms, *left, *right));
}

TEST_CASE("a form beyond the budget is abandoned, not approximated") {
  const Model model = model_of({"(1 + x + y + a + b)^60", "1"}).model;
  ClosedForms forms;
  CHECK_FALSE(closed_form(forms, model, {}, model.outputs[0].values[0]));
}
