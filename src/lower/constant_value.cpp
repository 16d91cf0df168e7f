// enclosure_of: a form evaluated in floats, with a bound of the error that grows along the way, so
// that its sign is known or is known to be open.
//
// Every operation adds what rounding costs, u |x|, to what the errors of its operands become. Where
// digits cancel, or an angle is large, the form is evaluated again with more.
#include <cln/float.h>
#include <cln/rational.h>
#include <cln/real.h>

#include <algorithm>
#include <array>

#include "base/exact_number.hpp"
#include "elgen/constant.hpp"

namespace elgen {
namespace {

using cln::cl_F;
using cln::cl_R;
using cln::cl_RA;
using Enclosure = ConstantEnclosure;
using Enclosed = std::optional<Enclosure>;

/// What a constant is known to.
constexpr int promised_digits = 200;
/// Of the floats, one after the other until that is kept.
constexpr std::array<int, 4> working_digits{220, 440, 880, 1760};
/// Digits left to the library's own rounding, which is a few units in the last place.
constexpr int guard_digits = 10;

/// Larger arguments of exp, sinh and cosh leave the exponents that numbers here may have.
constexpr long largest_exponent = 100'000;

bool is_exact(const Enclosure& x) { return cln::zerop(x.error); }

cl_R largest(const Enclosure& x) { return cln::abs(x.value) + x.error; }
/// The least magnitude; not above 0 where 0 is enclosed.
cl_R least(const Enclosure& x) { return cln::abs(x.value) - x.error; }

Enclosure minus(const Enclosure& x) { return {-x.value, x.error}; }

class Evaluation {
 public:
  explicit Evaluation(int digits)
      : format_(cln::float_format(static_cast<std::uintptr_t>(digits))),
        roundoff_(cln::cl_float(power_of_ten(guard_digits - digits), bound_format())) {}

  [[nodiscard]] Enclosed operator()(const ConstantForm& form) const {
    std::vector<Enclosure> parts;
    for (const ConstantPart& part : form.parts) {
      Enclosed value = (*this)(part.form);
      if (value && form.kind == ConstantKind::product) {
        value = power(*value, part.weight);
      } else if (value && part.weight < 0) {
        value = minus(*value);
      }
      if (!value) return std::nullopt;
      parts.push_back(*value);
    }
    return combined(form, parts);
  }

 private:
  static cln::float_format_t bound_format() { return cln::float_format(17); }

  [[nodiscard]] cl_F as_float(const cl_R& x) const { return cln::cl_float(x, format_); }

  /// Bounds need few digits; the last factor covers their own rounding.
  [[nodiscard]] Enclosure rounded(const cl_R& value, const cl_R& error) const {
    const cl_F bound = cln::cl_float(error + roundoff_ * cln::abs(value), bound_format());
    return {value, bound + bound * cln::cl_float(power_of_ten(-15), bound_format())};
  }

  /// An argument as functions take it.
  [[nodiscard]] Enclosure floating(const Enclosure& x) const {
    return is_rational(x.value) ? rounded(as_float(x.value), x.error) : x;
  }

  [[nodiscard]] Enclosure plus(const Enclosure& x, const Enclosure& y) const {
    const cl_R value = x.value + y.value;
    if (is_exact(x) && is_exact(y)) return {value, 0};
    return rounded(value, x.error + y.error);
  }

  [[nodiscard]] Enclosure times(const Enclosure& x, const Enclosure& y) const {
    const cl_R value = x.value * y.value;
    if (is_exact(x) && is_exact(y)) return {value, 0};
    return rounded(value, largest(x) * y.error + cln::abs(y.value) * x.error);
  }

  /// |1/x - 1/y| = |x - y|/|x y|
  [[nodiscard]] Enclosed reciprocal(const Enclosure& x) const {
    if (!cln::plusp(least(x))) return std::nullopt;
    const cl_R value = cln::recip(x.value);
    if (is_exact(x)) return Enclosure{value, 0};
    return rounded(value, x.error / (cln::abs(x.value) * least(x)));
  }

