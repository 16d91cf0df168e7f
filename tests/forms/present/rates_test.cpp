// Rates of closed forms along the motion.
#include <catch2/catch.hpp>

#include "elgen/closed_forms.hpp"
#include "forms/present/arithmetic.hpp"
#include "support/models.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// True if the rate of `x` along the motion with `acceleration` is proved to be 0.
bool is_steady(ClosedForms& forms, const Fraction& x, const Fraction& acceleration,
               const OpenValueRates& open_values = {}) {
  const auto rate = unforced_rate(forms, x, {acceleration}, {}, open_values);
  return rate && rate->numerator.empty();
}

/// True if `quantity` is proved to be conserved for x'' = `acceleration`.
bool is_conserved(const std::string& quantity, const std::string& acceleration) {
  const Model model = checked_model(model_text("line", R"toml([[coordinate]]
name = "x"
[parameters]
k = 2
[[input]]
name = "u"
[[force]]
value = "u"
on = "x"
[energy]
T = "1/2*dot(x)^2"
[[expect]]
kinetic_energy = ")toml" + quantity + "\"\npotential_energy = \"" +
                                                           acceleration + "\"\n"))
                          .model;
  ClosedForms forms;
  const auto form = [&](std::size_t i) {
    return *closed_form(forms, model, {}, model.expectations[i].entries[0]);
  };
  const Fraction conserved = form(0);
  const Fraction rate = form(1);
  return is_steady(forms, conserved, rate);
}

}  // namespace

TEST_CASE("energies of motions on a line") {
  CHECK(is_conserved("1/2*dot(x)^2 + 1/2*k*x^2", "-k*x"));
  CHECK_FALSE(is_conserved("1/2*dot(x)^2 + k*x^2", "-k*x"));
  CHECK(is_conserved("1/2*dot(x)^2 - k*cos(x)", "-k*sin(x)"));
  CHECK(is_conserved("1/2*dot(x)^2 - k/(1 + x)", "-k/(1 + x)^2"));
  CHECK(is_conserved("1/2*dot(x)^2 + sqrt(1 + x^2)", "-x/sqrt(1 + x^2)"));
}

TEST_CASE("the rate of time is 1, and inputs are zero") {
  CHECK(is_conserved("x - t*dot(x)", "0"));
  CHECK(is_conserved("dot(x) - k*t", "k + u"));
}

TEST_CASE("functions that stay atoms have the derivatives of their table") {
  CHECK(is_conserved("dot(x)*exp(-x)", "dot(x)^2"));
  CHECK_FALSE(is_conserved("dot(x)*exp(-x)", "2*dot(x)^2"));
  CHECK(is_conserved("1/2*dot(x)^2 + k*log(1 + x^2)", "-2*k*x/(1 + x^2)"));
  CHECK(is_conserved("1/2*dot(x)^2 + tanh(x)", "tanh(x)^2 - 1"));
  CHECK(is_conserved("1/2*dot(x)^2 + sinh(x)", "-cosh(x)"));
  CHECK(is_conserved("1/2*dot(x)^2 + atan(x)", "-1/(1 + x^2)"));
  CHECK(is_conserved("1/2*dot(x)^2 + atan2(x, k)", "-k/(x^2 + k^2)"));
  CHECK(is_conserved("1/2*dot(x)^2 + atan2(k, x)", "k/(x^2 + k^2)"));
}

TEST_CASE("functions with kinks have a rate only if their arguments are constant") {
  ClosedForms forms;
  Arithmetic arithmetic(forms.algebra);
  const OptionalFraction moving = arithmetic.leaf(Opcode::coordinate, 0);
  const OptionalFraction standing = arithmetic.leaf(Opcode::parameter, 0);
  const auto stays = [&](const OptionalFraction& value) {
    return is_steady(forms, value.value(), {});
  };
  CHECK_FALSE(stays(arithmetic.call(FunctionId::abs, moving, {})));
  CHECK_FALSE(stays(arithmetic.call(FunctionId::max, standing, moving)));
  CHECK(stays(arithmetic.call(FunctionId::abs, standing, {})));
}

TEST_CASE("open functions have rates by the chain rule, with any arguments") {
  const Model model = checked_model(model_text("line", R"toml([[coordinate]]
name = "x"
[[function]]
name = "V"
of = ["x^2"]
[energy]
T = "1/2*dot(x)^2"
V = "V"
[[expect]]
inverse_dynamics = "-2*x*V_1"
conserved = ["1/2*dot(x)^2 + V", "1/2*dot(x)^2 + 2*V", "V_11"]
)toml"))
                          .model;
  ClosedForms forms;
  const auto form = [&](std::size_t expectation, std::size_t entry) {
    return *closed_form(forms, model, {}, model.expectations[expectation].entries[entry]);
  };
  const Fraction acceleration = form(0, 0);
  const OpenValueRates terms = open_value_rates(forms, model, {});
  const auto stays = [&](std::size_t entry) {
    const Fraction quantity = form(1, entry);
    return is_steady(forms, quantity, acceleration, terms);
  };
  CHECK(stays(0));
  CHECK_FALSE(stays(1));
  CHECK_FALSE(stays(2));
}
