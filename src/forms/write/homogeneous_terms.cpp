// homogeneous_terms: sums in which nothing cancels when a sine or cosine is 1.
//
//     A + (C - A) cos(x)^2   ->   A sin(x)^2 + C cos(x)^2        1 - cos(x)   ->   2 sin(x/2)^2
//
// Terms are grouped by the product of their atoms that are not exponentials. The coefficient of
// each such product is a sum of e^(i k x). Let c = cos x, s = sin x, and d the largest k of the
// sum. Then e^(i k x) = (c + i s)^((d + k)/2) (c - i s)^((d - k)/2) has d factors for every k. If
// both even and odd k occur, x/2 replaces x. Two sines, or two cosines, of different angles become
// one product:
//
//     sin(x) + sin(y)   ->   2 sin((x + y)/2) cos((x - y)/2)
#include <algorithm>
#include <numeric>

#include "forms/present/polynomial.hpp"
#include "forms/write/real_terms.hpp"

namespace elgen {
namespace {

/// Sums of a higher degree are too long to read, and gain nothing.
constexpr std::int32_t highest_degree = 8;

/// k -> coefficient of e^(i k x), for one direction x (primitive_angle() in real_terms.hpp). Only k
/// >= 0 is stored, because the coefficient of -k is the complex conjugate.
using Harmonics = std::map<std::int32_t, GaussianRational>;

/// The coefficient of one product of atoms that are not exponentials: a constant plus,
/// for each direction x, a weighted sum of e^(i k x).
struct ExponentialCoefficient {
  cln::cl_RA constant = 0;
  std::map<Monomial, Harmonics, MonomialLess> directions = {};
};

using CoefficientsByProduct = std::map<Monomial, ExponentialCoefficient, MonomialLess>;

CoefficientsByProduct coefficients_by_product(const Algebra& algebra, const Polynomial& sum) {
  CoefficientsByProduct factors;
  for (const auto& [monomial, coefficient] : sum) {
    const auto [powers, angle] = split_monomial(algebra, monomial);
    ExponentialCoefficient& factor = factors[powers];
    if (angle.empty()) {
      factor.constant = coefficient.real;
    } else if (angle.front().exponent > 0) {
      factor.directions[primitive_angle(angle)][common_divisor(angle)] = coefficient;
    }
  }
  // If there is only one direction, half the constant is stored at k = 0 of this direction.
  for (auto& [powers, factor] : factors) {
    if (factor.directions.size() != 1 || cln::zerop(factor.constant)) continue;
    factor.directions.begin()->second[0] = {factor.constant / 2, 0};
    factor.constant = 0;
  }
  return factors;
}

/// The largest base up to whole_angle_units for which all k/base are even integers, or all are odd
/// integers; 0 if no integer is such a base.
std::int32_t base_angle(const Harmonics& multiples) {
  std::int32_t base = whole_angle_units;
  for (const auto& [multiple, coefficient] : multiples) base = std::gcd(base, multiple);
  const auto is_odd = [&base](const auto& term) { return (term.first / base) % 2 != 0; };
  const auto odd = std::ranges::count_if(multiples, is_odd);
  if (odd == 0 || static_cast<std::size_t>(odd) == multiples.size()) return base;
  return base % 2 == 0 ? base / 2 : 0;
}

/// 2 Re sum(coefficient e^(i k x)), homogeneous in the sine and cosine of the angle `base` x.
CircularPolynomial expand_homogeneous(const Harmonics& multiples, std::int32_t base) {
  const std::int32_t degree = multiples.rbegin()->first / base;
  CircularPolynomial result;
  for (const auto& [multiple, coefficient] : multiples) {
    CircularPolynomial power{{{0, 0}, coefficient}};
    for (std::int32_t k = 0; k < (degree + multiple / base) / 2; ++k) {
      power = multiply_by_exponential(power, 1);
    }
    for (std::int32_t k = 0; k < (degree - multiple / base) / 2; ++k) {
      power = multiply_by_exponential(power, -1);
    }
    for (const auto& [powers, value] : power) {
      if (!cln::zerop(value.real)) add_term(result, powers, {value.real * 2, 0});
    }
  }
  return result;
}

/// coefficient sin(angle), or coefficient cos(angle).
struct Sinusoid {
  Monomial angle = {};
  cln::cl_RA coefficient = 0;
  bool is_sine = false;
};

/// The sine or cosine of k x for the only k of `multiples`, with x = `direction`. None if there are
/// several k, or both a sine and a cosine.
std::optional<Sinusoid> sinusoid_of(const Monomial& direction, const Harmonics& multiples) {
  if (multiples.size() != 1) return std::nullopt;
  const auto& [multiple, coefficient] = *multiples.begin();
  const bool is_sine = cln::zerop(coefficient.real);
  if (!is_sine && !cln::zerop(coefficient.imaginary)) return std::nullopt;
  return Sinusoid{power(direction, multiple),
                  is_sine ? coefficient.imaginary * -2 : coefficient.real * 2, is_sine};
}

/// Two sines or two cosines with equal or opposite coefficients, as one product; none otherwise.
/// Example:
///
///     sin x + sin y = 2 sin((x + y)/2) cos((x - y)/2)
std::optional<RealTerm> product_of_sinusoids(const Monomial& powers,
                                             const ExponentialCoefficient& factor) {
  if (factor.directions.size() != 2 || !cln::zerop(factor.constant)) return std::nullopt;
  const auto x = sinusoid_of(factor.directions.begin()->first, factor.directions.begin()->second);
  const auto y = sinusoid_of(factor.directions.rbegin()->first, factor.directions.rbegin()->second);
  if (!x || !y || x->is_sine != y->is_sine) return std::nullopt;
  const bool is_difference = x->coefficient == -y->coefficient;
  if (!is_difference && x->coefficient != y->coefficient) return std::nullopt;
  // None if (x + y)/2 or (x - y)/2 is not a multiple of the unit of angles.
  const auto sum = square_root(product(x->angle, y->angle));
  const auto difference = square_root(product(x->angle, power(y->angle, -1)));
  if (!sum || !difference) return std::nullopt;
  const bool has_sine_of_sum = x->is_sine != is_difference;
  const bool has_sine_of_difference = is_difference;
  const bool is_negative = !x->is_sine && is_difference;
  const auto sinusoid = [](const Monomial& angle, bool is_sine) {
    return CircularPower{angle, is_sine ? 0 : 1, is_sine ? 1 : 0};
  };
  return RealTerm{x->coefficient * (is_negative ? -2 : 2),
                  powers,
                  {sinusoid(*sum, has_sine_of_sum), sinusoid(*difference, has_sine_of_difference)}};
}

}  // namespace

std::optional<std::vector<RealTerm>> homogeneous_terms(const Algebra& algebra,
                                                       const Polynomial& sum, std::size_t most) {
  std::vector<RealTerm> terms;
  for (const auto& [powers, factor] : coefficients_by_product(algebra, sum)) {
    if (const auto product = product_of_sinusoids(powers, factor)) {
      terms.push_back(*product);
      continue;
    }
    if (!cln::zerop(factor.constant)) terms.push_back({factor.constant, powers, {}});
    for (const auto& [direction, multiples] : factor.directions) {
      const std::int32_t base = base_angle(multiples);
      if (base == 0 || multiples.rbegin()->first / base > highest_degree) return std::nullopt;
      const Monomial angle = power(direction, base);
      for (const auto& [exponents, value] : expand_homogeneous(multiples, base)) {
        terms.push_back({value.real, powers, {{angle, exponents.first, exponents.second}}});
      }
    }
    if (terms.size() > most) return std::nullopt;
  }
  return terms;
}

}  // namespace elgen
