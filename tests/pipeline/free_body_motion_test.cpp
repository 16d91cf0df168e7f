// A million steps of the emitted free body: `normalized` keeps the quaternion of length 1, and what
// theory conserves is conserved as far as the integrator goes.
#include <catch2/catch.hpp>
#include <sstream>

#include "support/shell.hpp"

namespace elgen::test {
namespace {

/// Classical Runge-Kutta of order 4, step 1e-4 s, 100 s; prints the largest drifts.
constexpr const char* program = R"cpp(
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "free_body/free_body.hpp"

  namespace body = free_body;
  using Q = body::Coordinates<double>;
  using V = body::Velocities<double>;

  struct State {
    Q q;
    V v;
  };

  State plus(const State& x, const State& rate, double h) {
    State y = x;
    for (std::size_t i = 0; i < y.q.size(); ++i) y.q[i] += h * rate.q[i];
    for (std::size_t i = 0; i < y.v.size(); ++i) y.v[i] += h * rate.v[i];
    return y;
  }

  State rate(const body::Parameters<double>& p, const State& x) {
    return {body::coordinate_rates(p, x.q, x.v),
            body::forward_dynamics(p, x.q, x.v, {}).acceleration};
  }

  State step(const body::Parameters<double>& p, const State& x, double h) {
    const State a = rate(p, x);
    const State b = rate(p, plus(x, a, h / 2));
    const State c = rate(p, plus(x, b, h / 2));
    const State d = rate(p, plus(x, c, h));
    State y = plus(plus(x, a, h / 6), b, h / 3);
    y = plus(plus(y, c, h / 3), d, h / 6);
    y.q = body::normalized(p, y.q);
    return y;
  }

  double length(const Q& q) {
    return std::sqrt(q[3] * q[3] + q[4] * q[4] + q[5] * q[5] + q[6] * q[6]);
  }

  double spin(const body::Parameters<double>& p, const State& x) {
    const V m = body::momentum(p, x.q, x.v);
    return std::sqrt(m[3] * m[3] + m[4] * m[4] + m[5] * m[5]);
  }

  int main() {
    body::Parameters<double> p{};
    p.g = 0;  // falling 50 km would drown what is conserved
    State x{{0, 0, 0, 1, 0, 0, 0}, {1, 2, 3, 0.1, 5, 0.1}};
    const double energy = body::energy_function(p, x.q, x.v);
    const double momentum = spin(p, x);
    double off = 0, of_energy = 0, of_momentum = 0;
    for (int i = 0; i < 1000000; ++i) {
      x = step(p, x, 1e-4);
      off = std::max(off, std::abs(length(x.q) - 1));
      of_energy = std::max(of_energy, std::abs(body::energy_function(p, x.q, x.v) / energy - 1));
      of_momentum = std::max(of_momentum, std::abs(spin(p, x) / momentum - 1));
    }
    std::printf("%g %g %g\n", off, of_energy, of_momentum);
  }
)cpp";

}  // namespace

TEST_CASE("a free body tumbles for a million steps") {
  const Workspace folder;
  write_text(folder.path() / "motion.cpp", program);
  const std::string include = std::string(ELGEN_SOURCE_DIR) + "/generated";
  prepare("c++ -std=c++17 -O2 -I'" + include + "' motion.cpp -o motion", folder.path());
  const Outcome outcome = shell("./motion", folder.path());
  REQUIRE(outcome.status == 0);
  double length = 1;
  double energy = 1;
  double momentum = 1;
  std::istringstream(outcome.output) >> length >> energy >> momentum;
  CAPTURE(outcome.output);
  CHECK(length <= 4 * 2.220446049250313e-16);
  CHECK(energy < 1e-12);
  CHECK(momentum < 1e-11);
}

}  // namespace elgen::test
