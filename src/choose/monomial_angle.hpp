// monomial_angle: the angle in a product of atoms: e^(i angle) is what its circular atoms make.
#pragma once

#include <map>
#include <utility>

#include "elgen/closed_forms.hpp"

namespace elgen {

/// The power of e^(i x/12) that is e^(i x).
inline constexpr std::int32_t whole_angle = 12;

struct SplitMonomial {
  Monomial powers;  ///< of all other atoms
  Monomial angle;
};

[[nodiscard]] SplitMonomial split(const Algebra& algebra, const Monomial& monomial);

/// Of the exponents; 0 of no angle.
[[nodiscard]] std::int32_t common_divisor(const Monomial& angle);

/// Without common divisor; the first part positive.
[[nodiscard]] Monomial direction(const Monomial& angle);

/// Exponents of the cosine and the sine of one angle -> coefficient.
using TwoPowers = std::map<std::pair<std::int32_t, std::int32_t>, Gaussian>;

/// x (cos + i sin), or x (cos - i sin).
[[nodiscard]] TwoPowers times_exponential(const TwoPowers& x, int sign);

}  // namespace elgen
