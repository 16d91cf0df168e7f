// Quaternions whose length is not 1: emitted code normalises every length, and its functions stay
// consistent with each other.
#include <catch2/catch.hpp>
#include <sstream>

#include "pipeline/pipeline_testing.hpp"

namespace elgen::test {
namespace {

/// Prints `right` if normalised quaternions are within 4 epsilon of (1, -2, 2, 4)/5.
constexpr const char* lengths = R"cpp(
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <limits>

#include "free_body/free_body.hpp"

  template <class Scalar>
  void print(std::initializer_list<Scalar> sizes) {
    double worst = 0;
    for (const Scalar s : sizes) {
      const auto q = free_body::normalized<Scalar>({}, {1, 2, 3, s, -2 * s, 2 * s, 4 * s});
      const Scalar exact[] = {Scalar(0.2), Scalar(-0.4), Scalar(0.4), Scalar(0.8)};
      for (int i = 0; i < 4; ++i) {
        const double off = std::abs(double(q[3 + i]) - double(exact[i]));
        worst = off <= worst ? worst : off / double(std::numeric_limits<Scalar>::epsilon());
      }
    }
    std::puts(worst <= 4 ? "right" : "wrong");
  }

  int main() {
    print<double>({1e-300, 1e-160, 1e-155, 1.0, 1e155, 1e160, 1e300});
    print<float>({1e-36F, 1e-30F, 1.0F, 1e30F, 1e36F});
  }
)cpp";

/// At |q| = 1.1 prints the largest of p - M v, 2 T - v.p, tau(a) - tau(0) - M a and the weight at
/// rest minus m g, in units of 64 epsilon. 64 epsilon is four rounding errors of numbers from
/// 32 to 64.
constexpr const char* drifted = R"cpp(
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "NAME/NAME.hpp"

  int main() {
    namespace body = NAME;
    const body::Parameters<double> p;
    const body::Coordinates<double> q{0.3, -2, 0.5, 0.66, -0.22, 0.44, 0.7378346698};
    const body::Velocities<double> v{0.1, 2, -1, 0.7, -0.4, 0.9}, a{1, -3, 0.2, 5, 2, -1};
    const auto m = body::mass_matrix(p, q);
    const auto momentum = body::momentum(p, q, v);
    const auto bias = body::inverse_dynamics(p, q, v, {});
    const auto tau = body::inverse_dynamics(p, q, v, a);
    double worst = std::abs(body::inverse_dynamics(p, q, {}, {})[2] - p.m * p.g);
    double twice = 0;
    for (std::size_t i = 0; i < 6; ++i) {
      double mv = 0, ma = 0;
      for (std::size_t j = 0; j < 6; ++j) {
        mv += m[6 * i + j] * v[j];
        ma += m[6 * i + j] * a[j];
      }
      worst = std::max({worst, std::abs(momentum[i] - mv), std::abs(tau[i] - bias[i] - ma)});
      twice += momentum[i] * v[i];
    }
    worst = std::max(worst, std::abs(2 * body::kinetic_energy(p, q, v) - twice));
    std::printf("%g", std::floor(worst / (64 * std::numeric_limits<double>::epsilon())));
  }
)cpp";

/// `normalized` keeps the quaternion at length 1, and conserved quantities drift only by the
/// integrator's error. Classical Runge-Kutta of order 4, step 1e-4 s, 100 s. Prints the largest
/// drifts.
constexpr const char* tumbling = R"cpp(
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
    p.g = 0;  // a fall of 50 km would hide the drift of the energy
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

TEST_CASE("with a quaternion of length 1.1, T, momentum and forces are consistent with M") {
  const Workspace folder;
  CHECK(printed(folder, replaced_all(drifted, "NAME", "free_body")) == "0");
  CHECK(printed(folder, replaced_all(drifted, "NAME", "quadrotor")) == "0");
}

TEST_CASE("quaternions of extreme length are normalised") {
  const Workspace folder;
  CHECK(printed(folder, lengths) == "right\nright\n");
}

TEST_CASE("a free body tumbles for a million steps without drift") {
  const Workspace folder;
  const std::string output = printed(folder, tumbling);
  double length = 1;
  double energy = 1;
  double momentum = 1;
  std::istringstream(output) >> length >> energy >> momentum;
  CAPTURE(output);
  CHECK(length <= 4 * 2.220446049250313e-16);
  CHECK(energy < 1e-12);
  CHECK(momentum < 1e-11);
}

}  // namespace elgen::test
