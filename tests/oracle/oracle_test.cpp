// Compares the oracle with closed forms and published values, and tests laws of mechanics.
#include "elgen/oracle.hpp"

#include <cln/float_io.h>
#include <cln/real_io.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "oracle/samples.hpp"
#include "support/matrices.hpp"

using namespace elgen;
using namespace elgen::test;
using cln::cl_R;
using Values = std::vector<cl_R>;

namespace {

std::vector<cl_R> reals(const nlohmann::json& texts) {
  std::vector<cl_R> values;
  for (const auto& text : texts) values.push_back(exact(text.get<std::string>()));
  return values;
}

nlohmann::json static_cases() {
  return nlohmann::json::parse(read_text(ELGEN_SOURCE_DIR "/tests/oracle/static_cases.json"))
      .at("cases");
}

ModelBuilder model_of(const nlohmann::json& c) {
  ModelBuilder b;
  std::uint32_t index = 0;
  for (const auto& name : c.at("coordinates")) {
    b.coordinate(name).input("u_" + std::string(name), index++);
  }
  for (const auto& [name, value] : c.at("parameters").items()) b.parameter(name, value);
  b.T(c.at("T")).V(c.at("V"));
  return b;
}

const std::map<std::string, OutputKind> kinds{
    {"mass_matrix", OutputKind::mass_matrix},
    {"gravity", OutputKind::gravity},
    {"bias", OutputKind::bias},
    {"kinetic_energy", OutputKind::kinetic_energy},
    {"potential_energy", OutputKind::potential_energy},
    {"acceleration", OutputKind::forward_dynamics},
};

void check_published(const std::string& id, const Model& model, const nlohmann::json& row) {
  State state = nominal_state(model, {});
  state.q = reals(row.at("q"));
  state.v = reals(row.at("v"));
  state.u = reals(row.at("u"));
  for (const auto& [name, texts] : row.at("expected").items()) {
    const Values expected = reals(texts);
    const OracleValues values = value_of(model, kinds.at(name), state);
    REQUIRE(values);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      CAPTURE(id, name, i);
      CHECK(agree((*values)[i], expected[i], 31));  // 32 digits are printed, the last is rounded
    }
  }
}

/// The working precision is 95 digits. A few operations and one cancellation lose at most 10.
constexpr int almost_all_digits = 85;

/// Compares an output with closed forms in the model's names, at four random states.
void check_closed_form(ModelBuilder b, OutputKind kind, const std::vector<std::string>& closed) {
  std::vector<ExpressionId> entries;
  for (const std::string& text : closed) entries.push_back(b.expression(text));
  for (unsigned seed = 1; seed <= 4; ++seed) {
    const State state = random_state(b.model, seed);
    const OracleValues values = value_of(b.model, kind, state);
    REQUIRE(values);
    REQUIRE(values->size() >= entries.size());
    for (std::size_t i = 0; i < entries.size(); ++i) {
      CAPTURE(closed[i], seed);
      const auto expected = oracle_expression_value(b.model, entries[i], state);
      REQUIRE(expected);
      CHECK(agree((*values)[i], *expected, almost_all_digits, 1));
    }
  }
}

cl_R dot(const Values& x, const Values& y) {
  cl_R sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) sum = sum + x[i] * y[i];
  return sum;
}

std::vector<ModelBuilder> quadratic_systems() {
  return {pendulum(),           cart_pole(),        double_pendulum(),
          spherical_pendulum(), charged_particle(), rotating_hoop("W*t + sin(t)/5")};
}

}  // namespace

TEST_CASE("published values of ten systems, some badly scaled or nearly singular") {
  for (const auto& c : static_cases()) {
    const ModelBuilder b = model_of(c);
    for (const auto& row : c.at("states")) check_published(c.at("id"), b.model, row);
  }
}

