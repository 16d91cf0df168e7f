// SineEvaluator: the operations of templates/cpp/trigonometry.hpp.mustache and
// templates/c99/sine_cosine.h.mustache in the same order, so that all bits of the results agree.
#include "program/evaluate/sines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string_view>
#include <type_traits>
#include <utility>

#include "numbers/exact_number.hpp"

namespace elgen {
namespace {

/// Length of the longest row of sine_polynomials.def.
constexpr std::size_t most_coefficients = 6;

template <class Scalar>
std::vector<Scalar> coefficients_of(const SinePolynomial& polynomial) {
  std::vector<Scalar> coefficients;
  for (const double value : polynomial.coefficients) {
    coefficients.push_back(static_cast<Scalar>(value));
  }
  return coefficients;
}

/// coefficients[0] + coefficients[1] x + ..., by Estrin's scheme: sums of neighbours, then sums of
/// neighbouring sums.
template <class Scalar>
Scalar evaluate_polynomial(Scalar x, const std::vector<Scalar>& coefficients) {
  assert(coefficients.size() <= most_coefficients);
  std::array<Scalar, most_coefficients> terms{};  // a vector would be allocated for every sine
  std::ranges::copy(coefficients, terms.begin());
  for (std::size_t count = coefficients.size(); count > 1; count = (count + 1) / 2) {
    for (std::size_t i = 0; i < count; i += 2) {
      terms[i / 2] = i + 1 < count ? terms[i] + terms[i + 1] * x : terms[i];
    }
    x = x * x;
  }
  return terms.front();
}

}  // namespace

const std::vector<SinePolynomial>& sine_polynomials() {
  static const std::vector<SinePolynomial> all{
#define ELGEN_SINE(degree, error, ...) {degree, error, {__VA_ARGS__}},
#define ELGEN_COSINE(degree, error, ...)
#include "program/evaluate/sine_polynomials.def"
  };
  return all;
}

const std::vector<SinePolynomial>& cosine_polynomials() {
  static const std::vector<SinePolynomial> all{
#define ELGEN_SINE(degree, error, ...)
#define ELGEN_COSINE(degree, error, ...) {degree, error, {__VA_ARGS__}},
#include "program/evaluate/sine_polynomials.def"
  };
  return all;
}

/// k (sines.hpp) times every part except the last is exact. Float: 14, 13 and 13 bits times a k of
/// 10 bits fit 24 bits. Double: 35 and 33 bits times a k of 16 bits fit 53 bits. No float up to 1e3
/// is nearer to a multiple of pi/2 than 2^-28, no double up to 1e5 is nearer than 2^-61. So the
/// last part limits the error next to multiples of pi/2 to 0.5 ulp.
const AngleReduction& angle_reduction(ScalarKind scalar) {
  static const AngleReduction in_float{ScalarKind::single_precision,
                                       1e3,
                                       {0x1.9218p+0, 0x1.ed5p-14, 0x1.10bp-30, 0x1.184698p-44},
                                       0x1.45f306p-1,
                                       0x1.8p+23,
                                       0x1p-24};
  static const AngleReduction in_double{ScalarKind::double_precision,
                                        1e5,
                                        {0x1.921fb5444p+0, 0x1.68c234c4p-39, 0x1.8cc51701b839ap-72},
                                        0x1.45f306dc9c883p-1,
                                        0x1.8p+52,
                                        0x1p-53};
  return scalar == ScalarKind::single_precision ? in_float : in_double;
}

const SinePolynomial& lowest_degree_polynomial(const std::vector<SinePolynomial>& all,
                                               const cln::cl_RA& max_error, ScalarKind scalar) {
  const cln::cl_RA rounding = exact_value(angle_reduction(scalar).rounding);
  const auto found = std::find_if(all.begin(), all.end(), [&](const SinePolynomial& polynomial) {
    return exact_value(polynomial.error) + rounding <= max_error;
  });
  return found == all.end() ? all.back() : *found;
}

cln::cl_RA sine_error(const Numerics& numerics, SineArithmetic arithmetic, ScalarKind scalar) {
  return trigonometry_error(arithmetic == SineArithmetic::packs ? numerics : Numerics{}, scalar);
}

std::vector<SineConstant> sine_constants(const Numerics& numerics, SineArithmetic arithmetic,
                                         ScalarKind scalar) {
  const AngleReduction& known = angle_reduction(scalar);
  const cln::cl_RA error = sine_error(numerics, arithmetic, scalar);
  std::vector<SineConstant> numbers{
      {"domain", known.domain}, {"inverse", known.inverse}, {"shift", known.shift}};
  const auto add = [&numbers](std::string_view name, int first, int step,
                              const std::vector<double>& values) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      const int number = first + step * static_cast<int>(i);
      numbers.push_back({fmt::format("{}_{}", name, number), values[i]});
    }
  };
  add("part", 1, 1, known.parts);
  add("sine", 3, 2, lowest_degree_polynomial(sine_polynomials(), error, scalar).coefficients);
  add("cosine", 4, 2, lowest_degree_polynomial(cosine_polynomials(), error, scalar).coefficients);
  return numbers;
}

