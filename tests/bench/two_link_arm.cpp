// M, C and g of the two-link arm: the emitted `dynamics` and the equations of a textbook, timed in
// one run.
#include <array>
#include <cmath>
#include <cstdio>

#include "timing.hpp"
#include "two_link_arm_terms/two_link_arm_terms.hpp"

namespace {

namespace emitted = two_link_arm_terms;
using Parameters = emitted::Parameters<double>;
using Pair = std::array<double, 2>;

using Terms = emitted::Dynamics<double>;

/// M, C and g by Siciliano et al. (2009), section 7.3.2, with the usual abbreviations.
Terms by_hand(const Parameters& p, const Pair& q, const Pair& v) {
  const double a = p.I1 + p.I2 + p.m1 * p.c1 * p.c1 + p.m2 * (p.l1 * p.l1 + p.c2 * p.c2);
  const double b = p.m2 * p.l1 * p.c2;
  const double d = p.I2 + p.m2 * p.c2 * p.c2;
  const double c2 = std::cos(q[1]);
  const double s2 = std::sin(q[1]);
  const double h = -b * s2;
  const double m12 = d + b * c2;
  const double g2 = p.m2 * p.c2 * p.g * std::cos(q[0] + q[1]);
  return {{a + 2 * b * c2, m12, m12, d},
          {h * v[1], h * (v[0] + v[1]), -h * v[0], 0.0},
          {(p.m1 * p.c1 + p.m2 * p.l1) * p.g * std::cos(q[0]) + g2, g2}};
}

volatile double sink = 0.0;

template <class Evaluate>
std::function<void(int)> repeated(Evaluate evaluate) {
  return [evaluate](int calls) {
    const Parameters parameters;
    Pair q{0.3, -0.7};
    const Pair v{1.1, 0.4};
    double sum = 0.0;
    for (int i = 0; i < calls; ++i) {
      const Terms terms = evaluate(parameters, q, v);
      // Makes the next call depend on this one, as in an integrator.
      q[0] += 1e-9 * terms.gravity[0];
      q[1] += 1e-9 * terms.coriolis_matrix[1] * terms.mass_matrix[1];
      sum += terms.mass_matrix[0] + terms.coriolis_matrix[0] + terms.coriolis_matrix[2] +
             terms.gravity[1];
    }
    sink = sum;
  };
}

}  // namespace

int main() {
  const Parameters p;
  const Terms hand = by_hand(p, {0.3, -0.7}, {1.1, 0.4});
  const Terms own = emitted::dynamics(p, {0.3, -0.7}, {1.1, 0.4});
  for (std::size_t i = 0; i < 4; ++i) {
    if (std::abs(hand.mass_matrix[i] - own.mass_matrix[i]) > 1e-14) return 1;
    if (std::abs(hand.coriolis_matrix[i] - own.coriolis_matrix[i]) > 1e-14) return 1;
  }
  const auto generated = [](const Parameters& at, const Pair& q, const Pair& v) {
    return emitted::dynamics(at, q, v);
  };
  const std::vector<double> ns =
      bench::medians({repeated(by_hand), repeated(generated)}, 20000, 401);
  std::printf("two_link_arm, M, C and g: by hand %.1f ns, emitted %.1f ns, ratio %.2f\n", ns[0],
              ns[1], ns[1] / ns[0]);
}
