// A scalar that is refused: SCALAR.
#include <Eigen/Core>
#include <complex>
#include <cstdint>
#include <limits>

#include "swing_fixed/swing_fixed.hpp"

/// Fixed point of 16 binary places, which says nothing of itself.
struct Fixed {
  std::int32_t raw = 0;

  Fixed() = default;
  Fixed(double x) : raw(static_cast<std::int32_t>(x * 65536)) {}
};

/// The same in a pair, and in a type that says what it is.
struct FixedPair {
  using value_type = Fixed;
  Fixed x, y;
};
struct Described {
  double x;
};
template <>
struct std::numeric_limits<Described> : std::numeric_limits<double> {
  static constexpr bool is_exact = true;
};

int main() { [[maybe_unused]] const swing_fixed::Parameters<SCALAR> p{}; }
