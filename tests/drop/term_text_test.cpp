// Terms in the model language.
#include "drop/term_text.hpp"

#include <catch2/catch.hpp>

#include "support/models.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

std::string text_of(const std::string& expression) {
  const Model model = checked_model(model_text("line", R"toml([[coordinate]]
name = "x"
[[coordinate]]
name = "y"
[parameters]
m = 2
k = 3
[energy]
T = "1/2*m*(dot(x)^2 + dot(y)^2)"
[[expect]]
potential_energy = ")toml" + expression + "\"\n"))
                          .model;
  ClosedForms forms;
  const auto form = closed_form(forms, model, {}, model.expectations[0].entries[0]);
  return term_text(forms.algebra, leaf_names(model), form.value());
}

}  // namespace

TEST_CASE("products of leaves, sines and cosines") {
  CHECK(text_of("0*x") == "0");
  CHECK(text_of("3") == "3");
  CHECK(text_of("-x*m") == "-m*x");
  CHECK(text_of("k*m^2*dot(x)*cos(x - 2*y)/4") == "0.25*m^2*k*dot(x)*cos(x - 2*y)");
  CHECK(text_of("m*sin(x)^2") == "0.5*m - 0.5*m*cos(2*x)");
  CHECK(text_of("2*m/(k*x^2)") == "2*m/k/x^2");
}

TEST_CASE("roots, functions and denominators") {
  CHECK(text_of("sqrt(m + k)*x") == "x*sqrt(m + k)");
  CHECK(text_of("atan2(x, m)") == "atan2(x, m)");
  CHECK(text_of("t*pi") == "t*pi");
  CHECK(text_of("x/(m + k)") == "(x)/(m + k)");
}
