// Compares the functions of a system that steps call, and values of expressions at a state, with
// hand calculations.
#include "run/steps/system.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "run/simulate/compiled_model.hpp"
#include "run/steps/state_function.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// Two coordinates with V = cos(t) y^2, drag and an input on y, and a force 5 x on y.
const std::string cart = model_text("cart", R"toml([[coordinate]]
name = "x"
start = { value = 2, rate = 3 }
[[coordinate]]
name = "y"
[parameters]
m = 2
[energy]
T = "1/2*m*dot(x)^2 + 1/2*dot(y)^2"
V = "cos(t)*y^2"
D = "1/4*dot(y)^2"
[[force]]
on = "y"
value = "5*x"
[[input]]
name = "u"
on = "y"
limits = [-1, 1]
)toml");

/// The value of u's law at x = 0.3, y = -2, dx/dt = 0.5, dy/dt = 7, t = 4, k = 3.
double law(const std::string& text) {
  const CheckedModel checked = checked_model(model_text("plane", R"toml([[coordinate]]
name = "x"
[[coordinate]]
name = "y"
[parameters]
k = 3
[define]
product = "x*y"
[[prescribed]]
name = "push"
value = "2*t"
[[point]]
name = "P"
at = ["x", "y^2"]
mass = "k"
[[input]]
name = "u"
on = "x"
)toml"),
                                             start_options("", "u=" + text));
  const ExpressionId id = checked.scene.laws.at("u");
  const Arguments<double> others{.parameters = {3}, .a = {0, 0}};
  StateFunction function(checked.model, id, others);
  const double q[] = {0.3, -2};
  const double v[] = {0.5, 7};
  return function(q, v, 4);
}

}  // namespace

TEST_CASE("a system starts at the model's start") {
  const CompiledSystem compiled(cart, start_options("y=1/4,dot(y)=-1"));
  SimulatedSystem system(compiled.checked(), compiled.program(), &compiled.functions());
  CHECK(system.start_state() == Numbers{2, 0.25, 3, -1, 0});
}

TEST_CASE("momenta, energies, and the power of forces and of time are right") {
  const CompiledSystem compiled(cart, start_options("", "u=dot(x)/6"));
  SimulatedSystem system(compiled.checked(), compiled.program(), &compiled.functions());
  const Numbers state{2, 0.25, 3, -1, 0};
  const double* const q = state.data();
  const double* const v = system.v_of(state);
  const double t = 0.5;
  Numbers values(2);
  system.find_momentum(q, v, t, values.data());
  CHECK(values == Numbers{6, -1});
  CHECK(system.energy(q, v, t) == Approx(9 + 0.5 + std::cos(t) / 16));
  CHECK(system.energy_parts(q, v, t).magnitude() == Approx(9 + 0.5 + std::cos(t) / 16));
  // F = 5 x + u - dot(y)/2 = 10 + 0.5 + 0.5, -dL/dt = dV/dt = -sin(t) y^2
  CHECK(system.power(q, v, t) == Approx(-1 * 11 - std::sin(t) / 16));
  system.find_acceleration(q, v, t, values.data());
  CHECK(values[1] == Approx(11 - 2 * std::cos(t) * 0.25));
  CHECK(system.relative_pivots()[0] == 1);
  CHECK(system.does_work());
}

TEST_CASE("momenta of cyclic coordinates without forces are conserved") {
  const CompiledSystem compiled(cart);
  const SimulatedSystem system(compiled.checked(), compiled.program(), &compiled.functions());
  CHECK(system.cyclic_velocities() == std::vector<std::uint32_t>{0});
  const CompiledSystem pushed(model_text("cart", R"toml([[coordinate]]
name = "x"
[energy]
T = "dot(x)^2"
[[input]]
name = "u"
on = "x"
)toml"),
                              start_options("", "u=1"));
  CHECK(SimulatedSystem(pushed.checked(), pushed.program(), &pushed.functions())
            .cyclic_velocities()
            .empty());
}

TEST_CASE("inputs are clamped to their limits, and held inputs are constant") {
  const CompiledSystem compiled(cart, start_options("", "u=3*x + t"));
  SimulatedSystem system(compiled.checked(), compiled.program(), &compiled.functions());
  const double q[] = {0.1, 0};
  const double far[] = {2, 0};
  const double v[] = {0, 0};
  CHECK(system.update_inputs(q, v, 0.2).front() == Approx(0.5));
  CHECK(system.update_inputs(far, v, 0).front() == 1);
  system.hold_inputs(q, v, 0.2);
  CHECK(system.update_inputs(far, v, 0).front() == Approx(0.5));
}

TEST_CASE("a constant law is not clamped") {
  const CompiledSystem compiled(cart, start_options("", "u=2*2"));
  SimulatedSystem system(compiled.checked(), compiled.program(), &compiled.functions());
  const double q[] = {0.1, 0};
  const double v[] = {0, 0};
  CHECK(system.update_inputs(q, v, 0.2).front() == 4);
}

