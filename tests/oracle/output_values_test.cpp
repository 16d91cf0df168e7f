// Compares every output with values by hand and with contractions. Derivatives are also compared
// with differences and with related outputs.
#include "oracle/output_values.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>

#include "elgen/step_methods.hpp"
#include "model/requests.hpp"
#include "oracle/mechanics.hpp"
#include "oracle/samples.hpp"

namespace elgen::test {

using namespace elgen::oracle;
using cln::cl_R;

namespace {

using Values = std::vector<cln::cl_R>;

ModelBuilder polar() {
  ModelBuilder b;
  b.coordinate("r").coordinate("ph").input("u", 0).parameter("m", "2");
  b.T("m*(r_d^2 + r^2*ph_d^2)/2").V("m*r").D("r_d^2").force_on(1, "r*u - 3");
  b.output({"r^2*ph", "t*r"});
  return b;
}

/// r = 2, ph = 3, dr/dt = 5, dph/dt = 7, p = (10, 56), a = (11, 13), u = 17, t = 19
State polar_state(const ModelBuilder& b) {
  State state = nominal_state(b.model, {});
  state.q = {2, 3};
  state.v = {5, 7};
  state.momenta = {10, 56};
  state.a = {11, 13};
  state.u = {17};
  state.t = 19;
  return state;
}

Values value(OutputKind kind) {
  const ModelBuilder b = polar();
  return output_values(b.model, {.kind = kind}, polar_state(b));
}

ModelBuilder everything() {
  ModelBuilder b = rotating_hoop("W*t^2");
  b.coordinate("s").input("u", 1).input("w").T("s_d^2*(1 + th^2) + s_d*th_d + s_d").V("s*th*th_d");
  b.D("s_d^2*th_d^2").force_on(0, "s*w - tanh(s_d)").output({"s*th", "sin(s)", "th^2"});
  return b;
}

/// w.x, or w.X y if `by` has a y; x or X is the field of `values` that starts at `first`.
cl_R contracted(const Values& values, std::size_t first, const Contraction& by) {
  cl_R sum = 0;
  for (std::size_t i = 0; i < by.w.size(); ++i) {
    if (by.y.empty()) sum = sum + by.w[i] * values[first + i];
    for (std::size_t j = 0; j < by.y.size(); ++j) {
      sum = sum + by.w[i] * values[first + i * by.y.size() + j] * by.y[j];
    }
  }
  return sum;
}

void check(OutputKind kind, std::size_t first, const Contraction& by) {
  const ModelBuilder b = everything();
  const State state = random_state(b.model, 3);
  OutputRequest request;
  request.kind = kind;
  if (output_row(kind).is_step) {  // only midpoint has all fields
    request.step = StepSpec{.method = StepMethod::midpoint, .iterations = 2};
  }
  const auto values = oracle_values(b.model, request, state);
  const auto number = oracle_contraction(b.model, request, state, by);
  CAPTURE(static_cast<int>(kind), by.field);
  REQUIRE(values);
  REQUIRE(number);
  // The oracle computes with 95 digits. A few operations lose at most 10 of these digits.
  CHECK(agree(*number, contracted(*values, first, by), 85, 1));
}

Contraction directions(const FieldRow& field) {
  Contraction by;
  const auto count = [model = everything().model](Extent extent) {
    return static_cast<int>(extent_size(model, extent));
  };
  for (int i = 0; i < count(field.rows); ++i) by.w.push_back(2 * i - 1);
  const int columns = is_matrix_field(field) ? count(field.columns) : 0;
  for (int j = 0; j < columns; ++j) by.y.push_back(3 - 5 * j);
  return by;
}

/// Cart and pole, with damping of the pole and an input force on the cart.
Model damped_cart() {
  ModelBuilder b;
  b.coordinate("x").coordinate("s");
  b.T("x_d^2 + x_d*s_d*cos(s) + s_d^2/2").V("cos(s)").D("s_d^2/4");
  b.input("u", 0);
  return b.model;
}

}  // namespace

TEST_CASE("every output of a particle in polar coordinates, by hand") {
  CHECK(value(OutputKind::mass_matrix) == Values{2, 0, 0, 8});
  CHECK(value(OutputKind::coriolis_matrix) == Values{0, -28, 28, 20});
  CHECK(value(OutputKind::velocity_force) == Values{-196, 280});
  CHECK(value(OutputKind::gravity) == Values{2, 0});
  CHECK(value(OutputKind::potential_energy) == Values{4});
  CHECK(value(OutputKind::drift) == Values{0, 0});
  CHECK(value(OutputKind::dissipation) == Values{10, 0});
  CHECK(value(OutputKind::applied_force) == Values{0, -3});
  CHECK(value(OutputKind::bias) == Values{-196 + 2 + 10, 280 + 3});
  CHECK(value(OutputKind::momentum) == Values{10, 56});
  CHECK(value(OutputKind::position_gradient) == Values{194, 0});
  CHECK(value(OutputKind::kinetic_energy) == Values{221});
  CHECK(value(OutputKind::total_energy) == Values{225});
  CHECK(value(OutputKind::energy_function) == Values{225});
  CHECK(value(OutputKind::input_matrix) == Values{1, 2});
  CHECK(value(OutputKind::inverse_dynamics) == Values{22 - 184, 104 + 283});
  CHECK(value(OutputKind::forward_dynamics) == Values{exact("201/2"), exact("-249/8"), 1, 1});
  CHECK(value(OutputKind::hamiltonian) == Values{225});
  CHECK(value(OutputKind::velocities_of_momenta) == Values{5, 7});
  CHECK(value(OutputKind::hamilton_equations) == Values{5, 7, 194 + 17 - 10, 34 - 3});
}

TEST_CASE("a user output: value, Jacobian, and bias in d2y/dt2 = J a + bias") {
  CHECK(value(OutputKind::user_value) == Values{12, 38});
  CHECK(value(OutputKind::user_jacobian) == Values{12, 4, 19, 0});
  // d2/dt2 (r^2 ph) = 2 dr^2 ph + 4 r dr dph at a = 0; d2/dt2 (t r) = 2 dr
  CHECK(value(OutputKind::user_bias) == Values{150 + 280, 10});
}

TEST_CASE("the struct of all outputs has no entries") {
  CHECK(value(OutputKind::dynamics).empty());
}

TEST_CASE("contractions are sums over all entries, for every field of every output") {
  for (const OutputRow& row : output_table()) {
    constexpr std::array others{Need::reaction, Need::cyclic, Need::constraints};
    const auto needs = [&row](Need need) { return row.needs.has(need); };
    const bool is_of_task = row.kind == OutputKind::user_operational;
    if (is_of_task || std::ranges::any_of(others, needs)) continue;
    std::size_t first = 0;
    for (std::size_t k = 0; k < row.fields.size(); ++k) {
      // The pivots of a solve have no contraction.
      if (row.kind == OutputKind::forward_dynamics && k > 0) break;
      Contraction by = directions(row.fields[k]);
      by.field = k;
      check(row.kind, first, by);
      first += by.w.size() * std::max<std::size_t>(by.y.size(), 1);
    }
  }
}

TEST_CASE("a contraction outside the domain is empty") {
  ModelBuilder b;
  b.coordinate("x").T("x_d^2/2").V("log(x)");
  CHECK_FALSE(oracle_contraction(b.model, {.kind = OutputKind::gravity}, nominal_state(b.model, {}),
                                 {{1}, {}}));
}

TEST_CASE("derivatives of inverse dynamics are slopes of its values") {
  const Model model = damped_cart();
  const State state = random_state(model, 5);
  const auto derived = *value_of(model, OutputKind::inverse_dynamics_derivatives, state);
  const cln::cl_R step = cln::expt(cln::cl_R(10), -30);
  for (std::size_t j = 0; j < 2; ++j) {
    for (const bool by_position : {true, false}) {
      State ahead = state;
      State behind = state;
      cln::cl_R& up = by_position ? ahead.q[j] : ahead.v[j];
      cln::cl_R& down = by_position ? behind.q[j] : behind.v[j];
      up = up + step;
      down = down - step;
      const auto high = *value_of(model, OutputKind::inverse_dynamics, ahead);
      const auto low = *value_of(model, OutputKind::inverse_dynamics, behind);
      for (std::size_t i = 0; i < 2; ++i) {
        const cln::cl_R slope = (high[i] - low[i]) / (2 * step);
        // The error of a central difference is O(h^2).
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
  const auto linear = *value_of(b.model, OutputKind::linearization, state);
  REQUIRE(linear.size() == 6);
  CHECK(linear[0] == 0);
  CHECK(linear[1] == 1);
  CHECK(agree(linear[2], -1, 85, 1));
  CHECK(agree(linear[3], cln::cl_RA(-1) / 3, 85, 1));
  CHECK(linear[4] == 0);
  CHECK(agree(linear[5], 1, 85, 1));
}

TEST_CASE("the lower halves of A and B are derivatives of forward dynamics") {
  const Model model = damped_cart();
  const State state = random_state(model, 9);
  const auto forward = *value_of(model, OutputKind::forward_dynamics_derivatives, state);
  const auto linear = *value_of(model, OutputKind::linearization, state);
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 2; ++j) {
      CHECK(agree(linear[4 * (2 + i) + j], forward[2 * i + j], 85, 1));
      CHECK(agree(linear[4 * (2 + i) + 2 + j], forward[4 + 2 * i + j], 85, 1));
    }
    CHECK(agree(linear[16 + 2 + i], forward[8 + i], 85, 1));
  }
}

TEST_CASE("columns of the regressor: closed forms of cart and pole, and contractions") {
  const ModelBuilder b = cart_pole();
  State state = random_state(b.model, 6);
  state.reference = state.v;
  const cl_R l = state.parameters[2];
  const cl_R g = state.parameters[3];
  const cl_R s = cln::sin(as_float(state.q[1]));
  const cl_R c = cln::cos(as_float(state.q[1]));
  const cl_R v = state.v[1];
  const cl_R& x = state.a[0];
  const cl_R& th = state.a[1];
  for (const OutputKind kind : {OutputKind::regressor, OutputKind::regressor_reference}) {
    const OutputRequest output{.kind = kind};
    const Values found = output_values(b.model, output, state);
    const Values expected{x, x + l * (c * th - s * v * v), 0, l * (c * x + l * th - g * s), 0, 0};
    REQUIRE(found.size() == expected.size());
    for (std::size_t k = 0; k < found.size(); ++k) CHECK(agree(found[k], expected[k], 60, 1));
    for (std::size_t k = 0; k < 4; ++k) {
      const Contraction by{unit_direction(2, k / 2), unit_direction(2, k % 2)};
      CHECK(agree(contract_output(b.model, output, state, by), found[k], 60, 1));
    }
    const Contraction rest{{2, 3}, {}, 1};
    CHECK(agree(contract_output(b.model, output, state, rest), 0, 60, 1));
  }
}

}  // namespace elgen::test
