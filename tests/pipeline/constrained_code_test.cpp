// Programs that call emitted code of models with constraints. Computed torques move the pin of two
// joined arms along a circle. Andrews' mechanism moves for 0.03 s.
#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "pipeline/constrained_testing.hpp"

namespace elgen::test {
namespace {

/// Two arms of two links, driven at their pivots, joined at one pin.
const std::string two_arms = R"toml(format = 1
[model]
name = "two_arms"
[[coordinate]]
name = "a1"
unit = "rad"
start = { value = 2.07 }
[[coordinate]]
name = "b1"
unit = "rad"
start = { value = 0.54 }
[[coordinate]]
name = "a2"
unit = "rad"
start = { value = 0.58 }
[[coordinate]]
name = "b2"
unit = "rad"
start = { value = 2.29 }
[parameters]
w  = { value = 0.1,  unit = "m",  assume = "positive" }
l1 = { value = 0.25, unit = "m",  assume = "positive" }
l2 = { value = 0.35, unit = "m",  assume = "positive" }
m1 = { value = 0.8,  unit = "kg", assume = "positive" }
m2 = { value = 0.6,  unit = "kg", assume = "positive" }
g  = { value = 9.81, unit = "m/s^2" }
[[body]]
name = "left_crank"
mass = "m1"
com = ["-w + l1/2*cos(a1)", "l1/2*sin(a1)"]
spin = "dot(a1)"
inertia = "m1*l1^2/12"
[[body]]
name = "left_link"
mass = "m2"
com = ["-w + l1*cos(a1) + l2/2*cos(b1)", "l1*sin(a1) + l2/2*sin(b1)"]
spin = "dot(b1)"
inertia = "m2*l2^2/12"
[[body]]
name = "right_crank"
mass = "m1"
com = ["w + l1/2*cos(a2)", "l1/2*sin(a2)"]
spin = "dot(a2)"
inertia = "m1*l1^2/12"
[[body]]
name = "right_link"
mass = "m2"
com = ["w + l1*cos(a2) + l2/2*cos(b2)", "l1*sin(a2) + l2/2*sin(b2)"]
spin = "dot(b2)"
inertia = "m2*l2^2/12"
[[point]]
name = "P"
at = ["-w + l1*cos(a1) + l2*cos(b1)", "l1*sin(a1) + l2*sin(b1)"]
[[point]]
name = "Q"
at = ["w + l1*cos(a2) + l2*cos(b2)", "l1*sin(a2) + l2*sin(b2)"]
[gravity]
vector = ["0", "-g"]
[[input]]
name = "left"
unit = "N*m"
on = "a1"
[[input]]
name = "right"
unit = "N*m"
on = "a2"
[[constraint]]
name = "pin"
coincide = ["P", "Q"]
)toml";

/// Classical Runge-Kutta steps with constant inputs. Both programs below start with this text.
constexpr const char* runge_kutta = R"cpp(
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "NAME/NAME.hpp"

  namespace {

  namespace machine = NAME;
  using Q = machine::Coordinates<double>;
  using V = machine::Velocities<double>;
  using U = machine::Inputs<double>;
  const machine::Parameters<double> p{};

  struct State {
    Q q;
    V v;
  };

  State plus(State x, const State& rate, double h) {
    for (std::size_t i = 0; i < x.q.size(); ++i) x.q[i] += h * rate.q[i];
    for (std::size_t i = 0; i < x.v.size(); ++i) x.v[i] += h * rate.v[i];
    return x;
  }

  State rate(const State& x, const U& u) {
    return {x.v, machine::forward_dynamics(p, x.q, x.v, u).acceleration};
  }

  State step(const State& x, const U& u, double h, bool projects) {
    const State a = rate(x, u);
    const State b = rate(plus(x, a, h / 2), u);
    const State c = rate(plus(x, b, h / 2), u);
    const State d = rate(plus(x, c, h), u);
    const State y = plus(plus(plus(plus(x, a, h / 6), b, h / 3), c, h / 3), d, h / 6);
    if (!projects) return y;
    const auto there = machine::projected(p, y.q, y.v);
    return {there.coordinates, there.rates};
  }

  double gap(const State& x) {
    double largest = 0;
    const auto residual = machine::constraint_residual(p, x.q, x.v);
    for (const double f : residual.position) largest = std::max(largest, std::abs(f));
    return largest;
  }

  }  // namespace
)cpp";

