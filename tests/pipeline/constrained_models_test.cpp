// Whole models with constraints: proved closed forms, poles, published numbers, and code in all
// languages.
#include <array>
#include <catch2/catch.hpp>

#include "pipeline/constrained_testing.hpp"
#include "verify/structure/expectations.hpp"

namespace elgen::test {
namespace {

using cln::cl_R;

/// A mass m at (x, y) on a rod of length l; `more` continues the constraint.
std::string mass_on_rod(const std::string& parameters, const std::string& more = {}) {
  return "format = 1\n[model]\nname = \"rod\"\n[[coordinate]]\nname = \"x\"\n"
         "start = { value = 0, rate = 3.9 }\n[[coordinate]]\nname = \"y\"\n"
         "start = { value = -1.3 }\n[parameters]\n" +
         parameters +
         "[[point]]\nname = \"bob\"\nat = [\"x\", \"y\"]\nmass = \"m\"\n"
         "[gravity]\nvector = [\"0\", \"-g\"]\n"
         "[[constraint]]\nname = \"rod\"\nequation = \"x^2 + y^2 = l^2\"\n" +
         more;
}

const std::string symbols_of_rod =
    "m = { value = 1.5, assume = \"positive\" }\nl = { value = 1.3, assume = \"positive\" }\n"
    "g = { value = 9.81, assume = \"positive\" }\n";

/// A rolling wheel of radius r, with inertia J about its axle and K about the vertical. The disc in
/// models/ has other names of coordinates and parameters.
const std::string wheel = R"toml(format = 1
[model]
name = "wheel"
[[coordinate]]
name = "east"
[[coordinate]]
name = "north"
[[coordinate]]
name = "roll"
[[coordinate]]
name = "yaw"
[parameters]
m = { value = 3.7, assume = "positive" }
r = { value = 0.45, assume = "positive" }
J = { value = 0.31, assume = "positive" }
K = { value = 0.17, assume = "positive" }
[energy]
T = "1/2*m*(dot(east)^2 + dot(north)^2) + 1/2*J*dot(roll)^2 + 1/2*K*dot(yaw)^2"
[[input]]
name = "drive"
on = "roll"
[[input]]
name = "turn"
on = "yaw"
[[constraint]]
name = "slip"
kind = "velocity"
equation = ["dot(east) = r*cos(yaw)*dot(roll)", "dot(north) = r*sin(yaw)*dot(roll)"]
)toml";

/// A position constraint and a velocity constraint, with gains and time.
const std::string both_kinds = R"toml(format = 1
[model]
name = "both_kinds"
[[coordinate]]
name = "x"
start = { value = 1 }
[[coordinate]]
name = "y"
[[coordinate]]
name = "z"
[parameters]
m = { value = 2, assume = "positive" }
l = { value = 1, assume = "positive" }
w = 3
[energy]
T = "1/2*m*(dot(x)^2 + dot(y)^2 + (1 + x^2)*dot(z)^2)"
[[input]]
name = "u"
on = "x"
[[constraint]]
name = "rod"
equation = "x^2 + y^2 = l^2 + sin(t)/5"
stabilise = { omega = "w", zeta = 1 }
[[constraint]]
name = "slide"
kind = "velocity"
equation = "dot(y) = x*dot(z) + t"
)toml";

/// The evidence for each [[expect]] row, and the number of wrong rows.
struct ExpectationResult {
  std::vector<Evidence> evidence = {};
  std::size_t wrong = 0;
};

ExpectationResult check_forms(const std::string& text) {
  Products products = derived(inputs_of(text), "forward_dynamics");
  REQUIRE(products.closed_forms);
  const auto& [model, scene] = *products.checked;
  const ExpectationReport report =
      check_expectations({model, scene, *products.program}, &*products.closed_forms, 1);
  ExpectationResult result;
  for (const CertificateRow& row : report.rows) result.evidence.push_back(row.evidence);
  result.wrong = report.diagnostics.size();
  return result;
}

void check_proved(const std::string& text, std::size_t entries) {
  const ExpectationResult forms = check_forms(text);
  CHECK(forms.wrong == 0);
  CHECK(forms.evidence == std::vector<Evidence>(entries, Evidence::proof));
}

/// The coefficients c_0, ..., c_n = 1 of det(s - A), by the Faddeev-LeVerrier algorithm.
template <class Number>
std::vector<Number> characteristic(const std::vector<Number>& a, std::size_t n) {
  std::vector<Number> coefficients(n + 1, Number(0));
  coefficients[n] = Number(1);
  std::vector<Number> product(n * n, Number(0));  // A M_k
  for (std::size_t k = 1; k <= n; ++k) {
    std::vector<Number> next(n * n, Number(0));
    for (std::size_t i = 0; i < n; ++i) {
      product[i * n + i] = product[i * n + i] + coefficients[n - k + 1];
    }
    Number trace = Number(0);
    for (std::size_t i = 0; i < n * n; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        next[i] = next[i] + a[i / n * n + j] * product[j * n + i % n];
      }
      if (i / n == i % n) trace = trace + next[i];
    }
    coefficients[n - k] = -trace / Number(static_cast<int>(k));
    product = next;
  }
  return coefficients;
}