TEST_CASE("pendulum: closed forms") {
  const ModelBuilder b = pendulum();
  check_closed_form(b, OutputKind::mass_matrix, {"m*l^2"});
  check_closed_form(b, OutputKind::coriolis_matrix, {"0"});
  check_closed_form(b, OutputKind::gravity, {"m*g*l*sin(th)"});
  check_closed_form(b, OutputKind::bias, {"m*g*l*sin(th)"});
  check_closed_form(b, OutputKind::inverse_dynamics, {"m*l^2*th_dd + m*g*l*sin(th)"});
  check_closed_form(b, OutputKind::forward_dynamics, {"-g/l*sin(th)", "1"});
  check_closed_form(b, OutputKind::momentum, {"m*l^2*th_d"});
  check_closed_form(b, OutputKind::total_energy, {"m*l^2*th_d^2/2 - m*g*l*cos(th)"});
}

TEST_CASE("cart and pole: closed forms") {
  const ModelBuilder b = cart_pole();
  check_closed_form(b, OutputKind::mass_matrix, {"M + m", "m*l*cos(th)", "m*l*cos(th)", "m*l^2"});
  check_closed_form(b, OutputKind::coriolis_matrix, {"0", "-m*l*sin(th)*th_d", "0", "0"});
  check_closed_form(b, OutputKind::velocity_force, {"-m*l*sin(th)*th_d^2", "0"});
  check_closed_form(b, OutputKind::gravity, {"0", "-m*g*l*sin(th)"});
  check_closed_form(b, OutputKind::input_matrix, {"1", "0"});
  check_closed_form(
      b, OutputKind::forward_dynamics,
      {"(u + m*l*sin(th)*th_d^2 - m*g*sin(th)*cos(th))/(M + m*sin(th)^2)",
       "(g*sin(th) - cos(th)*(u + m*l*sin(th)*th_d^2 - m*g*sin(th)*cos(th))/(M + m*sin(th)^2))/l",
       "1", "(M + m*sin(th)^2)/(M + m)"});
}

TEST_CASE("double and spherical pendulum: closed forms") {
  const ModelBuilder two = double_pendulum();
  check_closed_form(
      two, OutputKind::mass_matrix,
      {"(m1 + m2)*l1^2", "m2*l1*l2*cos(th1 - th2)", "m2*l1*l2*cos(th1 - th2)", "m2*l2^2"});
  check_closed_form(two, OutputKind::velocity_force,
                    {"m2*l1*l2*sin(th1 - th2)*th2_d^2", "-m2*l1*l2*sin(th1 - th2)*th1_d^2"});
  const ModelBuilder sphere = spherical_pendulum();
  check_closed_form(sphere, OutputKind::mass_matrix, {"m*l^2", "0", "0", "m*l^2*sin(th)^2"});
  check_closed_form(sphere, OutputKind::coriolis_matrix,
                    {"0", "-m*l^2*sin(th)*cos(th)*ph_d", "m*l^2*sin(th)*cos(th)*ph_d",
                     "m*l^2*sin(th)*cos(th)*th_d"});
}

TEST_CASE("forces linear in the rates are drift: the magnetic force -q v x B") {
  const ModelBuilder b = charged_particle();
  check_closed_form(b, OutputKind::drift, {"-c*Bz*y_d", "c*Bz*x_d", "0"});
  check_closed_form(b, OutputKind::velocity_force, {"0", "0", "0"});
  check_closed_form(b, OutputKind::energy_function, {"m*(x_d^2 + y_d^2 + z_d^2)/2"});
  check_closed_form(b, OutputKind::potential_energy, {"0"});
  check_closed_form(b, OutputKind::total_energy,
                    {"m*(x_d^2 + y_d^2 + z_d^2)/2 - c*Bz/2*(x*y_d - y*x_d)"});
}

TEST_CASE("terms with explicit time are drift: the rotating hoop") {
  const ModelBuilder uniform = rotating_hoop("W*t");
  check_closed_form(uniform, OutputKind::drift, {"-m*R^2*W^2*sin(th)*cos(th)"});
  check_closed_form(uniform, OutputKind::energy_function,
                    {"m*R^2*(th_d^2 - W^2*sin(th)^2)/2 - m*g*R*cos(th)"});
  const ModelBuilder spun_up = rotating_hoop("W*t^2/2");
  check_closed_form(spun_up, OutputKind::bias, {"-m*R^2*(W*t)^2*sin(th)*cos(th) + m*g*R*sin(th)"});
}

