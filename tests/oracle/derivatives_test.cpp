// Derivatives of the dynamics: against closed forms, differences of the oracle's own values, and
// each other.
#include "oracle/derivatives.hpp"

#include <catch2/catch.hpp>

#include "oracle/samples.hpp"

namespace elgen::test {
namespace {

std::vector<cln::cl_R> values_of(const Model& model, OutputKind kind, const State& state) {
  OutputRequest request;
  request.kind = kind;
  const auto values = oracle_values(model, request, state);
  REQUIRE(values);
  return *values;
}

/// Cart and pole with damping and a force on the cart.
Model damped_cart() {
  ModelBuilder b;
  b.coordinate("x").coordinate("s");
  b.T("x_d^2 + x_d*s_d*cos(s) + s_d^2/2").V("cos(s)").D("s_d^2/4");
  b.input("u", 0);
  return b.model;
}

}  // namespace

TEST_CASE("derivatives of inverse dynamics are slopes of its values") {
  const Model model = damped_cart();
  const State state = random_state(model, 5);
  const auto derived = values_of(model, OutputKind::inverse_dynamics_derivatives, state);
  const cln::cl_R step = cln::expt(cln::cl_R(10), -30);
  for (std::size_t j = 0; j < 2; ++j) {
    for (const bool by_position : {true, false}) {
      State ahead = state;
      State behind = state;
      cln::cl_R& up = by_position ? ahead.q[j] : ahead.v[j];
      cln::cl_R& down = by_position ? behind.q[j] : behind.v[j];
      up = up + step;
      down = down - step;
      const auto high = values_of(model, OutputKind::inverse_dynamics, ahead);
      const auto low = values_of(model, OutputKind::inverse_dynamics, behind);
      for (std::size_t i = 0; i < 2; ++i) {
        const cln::cl_R slope = (high[i] - low[i]) / (2 * step);
        // The error of a central difference is of the square of its step.
        CHECK(agree(derived[(by_position ? 0 : 4) + 2 * i + j], slope, 50, 1));
      }
    }
  }
}

TEST_CASE("a pendulum linearised: A = [0 1, -cos q -d], B = [0, 1]") {
  ModelBuilder b;
  b.coordinate("q").T("q_d^2/2").V("-cos(q)").D("q_d^2/6").input("u", 0);
  State state = random_state(b.model, 2);
  state.q[0] = 0;
  const auto linear = values_of(b.model, OutputKind::linearization, state);
  REQUIRE(linear.size() == 6);
  CHECK(linear[0] == 0);
  CHECK(linear[1] == 1);
  CHECK(agree(linear[2], -1, 85, 1));
  CHECK(agree(linear[3], cln::cl_RA(-1) / 3, 85, 1));
  CHECK(linear[4] == 0);
  CHECK(agree(linear[5], 1, 85, 1));
}

TEST_CASE("the lower half of A and B are the derivatives of forward dynamics") {
  const Model model = damped_cart();
  const State state = random_state(model, 9);
  const auto forward = values_of(model, OutputKind::forward_dynamics_derivatives, state);
  const auto linear = values_of(model, OutputKind::linearization, state);
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 2; ++j) {
      CHECK(agree(linear[4 * (2 + i) + j], forward[2 * i + j], 85, 1));
      CHECK(agree(linear[4 * (2 + i) + 2 + j], forward[4 + 2 * i + j], 85, 1));
    }
    CHECK(agree(linear[16 + 2 + i], forward[8 + i], 85, 1));
  }
}

}  // namespace elgen::test