/// The pin follows a circle of radius 0.08 m about (0, 0.4 m), four turns at one turn per second.
/// Every millisecond the torques are set to the motors' rows of tau - A^T lambda. Arguments: the
/// sign of lambda, and whether the plant is projected. Prints the largest errors of the motors, of
/// the pin, and of M a + bias = B u + A^T lambda in the plant.
constexpr const char* tracking = R"cpp(
  namespace {

  struct Wanted {
    Q q;
    V v, a;
  };

  /// The arm with coordinates k and k + 1; its pivot is at x = side * w, `side` = -1 or 1.
  void bend(double t, double side, std::size_t k, Wanted& to) {
    const double turn = 2 * std::acos(-1.0), c = 0.08 * std::cos(turn * t);
    const double s = 0.08 * std::sin(turn * t);
    const double x = c - side * p.w, y = 0.4 + s, r = std::hypot(x, y);
    const double reach = (r * r + p.l1 * p.l1 - p.l2 * p.l2) / (2 * p.l1 * r);
    const double a = std::atan2(y, x) - side * std::acos(reach);
    const double b = std::atan2(y - p.l1 * std::sin(a), x - p.l1 * std::cos(a));
    const double ca = p.l1 * std::cos(a), sa = p.l1 * std::sin(a);
    const double cb = p.l2 * std::cos(b), sb = p.l2 * std::sin(b);
    // -sa da - sb db = dx, ca da + cb db = dy
    const auto solve = [&](double dx, double dy, V& v) {
      const double det = ca * sb - cb * sa;
      v[k] = (cb * dx + sb * dy) / det;
      v[k + 1] = -(ca * dx + sa * dy) / det;
    };
    to.q[k] = a;
    to.q[k + 1] = b;
    solve(-turn * s, turn * c, to.v);
    const double of_a = to.v[k] * to.v[k], of_b = to.v[k + 1] * to.v[k + 1];
    solve(-turn * turn * c + ca * of_a + cb * of_b, -turn * turn * s + sa * of_a + sb * of_b, to.a);
  }

  Wanted wanted(double t) {
    Wanted result{};
    bend(t, -1, 0, result);
    bend(t, 1, 2, result);
    return result;
  }

  /// A^T lambda
  V held(const State& x, const std::array<double, machine::constraint_count>& lambda) {
    const auto jacobian = machine::constraint_jacobian(p, x.q);
    V result{};
    for (std::size_t i = 0; i < jacobian.size(); ++i) {
      result[i % result.size()] += jacobian[i] * lambda[i / result.size()];
    }
    return result;
  }

  U torques(const State& x, const Wanted& to, double sign) {
    V a{};
    for (std::size_t i = 0; i < a.size(); ++i) {
      a[i] = to.a[i] + 60 * (to.v[i] - x.v[i]) + 900 * (to.q[i] - x.q[i]);
    }
    const auto needed = machine::constrained_inverse_dynamics(p, x.q, x.v, a);
    const V tau = machine::inverse_dynamics(p, x.q, x.v, a);
    const V load = held(x, needed.multipliers);
    return {tau[0] - sign * load[0], tau[2] - sign * load[2]};
  }

  double unbalanced(const State& x, const U& u, double sign) {
    const auto motion = machine::forward_dynamics(p, x.q, x.v, u);
    const V load = held(x, motion.multipliers);
    V rest = machine::inverse_dynamics(p, x.q, x.v, motion.acceleration);
    rest[0] -= u[0];
    rest[2] -= u[1];
    double largest = 0;
    for (std::size_t i = 0; i < rest.size(); ++i) {
      largest = std::max(largest, std::abs(rest[i] - sign * load[i]));
    }
    return largest;
  }

  }  // namespace

  int main(int, char** arguments) {
    const double sign = std::atof(arguments[1]);
    const bool projects = std::atoi(arguments[2]) != 0;
    State x{wanted(0).q, wanted(0).v};
    double error = 0, apart = 0, rest = 0;
    for (int i = 0; i < 4000 && error < 1; ++i) {
      const Wanted to = wanted(i / 1000.0);
      const U u = torques(x, to, sign);
      for (const std::size_t k : {0UL, 2UL}) error = std::max(error, std::abs(to.q[k] - x.q[k]));
      apart = std::max(apart, gap(x));
      rest = std::max(rest, unbalanced(x, u, sign));
      x = step(x, u, 1e-3, projects);
    }
    std::printf("%.6e %.6e %.6e\n", error, apart, rest);
  }
)cpp";

/// Andrews' mechanism from START for 0.03 s. Argument: 1 if every step is projected, otherwise 0.
/// Prints the largest constraint residual, then the final coordinates.
constexpr const char* squeezing = R"cpp(
  int main(int, char** arguments) {
    const bool projects = std::atoi(arguments[1]) != 0;
    State x{{START}, {}};
    double apart = 0;
    for (int i = 0; i < 3000; ++i) {
      x = step(x, {}, 1e-5, projects);
      apart = std::max(apart, gap(x));
    }
    std::printf("%.6e", apart);
    for (const double q : x.q) std::printf(" %.17g", q);
    std::printf("\n");
  }
)cpp";

