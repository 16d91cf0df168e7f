// The digits that emitted code keeps, however the energies are written.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "pipeline/pipeline_testing.hpp"
#include "program/evaluate/subject.hpp"

namespace elgen::test {

namespace {

struct Generated {
  Products products = {};

  [[nodiscard]] const Model& model() const { return products.checked->model; }
  [[nodiscard]] const Program& program() const { return *products.program; }
  [[nodiscard]] const Function& function(OutputKind kind) const {
    const Function* const found = find_function(program(), kind);
    REQUIRE(found != nullptr);
    return *found;
  }
};

/// max |x - x*|/(u R) of an output in double, also at extreme states; x* is exact, R the scale.
double loss_of(const Generated& g, OutputKind kind) {
  VerifyOptions options;
  options.is_quick = true;
  options.checks_extremes = true;
  const std::string subject = g.function(kind).name + " (double)";
  const Certificate certificate =
      verify(g.model(), g.products.checked->scene, g.program(), {}, options).certificate;
  for (const CertificateRow& row : certificate.rows) {
    if (row.check == "digits lost" && row.subject == subject) return *row.loss;
  }
  FAIL("no row");
  return 0;
}

Generated generated(const std::string& text, const std::string& scene = {}) {
  return {derived(inputs_of(text, scene), {.goals = {Goal::choose}})};
}

/// The products of the model in a scene with `prefer = "speed"`.
Generated generated_for_speed(const std::string& text) {
  return generated(text, "[numeric]\nprefer = \"speed\"\n");
}

/// The largest relative error of the first `entries` values of a function, in units of the epsilon
/// of `Scalar`.
template <class Scalar>
double worst_ulps(const Generated& g, OutputKind kind, const Arguments<Scalar>& at,
                  std::size_t entries) {
  const Function& function = g.function(kind);
  const std::vector<Scalar> values = evaluate(g.program(), function, at);
  const auto exact = [](Scalar x) { return Real(exact_value(static_cast<double>(x))); };
  const std::vector<Real> truth = evaluate(g.program(), function, map_leaves(exact, at));
  double worst = 0;
  for (std::size_t i = 0; i < entries; ++i) {
    const Real error = abs((exact(values[i]) - truth[i]) / truth[i]);
    worst = std::max(worst, to_double(error.value()));
  }
  return worst / static_cast<double>(std::numeric_limits<Scalar>::epsilon());
}

std::string one_coordinate(const std::string& potential) {
  return "format = 1\n[model]\nname = \"written\"\n[[coordinate]]\nname = \"x\"\n"
         "[parameters]\nm = { value = 2, assume = \"positive\" }\n"
         "g = { value = 9.81, assume = \"positive\" }\nk = { value = 30, assume = \"positive\" }\n"
         "l = { value = 0.75, assume = \"positive\" }\n"
         "[energy]\nT = \"1/2*m*dot(x)^2\"\nV = \"" +
         potential + "\"\n";
}

std::string two_coordinates(const std::string& potential) {
  return "format = 1\n[model]\nname = \"rest\"\n[[coordinate]]\nname = \"x\"\nrange = [-1, 1]\n"
         "[[coordinate]]\nname = \"y\"\nrange = [-1, 1]\n"
         "[parameters]\nk = { value = 3.7, assume = \"positive\" }\na = 0.7\n"
         "[energy]\nT = \"1/2*dot(x)^2 + 1/2*dot(y)^2\"\nV = \"" +
         potential + "\"\n";
}

/// The arguments of a model of two_coordinates(); all parameters are 3.7.
template <class Scalar>
Arguments<Scalar> at_positions(const Generated& g, Scalar x, Scalar y) {
  Arguments<Scalar> at = make_leaf_values<Scalar>(
      g.model(), [](Opcode, const auto&) { return Scalar(3.7); }, [](Opcode) { return Scalar(0); });
  at.q = {x, y};
  return at;
}

/// The force of V = 1/2*k*(cos(y - 0.7)*cos(x) - cos(0.7))^2 as a user types it.
template <class Scalar>
std::array<Scalar, 2> typed_force(Scalar x, Scalar y) {
  const auto k = Scalar(3.7);
  const auto angle = Scalar(0.7);
  const Scalar sum = std::cos(y - angle) * std::cos(x) - std::cos(angle);
  return {-k * sum * std::cos(y - angle) * std::sin(x),
          -k * sum * std::cos(x) * std::sin(y - angle)};
}

/// The force of the emitted code: 0 at rest, and beside it at most twice the error of the typed
/// force.
template <class Scalar>
void check_force(const Generated& g) {
  const Function& gravity = g.function(OutputKind::gravity);
  for (const Scalar force :
       evaluate(g.program(), gravity, at_positions<Scalar>(g, Scalar(0), Scalar(0)))) {
    CHECK(force == Scalar(0));
  }
  const auto exact = [](Scalar x) { return Real(exact_value(static_cast<double>(x))); };
  const Arguments<Scalar> at = at_positions<Scalar>(g, Scalar(1e-8), Scalar(6e-9));
  const std::vector<Scalar> force = evaluate(g.program(), gravity, at);
  const std::vector<Real> truth = evaluate(g.program(), gravity, map_leaves(exact, at));
  const std::array<Scalar, 2> typed = typed_force(at.q[0], at.q[1]);
  for (std::size_t i = 0; i < typed.size(); ++i) {
    INFO(i);
    const Real twice = abs(exact(typed[i]) - truth[i]) * Real(2);
    CHECK(to_double(abs(exact(force[i]) - truth[i]).value()) <= to_double(twice.value()));
  }
}

Arguments<double> at_position(const Generated& g, double x) {
  Arguments<double> at = make_leaf_values<double>(
      g.model(), [](Opcode, const auto&) { return 1.5; }, [](Opcode) { return 0.0; });
  at.parameters = {2, 9.81, 30, 0.75};
  at.q = {x};
  return at;
}

constexpr const char* double_pendulum = R"toml(format = 1
[model]
name = "pair"
[[coordinate]]
name = "q1"
unit = "rad"
[[coordinate]]
name = "q2"
unit = "rad"
[parameters]
m1 = { value = 1, unit = "kg", assume = "positive" }
m2 = { value = 1000, unit = "kg", assume = "positive" }
l1 = { value = 1, unit = "m", assume = "positive" }
l2 = { value = 1, unit = "m", assume = "positive" }
g = { value = 9.81, unit = "m/s^2", assume = "positive" }
[[point]]
name = "elbow"
mass = "m1"
at = ["l1*sin(q1)", "-l1*cos(q1)"]
[[point]]
name = "bob"
mass = "m2"
at = ["x(elbow) + l2*sin(q2)", "y(elbow) - l2*cos(q2)"]
[gravity]
vector = ["0", "-g"]
)toml";

}  // namespace