/// The coefficients of (s^2 + k) (s^2 + 2 zeta omega s + omega^2), lowest first.
ExactNumbers two_factors(const cl_R& k, const cl_R& omega, const cl_R& zeta) {
  const cl_R damping = 2 * zeta * omega;
  const cl_R square = omega * omega;
  return {k * square, k * damping, k + square, damping, 1};
}

/// The (db, dc) that solve A (0, db, dc) = right; `a` is the row-major 2 x 3 matrix A.
std::array<cl_R, 2> followers(const ExactNumbers& a, const ExactNumbers& right) {
  const cl_R determinant = a[1] * a[5] - a[2] * a[4];
  return {(right[0] * a[5] - a[2] * right[1]) / determinant,
          (a[1] * right[1] - a[4] * right[0]) / determinant};
}

ExactNumbers negatives(ExactNumbers values) {
  for (cl_R& value : values) value = -value;
  return values;
}

/// `state` with the second and third angle and rate of the closed four-bar linkage. Newton's method
/// starts at the angles of `state`.
State closed_loop(const Constrained& system, State state) {
  const auto jacobian = [&] { return system.truth(OutputKind::constraint_jacobian, "", state); };
  for (int i = 0; i < 8; ++i) {
    const auto change = followers(
        jacobian(), negatives(system.truth(OutputKind::constraint_residual, "position", state)));
    state.q[1] = state.q[1] + change[0];
    state.q[2] = state.q[2] + change[1];
  }
  const ExactNumbers a = jacobian();
  const auto rates = followers(a, {-a[0] * state.v[0], -a[3] * state.v[0]});
  state.v[1] = rates[0];
  state.v[2] = rates[1];
  return state;
}

/// Checks that the numbers agree with the texts to 18 digits after the point.
void check_places(const ExactNumbers& found, const std::vector<std::string>& texts) {
  REQUIRE(found.size() == texts.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    INFO("entry " << i);
    CHECK(cln::abs(found[i] - exact(texts[i])) <= power_of_ten(-18));
  }
}

const std::string dynamics_and_constraints =
    "forward_dynamics,constraint_residual,constraint_jacobian,constrained_inverse_dynamics";

}  // namespace

TEST_CASE(
    "the force in a rod is proved with and without gains, and disproved with the other sign") {
  const std::string expect = "[[expect]]\nmultipliers = [\"";
  const std::string lambda = "m*(dot(x)^2 + dot(y)^2 - g*y)/(2*(x^2 + y^2))";
  const std::string gains = symbols_of_rod + "w = 7\nzeta = 0.9\n";
  const std::string stabilised = "stabilise = { omega = \"w\", zeta = \"zeta\" }\n";
  const std::string errors =
      " - m*(4*zeta*w*(x*dot(x) + y*dot(y)) + w^2*(x^2 + y^2 - l^2))/(4*(x^2 + y^2))";
  check_proved(mass_on_rod(symbols_of_rod, expect + "-" + lambda + "\"]\n"), 1);
  check_proved(mass_on_rod(gains, stabilised + expect + "-" + lambda + errors + "\"]\n"), 1);
  CHECK(check_forms(mass_on_rod(symbols_of_rod, expect + lambda + "\"]\n")).wrong == 1);
}

TEST_CASE("the four accelerations and two forces of a rolling disc are proved") {
  const std::string forces = R"toml([[expect]]
multipliers = [
  "m*r*(cos(yaw)*drive/(J + m*r^2) - sin(yaw)*dot(yaw)*dot(roll))",
  "m*r*(sin(yaw)*drive/(J + m*r^2) + cos(yaw)*dot(yaw)*dot(roll))",
]
)toml";
  const std::string accelerations = R"toml(forward_dynamics = [
  "r*(cos(yaw)*drive/(J + m*r^2) - sin(yaw)*dot(yaw)*dot(roll))",
  "r*(sin(yaw)*drive/(J + m*r^2) + cos(yaw)*dot(yaw)*dot(roll))",
  "drive/(J + m*r^2)",
  "turn/K",
]
)toml";
  check_proved(wheel + forces + accelerations, 6);
}

