// monomial_angle: see monomial_angle.hpp.
#include "choose/monomial_angle.hpp"

#include <numeric>

#include "present/polynomial.hpp"

namespace elgen {

SplitMonomial split(const Algebra& algebra, const Monomial& monomial) {
  SplitMonomial result;
  for (const AtomPower& factor : monomial) {
    const bool is_circular = algebra.atoms[factor.atom].kind == AtomKind::circular;
    (is_circular ? result.angle : result.powers).push_back(factor);
  }
  return result;
}

std::int32_t common_divisor(const Monomial& angle) {
  std::int32_t result = 0;
  for (const AtomPower& part : angle) result = std::gcd(result, part.exponent);
  return result;
}

Monomial direction(const Monomial& angle) {
  const std::int32_t divisor = common_divisor(angle);
  Monomial result = angle;
  for (AtomPower& part : result) part.exponent /= angle.front().exponent < 0 ? -divisor : divisor;
  return result;
}

TwoPowers times_exponential(const TwoPowers& x, int sign) {
  const Gaussian i{0, sign};
  TwoPowers result;
  for (const auto& [powers, value] : x) {
    add_term(result, {powers.first + 1, powers.second}, value);
    add_term(result, {powers.first, powers.second + 1}, product(value, i));
  }
  return result;
}

}  // namespace elgen
