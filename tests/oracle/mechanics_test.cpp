// Energies at a state, and their directional derivatives.
#include "oracle/mechanics.hpp"

#include <catch2/catch.hpp>

#include "oracle/energies.hpp"
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

struct Found {
  cl_R T;
  cl_R V;
  cl_R L;
  cl_R terms_of_V;
};

/// At x = 2, y = 3, dx/dt = 5, dy/dt = 7.
Found energies_of(const ModelBuilder& b) {
  const Motion motion{{}, {}, {2, 3}, {5, 7}, {}, {}, {0, 0}, {}, {}, 0};
  Evaluation at(b.model, motion);
  return {kinetic_energy(at).real(), potential_energy(at).real(), lagrangian(at).real(),
          potential_magnitude(at).real()};
}

ModelBuilder plane() {
  ModelBuilder b;
  b.coordinate("x").coordinate("y");
  return b;
}

Body body_at(ModelBuilder& b, const std::vector<std::string>& com, const std::string& mass) {
  Body body;
  body.com = b.padded(com);
  body.mass = b.expression(mass);
  return body;
}

}  // namespace

TEST_CASE("mass matrix, its gradient and momentum of a quadratic form") {
  const ModelBuilder b = coupled_plane();
  const State state = plane_state(b);
  Mechanics at(b.model, state);  // M = [2, x; x, 2 y]
  CHECK(at.mass_product(along_x, along_x) == 2);
  CHECK(at.mass_product(along_x, along_y) == 2);
  CHECK(at.mass_product(along_y, along_y) == 6);
  CHECK(at.mass_gradient(along_x, along_x, along_y) == 1);
  CHECK(at.mass_gradient(along_y, along_y, along_y) == 2);
  CHECK(at.mass_gradient(along_y, along_x, along_x) == 0);
  CHECK(at.momentum(along_x) == 2 * 5 + 2 * 7);
}

TEST_CASE("inverse dynamics equals Lagrange's equation") {
  const ModelBuilder b = coupled_plane();
  const State state = plane_state(b);
  Mechanics at(b.model, state);
  // d/dt (2 vx + x vy) - vx vy = 2 ax + x ay + vx vy - vx vy
  CHECK(at.inverse_dynamics(along_x, state.a) == 2 * 11 + 2 * 13);
  // d/dt (x vx + 2 y vy) - vy^2 = vx^2 + x ax + 2 y ay + vy^2
  CHECK(at.inverse_dynamics(along_y, state.a) == 25 + 2 * 11 + 6 * 13 + 49);
}

TEST_CASE(
    "a force at a point works along its displacement, and the reaction along the other point's") {
  ModelBuilder b = coupled_plane();
  b.point("P", {"x*y", "0"}).point("Q", {"x", "x^2"}).force_at("P", {"10 + 2*u", "1"}, "Q");
  const State state = plane_state(b);
  Mechanics at(b.model, state);
  CHECK(at.applied_force(along_x) == 10 * 3 - (10 * 1 + 1 * 4));
  CHECK(at.applied_force(along_y) == 10 * 2);
  CHECK(at.input_force(along_x, {1}) == 2 * (3 - 1));
}

TEST_CASE("generalised forces, inputs on a coordinate, kinks and dissipation") {
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

TEST_CASE("energies and gradients of a potential with terms linear in the rates") {
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

TEST_CASE("written energies and point masses add up, a point without a mass adds nothing") {
  ModelBuilder b = plane();
  b.T("x_d").V("y").point("P", {"x*y", "y"}, "2").point("Q", {"x", "0"}).gravity({"0", "-10"});
  const Found e = energies_of(b);
  CHECK(e.T == 5 + (15 + 14) * (15 + 14) + 49);
  CHECK(e.V == 3 + 2 * 10 * 3);
  CHECK(e.L == e.T - e.V);
}

TEST_CASE("the magnitude of V adds |terms| as written, and each weight") {
  ModelBuilder b = plane();
  b.V("6*x - 4*y").point("P", {"x", "y"}, "2").point("Q", {"x", "-y"}, "2");
  b.gravity({"0", "-10"});
  const Found e = energies_of(b);
  CHECK(e.V == 0);
  CHECK(e.terms_of_V == 12 + 12 + 60 + 60);
  CHECK(energies_of(plane().V("-x*y")).terms_of_V == 6);
  CHECK(energies_of(plane()).terms_of_V == 0);
}

TEST_CASE("kinetic energy of a body: 1/2 m v^2 + 1/2 w.I w with all products of inertia") {
  ModelBuilder b = plane();
  Body body = body_at(b, {"x", "y", "0"}, "2");
  for (const char* entry : {"1", "2", "3", "4", "5", "6"}) {
    body.inertia.push_back(b.expression(entry));
  }
  body.spin = {b.expression("x_d"), b.expression("y_d"), b.expression("1")};
  b.model.bodies = {body};
  // w = (5, 7, 1): w.I w = 25 + 98 + 3 + 2 (4*35 + 5*5 + 6*7)
  CHECK(energies_of(b).T == 25 + 49 + (25 + 98 + 3 + 2 * (140 + 25 + 42)) / 2);
}

TEST_CASE("an armature adds 1/2 J v^2") {
  ModelBuilder b = plane();
  b.model.coordinates[1].armature = b.expression("4");
  CHECK(energies_of(b).T == 2 * 49);
}

TEST_CASE("a Lagrangian given as L is used as L") {
  ModelBuilder b = plane();
  b.L("x*y_d - y");
  CHECK(energies_of(b).L == 14 - 3);
}