TEST_CASE("a rod at rest has the poles of the pendulum and of its gains") {
  const Constrained rod(mass_on_rod(symbols_of_rod + "w = 7\nzeta = 0.9\n",
                                    "stabilise = { omega = \"w\", zeta = \"zeta\" }\n"),
                        "linearization,forward_dynamics");
  State state = rod.nominal();
  state.q[1] = -state.parameters[1];
  const cl_R k = state.parameters[2] / state.parameters[1];
  const ExactNumbers expected = two_factors(k, 7, exact("0.9"));
  check_digits(characteristic(rod.truth(OutputKind::linearization, "A", state), 4), expected, 60);
  check_digits(characteristic(rod.exactly(OutputKind::linearization, "A", state), 4), expected, 55);
  check_close(characteristic(rod.double_field(OutputKind::linearization, "A", state), 4), expected,
              1e-12);
}

TEST_CASE("without the derivative of A^T lambda a pendulum at rest would not swing") {
  const Constrained rod(mass_on_rod(symbols_of_rod + "w = 7\nzeta = 0.9\n",
                                    "stabilise = { omega = \"w\", zeta = \"zeta\" }\n"),
                        "linearization,forward_dynamics");
  State state = rod.nominal();
  state.q[1] = -state.parameters[1];
  ExactNumbers a = rod.exactly(OutputKind::linearization, "A", state);
  const cl_R lambda = rod.exactly(OutputKind::forward_dynamics, "multipliers", state)[0];
  // The gradient of A^T lambda is 2 lambda I. On the hanging rod only x changes. This removes the
  // term 2 lambda/m from the linearization.
  a[2 * 4 + 0] = a[2 * 4 + 0] - 2 * lambda / state.parameters[0];
  check_digits(characteristic(a, 4), two_factors(0, 7, exact("0.9")), 55);
}

TEST_CASE("a four-bar linkage has its known pose, accelerations and forces") {
  const Constrained system(model_file("four_bar"), dynamics_and_constraints);
  State state = system.nominal();
  state.q = {1, exact("0.5"), exact("1.2")};
  state.v = {2, 0, 0};
  state.u = {5};
  state = closed_loop(system, state);
  check_places({state.q[1], state.q[2]}, {"0.5261740722979267645", "1.1757119813588347726"});
  const ExactNumbers a = system.truth(OutputKind::forward_dynamics, "acceleration", state);
  const ExactNumbers lambda = system.truth(OutputKind::forward_dynamics, "multipliers", state);
  check_places(a, {"-6.644419575744477878", "3.385009891674967249", "-0.175214548123991531"});
  check_places(lambda, {"8.410846735010850486", "10.966355157526121513"});
  check_field(system, OutputKind::forward_dynamics, "acceleration", state, a);
  check_field(system, OutputKind::forward_dynamics, "multipliers", state, lambda);
  state.a = a;
  const OutputKind inverse = OutputKind::constrained_inverse_dynamics;
  check_field(system, inverse, "inputs", state, {5});
  check_field(system, inverse, "multipliers", state, lambda);
  for (const cl_R& rest : system.truth(inverse, "unbalanced", state)) {
    CHECK(cln::abs(rest) <= power_of_ten(-40));
  }
  for (const double rest : system.double_field(inverse, "unbalanced", state)) {
    CHECK(std::abs(rest) <= 1e-13 * double_of(max_magnitude(lambda)));
  }
}

TEST_CASE("a four-bar linkage is assembled near its start, with consistent rates") {
  const Constrained system(model_file("four_bar"), dynamics_and_constraints);
  State state = system.nominal();
  state.q = {1, exact("0.5"), exact("1.2")};
  state.v = {2, 0, 0};
  const std::optional<State> at = oracle_assembled_state(system.model(), state);
  REQUIRE(at);
  for (const char* field : {"position", "rate"}) {
    for (const cl_R& off : system.truth(OutputKind::constraint_residual, field, *at)) {
      CHECK(cln::abs(off) <= power_of_ten(-40));
    }
  }
  const State closed = closed_loop(system, *at);
  check_digits(at->q, closed.q, 35);
  check_digits(at->v, closed.v, 35);
  CHECK(std::abs(double_of(at->q[0]) - 1) < 0.1);
}

TEST_CASE("models with constraints are emitted in all languages and compared") {
  const Workspace folder;
  folder.write("model.toml", both_kinds);
  const std::string outputs =
      "[outputs]\nforward_dynamics = true\nconstraint_residual = true\n"
      "constraint_jacobian = true\nconstraint_bias = true\nprojected = true\n"
      "constrained_inverse_dynamics = true\n";
  const auto scene = [&](const std::string& name, const std::string& rest) {
    folder.write(name + ".scene.toml",
                 "format = 1\nmodel = \"model.toml\"\nname = \"" + name + "\"\n" + outputs + rest);
  };
  scene("cpp", "[emit]\neigen = true\nbatch = true\n");
  scene("c", "[emit]\nlanguage = \"c99\"\n");
  CHECK(failure_of(folder.run(
            "elgen verify --build written -v --samples 8 cpp.scene.toml c.scene.toml")) == "");
}

}  // namespace elgen::test