/// A folder with a program `main`, compiled with the emitted header of a model.
class Compiled {
 public:
  Compiled(const std::string& model, const std::vector<std::string>& outputs,
           const std::string& program) {
    std::string scene = "[outputs]\n";
    for (const std::string& output : outputs) scene += output + " = true\n";
    const Products products = derived(inputs_of(model, scene + "[emit]\nfiles = [\"header\"]\n"),
                                      {.goals = {Goal::emit}});
    for (const auto& [path, text] : products.files->files) folder_.write(path, text);
    const std::string name = products.checked->scene.base_name;
    folder_.write("main.cpp", replaced_all(runge_kutta, "NAME", name) + program);
    folder_.prepare("c++ -std=c++17 -O1 -Wall -Wextra -Werror -I. main.cpp -o main");
  }

  [[nodiscard]] std::vector<double> printed(const std::string& arguments) const {
    std::istringstream words(folder_.run("./main " + arguments).output);
    std::vector<double> numbers;
    for (std::string word; words >> word;) numbers.push_back(std::stod(word));
    return numbers;
  }

 private:
  Workspace folder_;
};

nlohmann::json reference() {
  std::ifstream file(ELGEN_SOURCE_DIR "/tests/reference/andrews.json");
  return nlohmann::json::parse(file);
}

ExactNumbers exact_numbers(const nlohmann::json& texts) {
  ExactNumbers numbers;
  for (const auto& text : texts) numbers.emplace_back(exact(text.get<std::string>()));
  return numbers;
}

double largest_distance(const std::vector<double>& found, const nlohmann::json& texts) {
  double largest = 0;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const double off = found.at(i) - std::stod(texts[i].get<std::string>());
    largest = std::max(largest, std::abs(off));
  }
  return largest;
}

}  // namespace

TEST_CASE(
    "two arms follow a circle by computed torque, but not with the wrong sign or unprojected") {
  const Compiled arms(two_arms,
                      {"inverse_dynamics", "forward_dynamics", "constraint_residual",
                       "constraint_jacobian", "projected", "constrained_inverse_dynamics"},
                      tracking);
  const std::vector<double> right = arms.printed("1 1");
  REQUIRE(right.size() == 3);
  CHECK(right[0] <= 1e-3);
  CHECK(right[1] <= 1e-12);
  CHECK(right[2] <= 1e-12);
  const std::vector<double> other_sign = arms.printed("-1 1");
  REQUIRE(other_sign.size() == 3);
  CHECK(other_sign[0] > 1e-2);
  CHECK(other_sign[2] > 1e-1);
  const std::vector<double> unprojected = arms.printed("1 0");
  REQUIRE(unprojected.size() == 3);
  CHECK(unprojected[1] > 1e-12);
}

TEST_CASE("Andrews' mechanism starts with the published values, in at most 800 operations") {
  const Constrained system(model_file("andrews"), "forward_dynamics");
  CHECK(operations(system.function(OutputKind::forward_dynamics)) <= 800);
  const nlohmann::json published = reference();
  State state = system.nominal();
  state.q = exact_numbers(published["start"]);
  const OutputKind forward = OutputKind::forward_dynamics;
  for (const char* field : {"acceleration", "multipliers"}) {
    const ExactNumbers expected = exact_numbers(published[field]);
    check_digits(system.truth(forward, field, state), expected, 25);
    check_digits(system.exactly(forward, field, state), expected, 25);
    check_close(system.double_field(forward, field, state), expected, 1e-14);
  }
}

TEST_CASE("Andrews' mechanism meets its constraints for 0.03 s, but not without projection") {
  const nlohmann::json published = reference();
  std::string start;
  for (const auto& q : published["start"]) start += q.get<std::string>() + ", ";
  const Compiled mechanism(model_file("andrews"),
                           {"forward_dynamics", "constraint_residual", "projected"},
                           replaced_all(squeezing, "START", start));
  const auto run = [&](const std::string& arguments) {
    std::vector<double> numbers = mechanism.printed(arguments);
    REQUIRE(numbers.size() == 8);
    const double gap = numbers.front();
    numbers.erase(numbers.begin());
    return std::pair(gap, largest_distance(numbers, published["end"]));
  };
  const std::pair<double, double> projected = run("1");
  const std::pair<double, double> free = run("0");
  CHECK(projected.first <= 1e-15);
  CHECK(free.first > 1e-12);
  CHECK(projected.second <= 3e-10);
  CHECK(free.second > 10 * projected.second);
}

}  // namespace elgen::test