bool has_inline_sines(const Scene& scene, ScalarKind scalar) {
  return !scene.numerics.has_library_sines && scalar != ScalarKind::long_double;
}

template <class Scalar>
SineEvaluator<Scalar>::SineEvaluator(const Scene& scene, SineArithmetic arithmetic)
    : reduction_(angle_reduction(scalar_kind<Scalar>)),
      arithmetic_(arithmetic),
      is_library_(arithmetic == SineArithmetic::numbers &&
                  !has_inline_sines(scene, scalar_kind<Scalar>)) {
  const cln::cl_RA error = sine_error(scene.numerics, arithmetic, scalar_kind<Scalar>);
  sine_ = coefficients_of<Scalar>(
      lowest_degree_polynomial(sine_polynomials(), error, scalar_kind<Scalar>));
  cosine_ = coefficients_of<Scalar>(
      lowest_degree_polynomial(cosine_polynomials(), error, scalar_kind<Scalar>));
}

template <class Scalar>
auto SineEvaluator<Scalar>::evaluate(Scalar angle) const -> SineCosinePair {
  if (is_library_ || !(std::abs(angle) <= static_cast<Scalar>(reduction_.domain))) {
    constexpr Scalar undefined = std::numeric_limits<Scalar>::quiet_NaN();
    if (arithmetic_ == SineArithmetic::packs) return {undefined, undefined};
    return {std::sin(angle), std::cos(angle)};
  }
  const auto part = [this](std::size_t i) { return static_cast<Scalar>(reduction_.parts[i]); };
  const auto shift = static_cast<Scalar>(reduction_.shift);
  const Scalar shifted = angle * static_cast<Scalar>(reduction_.inverse) + shift;
  const Scalar k = shifted - shift;
  Scalar r = angle - k * part(0);
  Scalar rest = k * part(1);
  for (std::size_t i = 2; i < reduction_.parts.size(); ++i) {
    const Scalar before = r;
    r = r - rest;
    rest = k * part(i) + (rest - (before - r));
  }
  const Scalar square = r * r;
  const Scalar half = Scalar(0.5) * square;
  const Scalar most = Scalar(1) - half;
  Scalar sine = r - (rest - r * square * evaluate_polynomial(square, sine_));
  Scalar cosine = most + (((Scalar(1) - most) - half) +
                          (square * square * evaluate_polynomial(square, cosine_) + r * rest));
  using Integer = std::conditional_t<sizeof(Scalar) == 4, std::uint32_t, std::uint64_t>;
  const auto quadrant = std::bit_cast<Integer>(shifted);
  if ((quadrant & 1) != 0) std::swap(sine, cosine);
  if ((quadrant & 2) != 0) sine = -sine;
  if (((quadrant + 1) & 2) != 0) cosine = -cosine;
  return {sine, cosine};
}

template class SineEvaluator<double>;
template class SineEvaluator<float>;

}  // namespace elgen