  [[nodiscard]] Enclosed power(const Enclosure& x, std::int32_t exponent) const {
    Enclosure result{1, 0};
    Enclosure square = x;
    for (std::int32_t rest = std::abs(exponent); rest > 0; rest /= 2) {
      if (rest % 2 != 0) result = times(result, square);
      if (rest > 1) square = times(square, square);
    }
    return exponent < 0 ? reciprocal(result) : Enclosed(result);
  }

  /// |sqrt x - sqrt y| <= |x - y|/sqrt y
  [[nodiscard]] Enclosed square_root(const Enclosure& x) const {
    if (is_exact(x) && cln::zerop(x.value)) return Enclosure{0, 0};
    const Enclosure radicand = floating(x);
    if (!cln::plusp(radicand.value - radicand.error)) return std::nullopt;
    const cl_R slope = cln::recip(cln::sqrt(as_float(least(radicand))));
    return sloped(cln::sqrt(as_float(radicand.value)), radicand, slope);
  }

  /// A function whose slope is at most `slope` on the enclosure of its argument.
  [[nodiscard]] Enclosure sloped(const cl_R& value, const Enclosure& x, const cl_R& slope) const {
    return rounded(value, x.error * slope);
  }

  [[nodiscard]] Enclosed tangent(const Enclosure& x) const {
    const cl_F angle = as_float(x.value);
    const cl_R cosine = cln::abs(cln::cos(angle)) - x.error - roundoff_;
    if (!cln::plusp(cosine)) return std::nullopt;
    return sloped(cln::tan(angle), x, cln::recip(cosine * cosine));
  }

  /// asin or acos; the slope 1/sqrt(1 - x^2) has no bound at ±1, where only an exact ±1 is told.
  [[nodiscard]] Enclosed inverse_circular(FunctionId function, const Enclosure& x) const {
    const bool is_end = is_exact(x) && cln::abs(x.value) == 1;
    const Enclosure sine = floating(x);
    const cl_R rest = 1 - largest(sine) * largest(sine);
    if (!is_end && !cln::plusp(rest)) return std::nullopt;
    const cl_F cosine = cln::sqrt(as_float(1 - x.value * x.value));
    const cl_R value = function == FunctionId::asin ? cln::atan(cosine, as_float(sine.value))
                                                    : cln::atan(as_float(sine.value), cosine);
    return sloped(value, sine, is_end ? cl_R(0) : cl_R(cln::recip(cln::sqrt(as_float(rest)))));
  }

  /// The angle of (x, y); none at the origin, and on the cut only where y is 0 exactly.
  [[nodiscard]] Enclosed arc_tangent_2(const Enclosure& y, const Enclosure& x) const {
    const bool is_right = cln::plusp(x.value - x.error);
    const bool is_off_axis = cln::plusp(least(y));
    const bool is_on_cut = is_exact(y) && cln::zerop(y.value) && cln::minusp(x.value + x.error);
    if (!is_right && !is_off_axis && !is_on_cut) return std::nullopt;
    const Enclosure across = floating(y);
    const Enclosure along = floating(x);
    const cl_R distance = cln::max(least(across), least(along));
    return rounded(cln::atan(as_float(x.value), as_float(y.value)),
                   (across.error + along.error) / distance);
  }

  [[nodiscard]] Enclosed exponential(FunctionId function, const Enclosure& x) const {
    if (largest(x) > largest_exponent) return std::nullopt;
    const cl_F argument = as_float(x.value);
    const cl_R slope = 2 * cln::exp(cln::cl_float(largest(x), bound_format()));
    switch (function) {
      case FunctionId::exp:
        return sloped(cln::exp(argument), x, slope);
      case FunctionId::sinh:
        return sloped(cln::sinh(argument), x, slope);
      case FunctionId::cosh:
        return sloped(cln::cosh(argument), x, slope);
      default:
        return sloped(cln::tanh(argument), x, 1);
    }
  }

