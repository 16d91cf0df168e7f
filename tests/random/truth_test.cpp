// The evaluated definition of the equations against closed forms from textbooks.
#include "random/truth.hpp"

#include <catch2/catch.hpp>

using namespace elgen::test::random;

namespace {

/// A dozen operations lose a few of the 80 digits.
void check_near(const Number& value, const Number& expected) {
  CHECK(abs(value - expected) < Number("1e-70"));
}

State state_of(std::vector<Number> q, std::vector<Number> v, std::vector<Number> a) {
  State state;
  for (const Number& x : q) state.q.emplace_back(x);
  for (const Number& x : v) state.v.emplace_back(x);
  for (const Number& x : a) state.a.emplace_back(x);
  return state;
}

}  // namespace

TEST_CASE("a double pendulum in absolute angles has its closed forms") {
  System system;
  Model& model = system.model;
  model.coordinates = {{.name = "a"}, {.name = "b"}};
  const auto swung = [](const char* angle) {
    return std::vector<Expression>{call_of("sin", {name(angle)}), -call_of("cos", {name(angle)})};
  };
  const auto first = swung("a");
  const auto second = swung("b");
  model.points = {{.name = "P", .at = first, .mass = number(2)},
                  {.name = "Q",
                   .at = {component("P", 0) + second[0], component("P", 1) + second[1]},
                   .mass = number(3)}};
  model.gravity = {number(0), number(-10)};
  const Number a = 1;
  const Number b = Number(1) / 4;
  const Number v = 2;
  const Number w = -3;
  Values values = Truth(system, {}, state_of({a, b}, {v, w}, {1, 5})).outputs();
  // Masses 2 and 3, lengths 1: M = [5, 3 cos; 3 cos, 3], C v = 3 sin(a - b) (w^2, -v^2).
  const Number s = sin(a - b);
  const Number c = cos(a - b);
  check_near(values["mass_matrix"][0], 5);
  check_near(values["mass_matrix"][1], 3 * c);
  check_near(values["velocity_force"][0], 3 * s * w * w);
  check_near(values["velocity_force"][1], -3 * s * v * v);
  check_near(values["coriolis_matrix"][1], 3 * s * w);
  check_near(values["gravity"][0], 50 * sin(a));
  check_near(values["inverse_dynamics"][1], 3 * c + 15 - 3 * s * v * v + 30 * sin(b));
  const Number expected_a =
      (-3 * s * w * w - 50 * sin(a) - c * (3 * s * v * v - 30 * sin(b))) / (5 - 3 * c * c);
  check_near(values["forward_dynamics.acceleration"][0], expected_a);
}

TEST_CASE("a free body has Euler's equations and their C") {
  System system;
  Model& model = system.model;
  model.coordinates = {{.name = "att", .is_rotation = true}};
  model.frames = {{.name = "F", .parent = "world", .turn = Turn::rotation, .rotation = "att"}};
  model.bodies = {{.name = "B", .inertia = {number(2), number(3), number(4)}, .frame = "F"}};
  const Number half = Number(1) / 2;
  Values values =
      Truth(system, {}, state_of({half, half, half, half}, {5, 6, 7}, {1, 2, 3})).outputs();
  // I a + w x I w
  check_near(values["inverse_dynamics"][0], 2 + 6 * 7 * (4 - 3));
  check_near(values["inverse_dynamics"][1], 6 + 5 * 7 * (2 - 4));
  check_near(values["inverse_dynamics"][2], 12 + 5 * 6 * (3 - 2));
  // C[1,2] = (I3 - I1 - I2) w3 / 2
  check_near(values["coriolis_matrix"][1], Number(4 - 2 - 3) * 7 / 2);
  check_near(values["coordinate_rates"][0], -Number(5 + 6 + 7) / 4);
}

TEST_CASE("a moving lock has its reaction, and a pendulum its approximation") {
  System system;
  Model& model = system.model;
  model.coordinates = {{.name = "x"}, {.name = "y"}};
  const Expression x = rate(name("x"));
  const Expression y = rate(name("y"));
  model.T = raised(x, 2) + x * y + raised(y, 2);
  system.scene.is_present = true;
  system.scene.locks = {{"y", {raised(time(), 3)}, true}};
  State state = state_of({1, 0}, {2, 0}, {3, 0});
  state.t = 2;
  Values values = Truth(system, {}, state).outputs();
  check_near(values["inverse_dynamics"][0], 2 * 3 + 12);  // d/dt (2 x' + 3 t^2)
  check_near(values["reaction"][0], 3 + 2 * 12);
  check_near(values["kinetic_energy"][0], 4 + 2 * 12 + 144);

  System swinging;
  swinging.model.coordinates = {{.name = "q"}};
  swinging.model.T = raised(rate(name("q")), 2) / number(2);
  swinging.model.V = -call_of("cos", {name("q")});
  swinging.scene.is_present = true;
  swinging.scene.order = 3;
  swinging.scene.about = {{"q", number(0)}};
  values = Truth(swinging, {}, state_of({Number(1) / 2}, {1}, {0})).outputs();
  check_near(values["gravity"][0], Number(1) / 2 - Number(1) / 48);
}