TEST_CASE("a Lagrangian that is not quadratic in the rates: the relativistic particle") {
  const ModelBuilder b = relativistic_particle();
  check_closed_form(b, OutputKind::mass_matrix, {"m*(1 - x_d^2/c^2)^(-3/2)"});
  check_closed_form(b, OutputKind::bias, {"k*x"});
  check_closed_form(b, OutputKind::momentum, {"m*x_d/sqrt(1 - x_d^2/c^2)"});
  check_closed_form(b, OutputKind::energy_function, {"m*c^2/sqrt(1 - x_d^2/c^2) + k*x^2/2"});
  check_closed_form(b, OutputKind::forward_dynamics, {"-k*x/m*(1 - x_d^2/c^2)^(3/2)"});
}

TEST_CASE("a quadratic Lagrangian given as L: T0 counts as potential energy") {
  ModelBuilder b;
  b.coordinate("r", "m").parameter("m", "3").parameter("W", "2").parameter("k", "7");
  b.L("m*r_d^2/2 + m*W^2*r^2/2 - k*r^2/2 + m*r*r_d");
  check_closed_form(b, OutputKind::gravity, {"k*r - m*W^2*r"});
  check_closed_form(b, OutputKind::potential_energy, {"k*r^2/2 - m*W^2*r^2/2"});
  check_closed_form(b, OutputKind::kinetic_energy, {"m*r_d^2/2"});
  check_closed_form(b, OutputKind::drift, {"0"});
}

TEST_CASE("outside the domain there is no value, and nothing is thrown") {
  ModelBuilder b;
  b.coordinate("x").T("x_d^2/2").V("1/x + log(x) + sqrt(x)");
  const ExpressionId huge = b.expression("exp(exp(exp(x)))");
  State state = nominal_state(b.model, {});
  CHECK_FALSE(value_of(b.model, OutputKind::gravity, state));
  state.q[0] = -1;
  CHECK_FALSE(value_of(b.model, OutputKind::potential_energy, state));
  state.q[0] = 4;
  CHECK(agree((*value_of(b.model, OutputKind::gravity, state))[0], exact("7/16"), 90));
  CHECK_FALSE(oracle_expression_value(b.model, huge, state));
}

TEST_CASE("a singular mass matrix has no forward dynamics") {
  ModelBuilder b;
  b.coordinate("x").coordinate("y").T("(x_d + y_d)^2/2");
  CHECK(value_of(b.model, OutputKind::mass_matrix, random_state(b.model, 1)));
  CHECK_FALSE(value_of(b.model, OutputKind::forward_dynamics, random_state(b.model, 1)));
}

TEST_CASE("nominal_state takes parameters from the model and the scene") {
  const ModelBuilder b = cart_pole();
  Scene scene;
  scene.specialisation.fixed[1] = {3};
  const State state = nominal_state(b.model, scene);
  CHECK(state.parameters == Values{1, 3, exact("0.5"), exact("9.81")});
  CHECK(state.q == Values{0, 0});
  CHECK(state.u == Values{0});
}

TEST_CASE("law: M is symmetric and (dM/dq v) - 2 C is skew") {
  for (const ModelBuilder& b : quadratic_systems()) {
    const State state = random_state(b.model, 11);
    const std::size_t n = state.q.size();
    const Values c = *value_of(b.model, OutputKind::coriolis_matrix, state);
    const Values m = *value_of(b.model, OutputKind::mass_matrix, state);
    // dM/dq v by a central difference of exact values: error h^2, so 2 * 20 digits at h = 1e-20.
    const cl_R h = cln::expt(cl_R(10), -20);
    State ahead = state;
    State behind = state;
    for (std::size_t i = 0; i < n; ++i) {
      ahead.q[i] = state.q[i] + h * state.v[i];
      behind.q[i] = state.q[i] - h * state.v[i];
    }
    const Values after = *value_of(b.model, OutputKind::mass_matrix, ahead);
    const Values before = *value_of(b.model, OutputKind::mass_matrix, behind);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        const cl_R rate = (after[i * n + j] - before[i * n + j]) / (2 * h);
        CHECK(agree(rate, c[i * n + j] + c[j * n + i], 36, 1));
        CHECK(m[i * n + j] == m[j * n + i]);
      }
    }
  }
}

