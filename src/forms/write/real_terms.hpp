// real_terms: a canonical sum of exponentials as real terms, in one of several trigonometric forms.
//
//     -1/4 m e^(2i theta) + 1/2 m - 1/4 m e^(-2i theta)
//       multiple_angles   1/2 m - 1/2 m cos(2 theta)
//       by_cosines        m - m cos(theta)^2
//       by_sines          m sin(theta)^2
//       homogeneous       m sin(theta)^2
//
// In the homogeneous form, all terms with the same other factors have the same number of sines and
// cosines, so that nothing cancels when a sine or cosine is 1:
//
//     A + (C - A) cos(theta)^2   ->   A sin(theta)^2 + C cos(theta)^2
//     1 - cos(theta)             ->   2 sin(theta/2)^2
//
// "directions" keep functions of q1 + q2; "units" expand these into functions of q1 and q2.
#pragma once

#include <array>
#include <compare>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "elgen/closed_forms.hpp"

namespace elgen {

enum class Trigonometry : std::uint8_t {
  multiple_angles,
  directions_by_cosines,
  directions_by_sines,
  units_by_cosines,
  units_by_sines,
  homogeneous,
};

/// The forms that people write; the homogeneous form is only for code.
inline constexpr std::array trigonometries{
    Trigonometry::multiple_angles, Trigonometry::directions_by_sines,
    Trigonometry::directions_by_cosines, Trigonometry::units_by_sines,
    Trigonometry::units_by_cosines};

/// cos(x)^cosine sin(x)^sine, with x the sum of exponent * argument / divisor over the exponentials
/// in `angle`.
struct CircularPower {
  Monomial angle = {};
  std::int32_t cosine = 0;
  std::int32_t sine = 0;
  friend auto operator<=>(const CircularPower&, const CircularPower&) = default;
};

/// A term with real sines and cosines, in place of the complex exponentials of a Polynomial.
struct RealTerm {
  cln::cl_RA coefficient = 0;
  Monomial powers = {};  ///< of atoms that are not exponentials
  std::vector<CircularPower> circular = {};
  friend bool operator<(const RealTerm& x, const RealTerm& y) {
    return std::tie(x.coefficient, x.powers, x.circular) <
           std::tie(y.coefficient, y.powers, y.circular);
  }
};

/// The lengths that written_length() adds for a call, and for a multiple of an angle. These lengths
/// make sin(2*x)/2 no shorter than sin(x)*cos(x), whose factors also occur elsewhere. With
/// multiple_length = 0 the code of models/ is 4 % dearer, with 2 it is 2.5 % dearer; with 20 the
/// entries are 3 % longer.
inline constexpr std::size_t call_length = 2;
inline constexpr std::size_t multiple_length = 5;

/// The number of factors and signs of the written terms, plus call_length and multiple_length.
[[nodiscard]] std::size_t written_length(const Algebra& algebra,
                                         const std::vector<RealTerm>& terms);

/// The terms of `sum` in the shortest of the forms `trigonometries`; on a tie, in the earlier form.
/// None if every form has more than `most` terms.
[[nodiscard]] std::optional<std::vector<RealTerm>> shortest_terms(const Algebra& algebra,
                                                                  const Polynomial& sum,
                                                                  std::size_t most);

/// The terms of `sum` in the form `trigonometry`; none above `most` terms or for high powers.
[[nodiscard]] std::optional<std::vector<RealTerm>> real_terms(const Algebra& algebra,
                                                              const Polynomial& sum,
                                                              Trigonometry trigonometry,
                                                              std::size_t most);

/// The homogeneous form (homogeneous_terms.cpp). None if the form has more than `most` terms or too
/// high a degree. In a sum over several angles, terms without an angle are unchanged.
[[nodiscard]] std::optional<std::vector<RealTerm>> homogeneous_terms(const Algebra& algebra,
                                                                     const Polynomial& sum,
                                                                     std::size_t most);

/// The exponent k for which (e^(i x/12))^k = e^(i x).
inline constexpr std::int32_t whole_angle_units = 12;

/// The greatest common divisor of the exponents; 0 if `angle` is empty.
[[nodiscard]] std::int32_t common_divisor(const Monomial& angle);

/// The angle without its common divisor, and with a positive first exponent.
[[nodiscard]] Monomial primitive_angle(const Monomial& angle);

/// Exponents of the cosine and the sine of one angle -> coefficient.
using CircularPolynomial = std::map<std::pair<std::int32_t, std::int32_t>, GaussianRational>;

/// x (cos + i sin) for sign = 1; x (cos - i sin) for sign = -1.
[[nodiscard]] CircularPolynomial multiply_by_exponential(const CircularPolynomial& x, int sign);

}  // namespace elgen
