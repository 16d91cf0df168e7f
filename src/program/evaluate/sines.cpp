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
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>

#include "numbers/exact_number.hpp"

namespace elgen {
namespace {

/// Length of the longest row of sine_polynomials.def.
constexpr std::size_t most_coefficients = 8;

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

/// "part_1", "part_2", ...
void add_parts(std::string_view name, const std::vector<double>& parts,
               std::vector<SineConstant>& to) {
  for (std::size_t i = 0; i < parts.size(); ++i)
    to.push_back({fmt::format("{}_{}", name, i + 1), parts[i]});
}

/// "sine_3", "sine_5", ...: each name has the power of its coefficient.
void add_coefficients(std::string_view name, const SinePolynomial& polynomial,
                      std::vector<SineConstant>& to) {
  const std::size_t count = polynomial.coefficients.size();
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t power = static_cast<std::size_t>(polynomial.degree) - 2 * (count - 1 - i);
    to.push_back({fmt::format("{}_{}", name, power), polynomial.coefficients[i]});
  }
}

}  // namespace

const std::vector<SinePolynomial>& sine_polynomials() {
  static const std::vector<SinePolynomial> all{
#define ELGEN_SINE(degree, error, ...) {degree, error, {__VA_ARGS__}},
#define ELGEN_COSINE(degree, error, ...)
#define ELGEN_LONE_SINE(degree, error, ...)
#include "program/evaluate/sine_polynomials.def"
  };
  return all;
}

const std::vector<SinePolynomial>& cosine_polynomials() {
  static const std::vector<SinePolynomial> all{
#define ELGEN_SINE(degree, error, ...)
#define ELGEN_COSINE(degree, error, ...) {degree, error, {__VA_ARGS__}},
#define ELGEN_LONE_SINE(degree, error, ...)
#include "program/evaluate/sine_polynomials.def"
  };
  return all;
}

const std::vector<SinePolynomial>& lone_sine_polynomials() {
  static const std::vector<SinePolynomial> all{
#define ELGEN_SINE(degree, error, ...)
#define ELGEN_COSINE(degree, error, ...)
#define ELGEN_LONE_SINE(degree, error, ...) {degree, error, {__VA_ARGS__}},
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

const SinePolynomial* lone_sine_polynomial(const Scene& scene, ScalarKind scalar) {
  const std::optional<cln::cl_RA>& permitted = scene.numerics.trigonometry_error;
  const bool is_permitted = permitted && *permitted >= least_lone_sine_error(scalar);
  if (!is_permitted || !has_inline_sines(scene, scalar)) return nullptr;
  return &lone_sine_polynomials().at(scalar == ScalarKind::single_precision ? 0 : 1);
}

std::vector<SineConstant> sine_constants(const Numerics& numerics, SineArithmetic arithmetic,
                                         ScalarKind scalar) {
  const AngleReduction& known = angle_reduction(scalar);
  const cln::cl_RA error = sine_error(numerics, arithmetic, scalar);
  std::vector<SineConstant> numbers{
      {"domain", known.domain}, {"inverse", known.inverse}, {"shift", known.shift}};
  add_parts("part", known.parts, numbers);
  add_coefficients("sine", lowest_degree_polynomial(sine_polynomials(), error, scalar), numbers);
  add_coefficients("cosine", lowest_degree_polynomial(cosine_polynomials(), error, scalar),
                   numbers);
  return numbers;
}

std::vector<SineConstant> lone_sine_constants(const Scene& scene, const Program& program,
                                              ScalarKind scalar) {
  const SinePolynomial* const polynomial = lone_sine_polynomial(scene, scalar);
  if (polynomial == nullptr || !has_lone_sine_calls(program, in_line_pairing(scene))) return {};
  const AngleReduction& known = angle_reduction(scalar);
  std::vector<SineConstant> numbers{{"inverse_pi", known.inverse / 2}};
  std::vector<double> parts = known.parts;
  for (double& part : parts) part *= 2;
  add_parts("pi", parts, numbers);
  add_coefficients("lone", *polynomial, numbers);
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
                  !has_inline_sines(scene, scalar_kind<Scalar>)),
      pairing_(in_line_pairing(scene)) {
  const SinePolynomial* const lone = lone_sine_polynomial(scene, scalar_kind<Scalar>);
  if (lone != nullptr && arithmetic == SineArithmetic::numbers)
    lone_ = coefficients_of<Scalar>(*lone);
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

template <class Scalar>
Scalar SineEvaluator<Scalar>::evaluate_lone(FunctionId function, Scalar angle) const {
  const bool is_cosine = function == FunctionId::cos;
  if (!(std::abs(angle) <= static_cast<Scalar>(reduction_.domain)))
    return is_cosine ? std::cos(angle) : std::sin(angle);
  const auto part = [this](std::size_t i) { return static_cast<Scalar>(2 * reduction_.parts[i]); };
  const auto shift = static_cast<Scalar>(reduction_.shift);
  const Scalar turns = angle * static_cast<Scalar>(reduction_.inverse / 2);
  const Scalar shifted = (is_cosine ? turns - Scalar(0.5) : turns) + shift;
  Scalar n = shifted - shift;
  if (is_cosine) n = n + Scalar(0.5);
  Scalar r = angle;
  for (std::size_t i = 0; i < reduction_.parts.size(); ++i) r = r - n * part(i);
  const Scalar square = r * r;
  const Scalar sine = r + r * square * evaluate_polynomial(square, lone_);
  using Integer = std::conditional_t<sizeof(Scalar) == 4, std::uint32_t, std::uint64_t>;
  const bool is_odd = (std::bit_cast<Integer>(shifted) & 1) != 0;
  // The sum turns -0 to 0, so the sign is the sign of r.
  return std::copysign(sine, is_odd != is_cosine ? -r : r);
}

template <class Scalar>
std::vector<bool> SineEvaluator<Scalar>::lone_calls(const Function& function) const {
  if (lone_.empty()) return {};
  return lone_sine_calls(function, pairing_);
}

template class SineEvaluator<double>;
template class SineEvaluator<float>;

}  // namespace elgen