TEST_CASE("law: C v = velocity_force, and C e_j is the polar form of h(v) = C v") {
  for (const ModelBuilder& b : quadratic_systems()) {
    State state = random_state(b.model, 12);
    const Values v = state.v;
    const std::size_t n = v.size();
    const auto h = [&](const Values& rates) {
      state.v = rates;
      return *value_of(b.model, OutputKind::velocity_force, state);
    };
    const Values c = *value_of(b.model, OutputKind::coriolis_matrix, state);
    const Values coriolis = product(c, v, v.size());
    const Values force = h(v);
    for (std::size_t i = 0; i < n; ++i) {
      CHECK(agree(coriolis[i], force[i], almost_all_digits, 1));
      for (std::size_t j = 0; j < n; ++j) {
        Values unit(n, cl_R(0));
        unit[j] = 1;
        Values sum = v;
        sum[j] = sum[j] + 1;
        const cl_R polar = (h(sum)[i] - force[i] - h(unit)[i]) / 2;
        CHECK(agree(polar, c[i * n + j], almost_all_digits, 1));
      }
    }
  }
}

TEST_CASE("law: contractions agree with full outputs, and tau = M a + bias") {
  for (const ModelBuilder& b : quadratic_systems()) {
    const State state = random_state(b.model, 13);
    const Values w = random_state(b.model, 14).q;
    const Values m = *value_of(b.model, OutputKind::mass_matrix, state);
    const Values tau = *value_of(b.model, OutputKind::inverse_dynamics, state);
    const Values bias = *value_of(b.model, OutputKind::bias, state);
    const Values inertial = product(m, state.a, state.a.size());
    for (std::size_t i = 0; i < tau.size(); ++i) {
      CHECK(agree(tau[i], inertial[i] + bias[i], almost_all_digits, 1));
    }
    CHECK(
        agree(*oracle_contraction(b.model, {.kind = OutputKind::inverse_dynamics}, state, {w, {}}),
              dot(w, tau), almost_all_digits, 1));
    CHECK(
        agree(*oracle_contraction(b.model, {.kind = OutputKind::mass_matrix}, state, {w, state.a}),
              dot(w, inertial), almost_all_digits, 1));
  }
}

TEST_CASE("law: dE/dt = v.(B u + Q - dD/dv) under forward dynamics") {
  ModelBuilder b = cart_pole();
  b.D("th_d^2/10 + x_d^2/3").force_on(1, "-tanh(th_d) + abs(x_d)/7");
  const ExpressionId energy =
      b.expression("(M + m)*x_d^2/2 + m*l*cos(th)*x_d*th_d + m*l^2*th_d^2/2 + m*g*l*cos(th)");
  const ExpressionId leaf = b.expression("E");
  State state = random_state(b.model, 15);
  state.a = *value_of(b.model, OutputKind::forward_dynamics, state);
  const Values q = *value_of(b.model, OutputKind::applied_force, state);
  const Values d = *value_of(b.model, OutputKind::dissipation, state);
  const cl_R power = dot(state.v, q) - dot(state.v, d) + state.v[0] * state.u[0];
  CHECK(agree(*oracle_expression_rate(b.model, energy, state), power, almost_all_digits, 1));
  CHECK(agree(*oracle_expression_rate(b.model, leaf, state), power, almost_all_digits, 1));
}

TEST_CASE("a chain of 1000 points is evaluated without recursion") {
  const ModelBuilder b = chain(1000);
  const State state = nominal_state(b.model, {});
  Values w(1000, cl_R(0));
  w[0] = 1;
  Values y(1000, cl_R(0));
  y[999] = 1;
  // Hanging straight down: M_ij = m l^2 times the number of masses that both q_i and q_j move.
  OutputRequest mass;
  mass.kind = OutputKind::mass_matrix;
  CHECK(*oracle_contraction(b.model, mass, state, {w, w}) == exact("0.2") * 1000 * exact("0.09"));
  CHECK(*oracle_contraction(b.model, mass, state, {w, y}) == exact("0.2") * exact("0.09"));
  CHECK(*oracle_contraction(b.model, {.kind = OutputKind::inverse_dynamics}, state, {w, {}}) == 0);
}