TEST_CASE("power uses the laws at the state, held_power the inputs of the last call") {
  const CompiledSystem compiled(cart, start_options("", "u=x/10"));
  SimulatedSystem system(compiled.checked(), compiled.program(), nullptr);
  const double q[] = {2, 0};
  const double v[] = {0, 1};
  // 5 x + u - dot(y)/2
  CHECK(system.power(q, v, 0) == Approx(10 + 0.2 - 0.5));
  const double near[] = {1, 0};
  CHECK(system.power_at_last_inputs(near, v, 0) == Approx(5 + 0.2 - 0.5));
  CHECK(system.power(near, v, 0) == Approx(5 + 0.1 - 0.5));
}

TEST_CASE("laws use the wrapped angle, as rows do") {
  const CompiledSystem compiled(model_text("wheel", R"toml([[coordinate]]
name = "turn"
unit = "rad"
wrap = true
[parameters]
J = { value = 2, unit = "kg*m^2" }
[energy]
T = "1/2*J*dot(turn)^2"
[[input]]
name = "u"
unit = "N*m"
on = "turn"
)toml"),
                                start_options("", "u=-turn"));
  SimulatedSystem system(compiled.checked(), compiled.program(), nullptr);
  const double q[] = {4};
  const double v[] = {0};
  CHECK(system.displayed_position(q).front() == Approx(4 - 2 * M_PI));
  CHECK(system.update_inputs(q, v, 0).front() == Approx(2 * M_PI - 4));
}

TEST_CASE("the evaluator and the compiled code give the same values") {
  const CompiledSystem compiled(cart, start_options("", "u=dot(x)/6"));
  SimulatedSystem code(compiled.checked(), compiled.program(), &compiled.functions());
  SimulatedSystem evaluator(compiled.checked(), compiled.program(), nullptr);
  const Numbers state{2, 0.25, 3, -1, 0};
  const double* const q = state.data();
  const double* const v = code.v_of(state);
  Numbers expected(2);
  Numbers found(2);
  code.find_acceleration(q, v, 0.5, expected.data());
  evaluator.find_acceleration(q, v, 0.5, found.data());
  CHECK(found == expected);
  CHECK(evaluator.energy(q, v, 0.5) == code.energy(q, v, 0.5));
  CHECK(evaluator.power(q, v, 0.5) == code.power(q, v, 0.5));
  CHECK(evaluator.momentum_scales(q, v, 0.5) == code.momentum_scales(q, v, 0.5));
}

TEST_CASE("the magnitude of a Lagrangian given as L is |v.p| + |L|") {
  const CompiledSystem compiled(model_text("particle", R"toml([[coordinate]]
name = "x"
[energy]
L = "-sqrt(1 - dot(x)^2) - x"
)toml"));
  SimulatedSystem system(compiled.checked(), compiled.program(), &compiled.functions());
  const double q[] = {2};
  const double v[] = {0.6};
  CHECK_FALSE(system.has_separate_energies());
  CHECK(system.energy_parts(q, v, 0).magnitude() == Approx(0.6 * 0.75 + 2.8));
}

TEST_CASE("sums, products, quotients, powers and functions are evaluated") {
  CHECK(law("-k*x + y/4 - 1") == Approx(-0.9 - 0.5 - 1));
  CHECK(law("x^2 + k^(-1/2)") == Approx(0.09 + 1 / std::sqrt(3)));
  CHECK(law("atan2(x, y) + sin(pi*x)") == Approx(std::atan2(0.3, -2) + std::sin(M_PI * 0.3)));
  CHECK(law("max(min(dot(y), 2), sign(x)) + abs(y)") == 4);
  CHECK(law("exp(t) - log(k)") == Approx(std::exp(4) - std::log(3)));
}

TEST_CASE("names have the values that the model defines") {
  CHECK(law("product + push") == Approx(-0.6 + 8));
  CHECK(law("y(P)") == 4);
}

TEST_CASE("rates are rates along the motion") {
  CHECK(law("dot(x)*dot(y)") == 3.5);
  CHECK(law("dot(product)") == Approx(0.5 * -2 + 0.3 * 7));
  CHECK(law("v2(P)") == Approx(0.25 + 28 * 28));
  CHECK(law("dot(push)") == 2);
}

TEST_CASE("points of rotating frames move with the angular velocity") {
  const CheckedModel checked = checked_model(model_text("body", R"toml([[coordinate]]
name = "x"
[[coordinate]]
name = "e"
kind = "rotation"
[parameters]
m = 1
[[frame]]
name = "F"
parent = "world"
rotation = "e"
[[point]]
name = "P"
frame = "F"
at = ["m", "2*m", "3*m"]
mass = "m"
[[body]]
name = "B"
frame = "F"
inertia = ["3*m", "4*m", "5*m"]
[[input]]
name = "u"
on = "x"
[energy]
T = "dot(x)^2"
)toml"),
                                             start_options("", "u=v2(P) + dot(e[2])"));
  const Arguments<double> others{.parameters = {1}, .a = {0, 0, 0, 0}};
  StateFunction function(checked.model, checked.scene.laws.at("u"), others);
  const double q[] = {0, 1, 0, 0, 0};
  const double v[] = {0, 0.5, -1, 2};
  // w x p = (-1*3 - 2*2, 2*1 - 0.5*3, 0.5*2 + 1*1) in world axes
  CHECK(function(q, v, 0) == Approx(49 + 0.25 + 4 - 1));
  const double turned[] = {0, 0.5, 0.5, -0.5, 0.5};
  CHECK(function(turned, v, 0) == Approx(49 + 0.25 + 4 - 1));
}
