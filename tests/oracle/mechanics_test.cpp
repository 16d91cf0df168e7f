#include "oracle/mechanics.hpp"

#include <catch2/catch.hpp>

#include "oracle/samples.hpp"

using namespace elgen;
using namespace elgen::oracle;
using namespace elgen::test;
using cln::cl_R;

namespace {

ModelBuilder coupled_plane() {
  ModelBuilder b;
  b.coordinate("x").coordinate("y").input("u").T("x_d^2 + x*x_d*y_d + y_d^2*y");
  return b;
}

/// x = 2, y = 3, dx/dt = 5, dy/dt = 7, d2x/dt2 = 11, d2y/dt2 = 13, u = 17
State plane_state(const ModelBuilder& b) {
  State state = nominal_state(b.model, {});
  state.q = {2, 3};
  state.v = {5, 7};
  state.a = {11, 13};
  state.u = {17};
  return state;
}

const Direction along_x{1, 0};
const Direction along_y{0, 1};

}  // namespace

TEST_CASE("mass, its gradient and momentum of a quadratic form") {
  const ModelBuilder b = coupled_plane();
  const State state = plane_state(b);
  Mechanics at(b.model, state);  // M = [2, x; x, 2 y]
  CHECK(at.mass(along_x, along_x) == 2);
  CHECK(at.mass(along_x, along_y) == 2);
  CHECK(at.mass(along_y, along_y) == 6);
  CHECK(at.mass_gradient(along_x, along_x, along_y) == 1);
  CHECK(at.mass_gradient(along_y, along_y, along_y) == 2);
  CHECK(at.mass_gradient(along_y, along_x, along_x) == 0);
  CHECK(at.momentum(along_x) == 2 * 5 + 2 * 7);
}

TEST_CASE("inverse dynamics is Lagrange's equation") {
  const ModelBuilder b = coupled_plane();
  const State state = plane_state(b);
  Mechanics at(b.model, state);
  // d/dt (2 vx + x vy) - vx vy = 2 ax + x ay + vx vy - vx vy
  CHECK(at.inverse_dynamics(along_x, state.a) == 2 * 11 + 2 * 13);
  // d/dt (x vx + 2 y vy) - vy^2 = vx^2 + x ax + 2 y ay + vy^2
  CHECK(at.inverse_dynamics(along_y, state.a) == 25 + 2 * 11 + 6 * 13 + 49);
}

TEST_CASE("forces at points do work along the displacement, with their reaction") {
  ModelBuilder b = coupled_plane();
  b.point("P", {"x*y", "0"}).point("Q", {"x", "x^2"}).force_at("P", {"10 + 2*u", "1"}, "Q");
  const State state = plane_state(b);
  Mechanics at(b.model, state);
  CHECK(at.applied_force(along_x) == 10 * 3 - (10 * 1 + 1 * 4));
  CHECK(at.applied_force(along_y) == 10 * 2);
  CHECK(at.input_force(along_x, {1}) == 2 * (3 - 1));
}

TEST_CASE("generalized forces, inputs on a coordinate, kinks and dissipation") {
  ModelBuilder b = coupled_plane();
  b.input("w", 1).force_on(0, "-3*sign(x_d)*abs(y_d) + x*u").D("x_d^2*y_d");
  State state = plane_state(b);
  state.u = {17, 19};
  Mechanics at(b.model, state);
  CHECK(at.applied_force(along_x) == -21);
  CHECK(at.applied_force(along_y) == 0);
  CHECK(at.input_force(along_x, {1, 0}) == 2);
  CHECK(at.input_force(along_y, {0, 1}) == 1);
  CHECK(at.dissipation_force(along_x) == 2 * 5 * 7);
  CHECK(at.dissipation_force(along_y) == 25);
}

TEST_CASE("energies and the gradient of a potential with a part linear in the rates") {
  ModelBuilder b = coupled_plane();
  b.V("x^2*y + 4*y*x_d");
  const State state = plane_state(b);
  Mechanics at(b.model, state);
  const cl_R kinetic = 25 + 2 * 35 + 49 * 3;
  CHECK(at.kinetic_energy() == kinetic);
  CHECK(at.potential_energy_at_rest() == 12);
  CHECK(at.potential_energy() == 12 + 60);
  CHECK(at.energy_function() == kinetic + 12);
  CHECK(at.energy_magnitude() == kinetic + 12 + 12 + 60);
  CHECK(at.gravity(along_x) == 12);
  CHECK(at.gravity(along_y) == 4);
  CHECK(at.position_gradient(along_x) == 5 * 7 - 12);
  CHECK(at.position_gradient(along_y) == 7 * 7 - 4 - 4 * 5);
}