  /// The smaller of two where `wants_less`, or the larger; none where they are not told apart.
  [[nodiscard]] Enclosed one_of(const Enclosure& x, const Enclosure& y, bool wants_less) const {
    const std::optional<int> order = sign_of(plus(x, minus(y)));
    if (!order) return std::nullopt;
    return (*order < 0) == wants_less ? x : y;
  }

  [[nodiscard]] Enclosed kinked(FunctionId function, const Enclosure& x, const Enclosure& y) const {
    if (function == FunctionId::abs) return Enclosure{cln::abs(x.value), x.error};
    if (function != FunctionId::sign) return one_of(x, y, function == FunctionId::min);
    const std::optional<int> sign = sign_of(x);
    return sign ? Enclosed({cl_R(*sign), 0}) : std::nullopt;
  }

  [[nodiscard]] Enclosed smooth(FunctionId function, const Enclosure& x) const {
    switch (function) {
      case FunctionId::sin:
        return sloped(cln::sin(as_float(x.value)), x, 1);
      case FunctionId::cos:
        return sloped(cln::cos(as_float(x.value)), x, 1);
      case FunctionId::tan:
        return tangent(x);
      case FunctionId::atan:
        return sloped(cln::atan(as_float(x.value)), x, 1);
      case FunctionId::log:
        if (!cln::plusp(x.value - x.error)) return std::nullopt;
        return sloped(cln::ln(as_float(x.value)), x, cln::recip(least(x)));
      default:
        return exponential(function, x);
    }
  }

  [[nodiscard]] Enclosed call(FunctionId function, const Enclosure& x, const Enclosure& y) const {
    switch (function) {
      case FunctionId::abs:
      case FunctionId::sign:
      case FunctionId::min:
      case FunctionId::max:
        return kinked(function, x, y);
      case FunctionId::asin:
      case FunctionId::acos:
        return inverse_circular(function, x);
      case FunctionId::atan2:
        return arc_tangent_2(x, y);
      default:
        return smooth(function, floating(x));
    }
  }

  [[nodiscard]] Enclosed combined(const ConstantForm& form,
                                  const std::vector<Enclosure>& parts) const {
    switch (form.kind) {
      case ConstantKind::rational:
        return Enclosure{form.number, 0};
      case ConstantKind::pi:
        return rounded(cln::pi(format_), 0);
      case ConstantKind::square_root:
        return square_root(parts.front());
      case ConstantKind::call:
        return call(form.function, parts.front(), parts.back());
      case ConstantKind::sum: {
        Enclosure total{0, 0};
        for (const Enclosure& term : parts) total = plus(total, term);
        return total;
      }
      case ConstantKind::product: {
        Enclosure total{1, 0};
        for (const Enclosure& factor : parts) total = times(total, factor);
        return total;
      }
    }
    return std::nullopt;
  }

  cln::float_format_t format_;
  cl_R roundoff_;
};

}  // namespace

std::optional<Enclosure> enclosure_of(const ConstantForm& form) {
  Enclosed last;
  for (const int digits : working_digits) {
    const Enclosed found = Evaluation(digits)(form);
    if (!found) continue;
    last = found;
    if (found->error <= power_of_ten(-promised_digits) * cln::abs(found->value)) return found;
  }
  // What cancels to so little at full length is taken for 0; what is unknown has no value.
  const bool is_negligible = last && last->error <= power_of_ten(-promised_digits);
  return is_negligible ? last : std::nullopt;
}

std::optional<int> sign_of(const Enclosure& enclosure) {
  if (cln::plusp(least(enclosure))) return cln::minusp(enclosure.value) ? -1 : 1;
  const bool is_zero = is_exact(enclosure) && cln::zerop(enclosure.value);
  return is_zero ? std::optional(0) : std::nullopt;
}

}  // namespace elgen
