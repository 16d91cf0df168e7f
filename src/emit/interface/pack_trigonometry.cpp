// The order of the operations is that of templates/cpp/batch.hpp.mustache: every bit is the same.
#include "emit/interface/pack_trigonometry.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>

#include "numbers/exact_number.hpp"

namespace elgen {
namespace {

constexpr AngleReduction in_float{ScalarKind::single_precision,
                                  1e3,
                                  0x1.9218p+0,
                                  0x1.ed511p-14,
                                  0x1.45f306p-1,
                                  0x1.8p+23,
                                  0x1p-24};
constexpr AngleReduction in_double{
    ScalarKind::double_precision, 1e5,       0x1.921fb5444p+0, 0x1.68c234c4c6629p-39,
    0x1.45f306dc9c883p-1,         0x1.8p+52, 0x1p-53};

template <class Scalar>
std::vector<Scalar> coefficients_of(const SinePolynomial& polynomial) {
  std::vector<Scalar> coefficients;
  for (const double value : polynomial.coefficients) {
    coefficients.push_back(static_cast<Scalar>(value));
  }
  return coefficients;
}

/// coefficients[0] + coefficients[1] x + ..., by Horner's rule.
template <class Scalar>
Scalar polynomial(Scalar x, const std::vector<Scalar>& coefficients) {
  Scalar value = coefficients.back();
  for (std::size_t i = coefficients.size() - 1; i-- > 0;) value = value * x + coefficients[i];
  return value;
}

}  // namespace

const std::vector<SinePolynomial>& sine_polynomials() {
  static const std::vector<SinePolynomial> all{
#define ELGEN_SINE(degree, error, ...) {degree, error, {__VA_ARGS__}},
#define ELGEN_COSINE(degree, error, ...)
#include "emit/interface/sine_polynomials.def"
  };
  return all;
}

const std::vector<SinePolynomial>& cosine_polynomials() {
  static const std::vector<SinePolynomial> all{
#define ELGEN_SINE(degree, error, ...)
#define ELGEN_COSINE(degree, error, ...) {degree, error, {__VA_ARGS__}},
#include "emit/interface/sine_polynomials.def"
  };
  return all;
}

const AngleReduction& angle_reduction(ScalarKind scalar) {
  return scalar == ScalarKind::single_precision ? in_float : in_double;
}

const SinePolynomial& cheapest(const std::vector<SinePolynomial>& all, const cln::cl_RA& max_error,
                               ScalarKind scalar) {
  const cln::cl_RA rounding = exact_value(angle_reduction(scalar).rounding);
  const auto found = std::find_if(all.begin(), all.end(), [&](const SinePolynomial& polynomial) {
    return exact_value(polynomial.error) + rounding <= max_error;
  });
  return found == all.end() ? all.back() : *found;
}

template <class Scalar>
PackTrigonometry<Scalar>::PackTrigonometry(const Numerics& numerics)
    : reduction_(angle_reduction(scalar_kind<Scalar>)) {
  const cln::cl_RA error = trigonometry_error(numerics, scalar_kind<Scalar>);
  sine_ = coefficients_of<Scalar>(cheapest(sine_polynomials(), error, scalar_kind<Scalar>));
  cosine_ = coefficients_of<Scalar>(cheapest(cosine_polynomials(), error, scalar_kind<Scalar>));
}

template <class Scalar>
auto PackTrigonometry<Scalar>::of(Scalar angle) const -> Values {
  const auto [high, low] =
      std::pair{static_cast<Scalar>(reduction_.high), static_cast<Scalar>(reduction_.low)};
  if (!(std::abs(angle) <= static_cast<Scalar>(reduction_.domain))) {
    constexpr Scalar undefined = std::numeric_limits<Scalar>::quiet_NaN();
    return {undefined, undefined};
  }
  const auto shift = static_cast<Scalar>(reduction_.shift);
  const Scalar shifted = angle * static_cast<Scalar>(reduction_.inverse) + shift;
  const Scalar k = shifted - shift;
  const Scalar near = angle - k * high;
  const Scalar r = near - k * low;
  const Scalar rest = (near - r) - k * low;
  const Scalar square = r * r;
  const Scalar half = Scalar(0.5) * square;
  const Scalar most = Scalar(1) - half;
  Scalar sine = r + (r * square * polynomial(square, sine_) + rest);
  Scalar cosine = most + (((Scalar(1) - most) - half) +
                          (square * square * polynomial(square, cosine_) - r * rest));
  using Integer = std::conditional_t<sizeof(Scalar) == 4, std::uint32_t, std::uint64_t>;
  const auto quadrant = std::bit_cast<Integer>(shifted);
  if ((quadrant & 1) != 0) std::swap(sine, cosine);
  if ((quadrant & 2) != 0) sine = -sine;
  if (((quadrant + 1) & 2) != 0) cosine = -cosine;
  return {sine, cosine};
}

template class PackTrigonometry<double>;
template class PackTrigonometry<float>;

}  // namespace elgen