TEST_CASE("m g l (1 - cos(x)) keeps its digits at all angles, in both ways of writing") {
  for (const char* potential : {"m*g*l*(1 - cos(x))", "2*m*g*l*sin(x/2)^2"}) {
    INFO(potential);
    const Generated g = generated(one_coordinate(potential));
    for (double x = 3.1415; x > 1e-150; x *= 0.83) {
      REQUIRE(worst_ulps(g, OutputKind::potential_energy, at_position(g, x), 1) <= 6.5);
      REQUIRE(worst_ulps(g, OutputKind::potential_energy, at_position(g, -x), 1) <= 6.5);
    }
  }
}

TEST_CASE("a spring's extension keeps its digits if the extension is small") {
  const Generated g = generated(one_coordinate("k/2*(sqrt(l^2 + x^2) - l)^2"));
  for (double x = 0.75e8; x > 0.75e-75; x *= 0.37) {
    INFO(x);
    REQUIRE(worst_ulps(g, OutputKind::potential_energy, at_position(g, x), 1) <= 32);
  }
}

TEST_CASE("accelerations of two nearly aligned links keep their digits if one link is heavy") {
  const Generated g = generated(double_pendulum, "[numeric]\nscalar = [\"float\"]\n");
  Arguments<float> at = make_leaf_values<float>(
      g.model(), [](Opcode, const auto&) { return 0.F; }, [](Opcode) { return 0.F; });
  at.parameters = {1, 1000, 1, 1, 9.81F};
  for (float angle = 0.3F; angle < 1.4F; angle += 0.1F) {
    at.q = {angle, angle + 1e-3F};
    at.v = {0.7F, -1.1F};
    const double ulps = worst_ulps(g, OutputKind::forward_dynamics, at, 2);
    CHECK(ulps * std::numeric_limits<float>::epsilon() <= 1e-6);
  }
}

TEST_CASE("balance keeps digits that speed loses at extreme states") {
  const std::string cosine = one_coordinate("m*g*l*(1 - cos(x))");
  CHECK(loss_of(generated(cosine), OutputKind::potential_energy) <= 64);
  CHECK(loss_of(generated_for_speed(cosine), OutputKind::potential_energy) > 1e6);
  CHECK(loss_of(generated(double_pendulum), OutputKind::forward_dynamics) <= 64);
  CHECK(loss_of(generated_for_speed(double_pendulum), OutputKind::forward_dynamics) > 64);
}

TEST_CASE("cos(y - 0.7)*cos(x) - cos(0.7) is 0 at rest, in every scalar") {
  const Generated typed = generated(two_coordinates("1/2*k*(cos(y - 0.7)*cos(x) - cos(0.7))^2"));
  const Generated fixed = generated(two_coordinates("1/2*k*(cos(y - a)*cos(x) - cos(a))^2"),
                                    "[parameters]\nfixed = { a = 0.7 }\n");
  for (const Generated* g : {&typed, &fixed}) {
    check_force<double>(*g);
    check_force<float>(*g);
  }
}

TEST_CASE("other functions of a number vanish at rest, too") {
  for (const char* difference :
       {"exp(x + 0.3)*cos(y) - exp(0.3)", "log(x + 2.3)*cos(y) - log(2.3)"}) {
    INFO(difference);
    const Generated g = generated(two_coordinates("1/2*k*(" + std::string(difference) + ")^2"));
    const Function& gravity = g.function(OutputKind::gravity);
    for (const double force : evaluate(g.program(), gravity, at_positions(g, 0.0, 0.0)))
      CHECK(force == 0);
    for (const float force : evaluate(g.program(), gravity, at_positions(g, 0.F, 0.F)))
      CHECK(force == 0.F);
  }
}

TEST_CASE("sqrt(x^2 + l^2) - x has no accurate form for both signs of x, and a loss is reported") {
  const Generated g = generated(one_coordinate("k*l*(sqrt(x^2 + l^2) - x)"));
  CHECK(loss_of(g, OutputKind::potential_energy) > 64);
}

}  // namespace elgen::test
