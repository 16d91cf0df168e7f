// Rotations: rates of quaternions, and Euler's equations from an energy.
#include "oracle/rotations.hpp"

#include <catch2/catch.hpp>

#include "elgen/oracle.hpp"
#include "model_builder.hpp"
#include "oracle/mechanics.hpp"

namespace elgen::test {
namespace {

using cln::cl_R;
using cln::cl_RA;

/// A body with inertias 2, 3, 5 on a spherical joint; its weight has V = 7 R_33.
Model top() {
  ModelBuilder b;
  b.rotation("e").T("e1_d^2 + 3/2*e2_d^2 + 5/2*e3_d^2");
  b.V("7*(e_w^2 - e_x^2 - e_y^2 + e_z^2)");
  return b.model;
}

State turning(const Model& model) {
  State state = nominal_state(model, {});
  state.q = {0, cl_RA(1) / 2, cl_RA(1) / 3, cl_RA(-1) / 5};
  set_rational_quaternions(model, state);
  state.v = {11, 13, -17};
  state.a = {1, -2, 3};
  return state;
}

std::vector<cl_R> values(const Model& model, OutputKind kind, const State& state) {
  return oracle_values(model, {.kind = kind}, state).value();
}

}  // namespace

TEST_CASE("the nominal state of a rotation is the identity") {
  CHECK(nominal_state(top(), {}).q == std::vector<cl_R>{1, 0, 0, 0});
}

TEST_CASE("the rate of a quaternion is normal to it") {
  const Model model = top();
  const State state = turning(model);
  const std::vector<cl_R> rates = values(model, OutputKind::coordinate_rates, state);
  cl_R length = 0;
  cl_R slope = 0;
  for (std::size_t i = 0; i < quaternion_size; ++i) {
    length = length + state.q[i] * state.q[i];
    slope = slope + state.q[i] * rates[i];
  }
  CHECK(length == 1);
  CHECK(slope == 0);
}

TEST_CASE("at the identity the quaternion rate is half the angular velocity") {
  const Model model = top();
  State state = nominal_state(model, {});
  state.v = {2, 4, 6};
  CHECK(values(model, OutputKind::coordinate_rates, state) == std::vector<cl_R>{0, 1, 2, 3});
}

TEST_CASE("`normalized` divides the quaternion by its length") {
  const Model model = top();
  State state = nominal_state(model, {});
  state.q = {0, 3, 0, 4};
  CHECK(values(model, OutputKind::normalized, state) ==
        std::vector<cl_R>{0, cl_RA(3) / 5, 0, cl_RA(4) / 5});
}

TEST_CASE("velocity_force of a body is Euler's w x (I w)") {
  const Model model = top();
  const State state = turning(model);
  const auto& w = state.v;
  CHECK(values(model, OutputKind::velocity_force, state) ==
        std::vector<cl_R>{(5 - 3) * w[1] * w[2], (2 - 5) * w[2] * w[0], (3 - 2) * w[0] * w[1]});
}

TEST_CASE("gravity of a body is the moment of its weight") {
  const Model model = top();
  const State state = turning(model);
  const auto& e = state.q;
  const cl_R r31 = 2 * (e[1] * e[3] - e[0] * e[2]);
  const cl_R r32 = 2 * (e[2] * e[3] + e[0] * e[1]);
  CHECK(values(model, OutputKind::gravity, state) == std::vector<cl_R>{-7 * r32, 7 * r31, 0});
}

TEST_CASE("C of a body is 1/2 ([w] I + I [w] - [I w])") {
  const Model model = top();
  const State state = turning(model);
  const auto& w = state.v;
  const std::vector<cl_R> c = values(model, OutputKind::coriolis_matrix, state);
  const std::vector<cl_R> inertia{2, 3, 5};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3;
    const std::size_t j = (k + 2) % 3;
    // [w]_ij = -w_k, [I w]_ij = -I_k w_k
    const cl_R entry = -w[k] * (inertia[j] + inertia[i] - inertia[k]) / 2;
    CHECK(c[3 * i + j] == entry);
    CHECK(c[3 * j + i] == -entry);
    CHECK(c[3 * k + k] == 0);
  }
}

TEST_CASE("energy is conserved along the motion") {
  Model model = top();
  const auto energy = static_cast<ExpressionId>(model.expressions.size());
  model.expressions.push_back({.kind = ExpressionKind::leaf, .leaf = Opcode::energy});
  State state = turning(model);
  const std::vector<cl_R> solution = values(model, OutputKind::forward_dynamics, state);
  state.a.assign(solution.begin(), solution.begin() + 3);
  const auto potential = oracle_expression_rate(model, *model.energies.V, state);
  const auto kinetic = oracle_expression_rate(model, *model.energies.T, state);
  CHECK(*potential + *kinetic == 0);
  CHECK(cln::abs(oracle_expression_rate(model, energy, state).value()) < cl_R(1e-40));
}

TEST_CASE("second rates include the rotation of the rate") {
  ModelBuilder b;
  b.rotation("e").T("e1_d^2").output({"e_w", "e_z"});
  State state = nominal_state(b.model, {});
  state.v = {0, 0, 2};
  // e = (cos t, 0, 0, sin t)
  CHECK(oracle_values(b.model, {.kind = OutputKind::user_bias}, state).value() ==
        std::vector<cl_R>{-1, 0});
}

}  // namespace elgen::test
