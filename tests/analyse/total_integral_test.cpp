// Total integrals: functions F with dF/dt equal to a given form; forms that are no total
// derivative; and forms whose integral is not found.
#include "analyse/total_integral.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "support/models.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// Parses formulas over x, y, their rates, t, k and w, and an open function V(x, t).
class PlaneForms {
 public:
  Fraction operator()(const std::string& formula) {
    model_ = checked_model(model_text("plane", R"toml([[coordinate]]
name = "x"
range = [0.5, 2]
[[coordinate]]
name = "y"
[parameters]
k = 2
w = 3
[[function]]
name = "V"
of = ["x", "t"]
[energy]
T = "1/2*k*dot(x)^2 + 1/2*w*dot(y)^2"
V = "V"
[[expect]]
conserved = [")toml" + formula + "\"]\n"))
                 .model;
    INFO(formula);
    const std::optional<Fraction> form =
        closed_form(forms_, model_, {}, model_.expectations[0].entries[0]);
    REQUIRE(form);
    return *form;
  }

  std::optional<Fraction> integral(const std::string& rate) {
    const Fraction form = (*this)(rate);
    return integrate_total_derivative(forms_, model_, {}, open_value_rates(forms_, model_, {}),
                                      form);
  }

  bool equal(const Fraction& x, const Fraction& y) { return is_proved_equal(forms_, x, y); }

 private:
  Model model_ = {};
  ClosedForms forms_ = {};
};

void check_integral(const std::string& rate, const std::string& expected) {
  PlaneForms forms;
  INFO(rate << " is the rate of " << expected);
  const std::optional<Fraction> found = forms.integral(rate);
  REQUIRE(found);
  CHECK(forms.equal(*found, forms(expected)));
}

void check_no_integral(const std::string& rate) {
  INFO(rate);
  CHECK_FALSE(PlaneForms().integral(rate));
}

}  // namespace

TEST_CASE("powers have integrals, one variable after another") {
  check_integral("0", "0");
  check_integral("k", "k*t");
  check_integral("dot(x)", "x");
  check_integral("k*x^3*dot(x)", "k*x^4/4");
  check_integral("dot(x)/x^2", "-1/x");
  check_integral("w*t^2", "w*t^3/3");
  check_integral("x*dot(y) + y*dot(x)", "x*y");
  check_integral("t*dot(x) + x", "t*x");
  check_integral("2*t*x^2*y + 2*t^2*x*y*dot(x) + t^2*x^2*dot(y)", "t^2*x^2*y");
  check_integral("dot(x)/(1 + k)", "x/(1 + k)");
}

TEST_CASE("waves have integrals, also with powers as factors") {
  check_integral("cos(x)*dot(x)", "sin(x)");
  check_integral("sin(x)*cos(x)*dot(x)", "sin(x)^2/2 - 1/4");
  check_integral("cos(w*t)", "sin(w*t)/w");
  check_integral("x*cos(k*x)*dot(x)", "x*sin(k*x)/k + cos(k*x)/k^2");
  check_integral("x^2*sin(x)*dot(x)", "2*x*sin(x) - (x^2 - 2)*cos(x)");
  check_integral("dot(x)*sin(w*t) + w*x*cos(w*t)", "x*sin(w*t)");
  check_integral("cos(x - w*t)*(dot(x) - w)", "sin(x - w*t)");
  check_integral("cos(x + y)*(dot(x) + dot(y))", "sin(x + y)");
}

TEST_CASE("exponentials have integrals, also with powers and waves as factors") {
  check_integral("exp(k*t)", "exp(k*t)/k");
  check_integral("x^2*exp(k*x)*dot(x)", "(x^2/k - 2*x/k^2 + 2/k^3)*exp(k*x)");
  check_integral("exp(k*t)*(dot(x) + k*x)", "x*exp(k*t)");
  check_integral("exp(k*t)*cos(w*t)", "exp(k*t)*(k*cos(w*t) + w*sin(w*t))/(k^2 + w^2)");
}

TEST_CASE("open functions have rates by the chain rule") {
  check_no_integral("V");
  check_no_integral("V_1*dot(x)");
  check_integral("V*dot(y) + y*(V_1*dot(x) + V_2)", "y*V");
}

TEST_CASE("forms that are no total derivative have no integral") {
  check_no_integral("x");
  check_no_integral("y*dot(x)");
  check_no_integral("dot(x)^2");
  check_no_integral("x*dot(x)*dot(y)");
  check_no_integral("t*dot(x)");
}

TEST_CASE("integrals of other forms than powers and waves are not found") {
  check_no_integral("dot(x)/x");
  check_no_integral("dot(x)/(1 + x)");
  check_no_integral("sqrt(x)*dot(x)");
  check_no_integral("x*exp(x^2)*dot(x)");
  check_no_integral("cos(x)/x*dot(x)");
  check_no_integral("tanh(x)*dot(x)");
}
