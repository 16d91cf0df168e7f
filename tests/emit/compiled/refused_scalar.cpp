// Instantiates a function with SCALAR, a type that must be refused.
#include <Eigen/Core>
#include <complex>
#include <cstdint>
#include <limits>

#include "swing_fixed/swing_fixed.hpp"

/// Fixed point with 16 fractional bits, without std::numeric_limits.
struct Fixed {
  std::int32_t raw = 0;

  Fixed() = default;
  Fixed(double x) : raw(static_cast<std::int32_t>(x * 65536)) {}
};

/// A pair of fixed-point numbers.
struct FixedPair {
  using value_type = Fixed;
  Fixed x, y;
};
/// Counts as fixed point, because its std::numeric_limits are exact and bounded.
struct Described {
  double x;
};
template <>
struct std::numeric_limits<Described> : std::numeric_limits<double> {
  static constexpr bool is_exact = true;
};

int main() { [[maybe_unused]] const swing_fixed::Parameters<SCALAR> p{}; }
