// scalar_literal: the standard's shortest decimals, which no locale changes.
#include "evaluate/scalar_literal.hpp"

#include <charconv>
#include <cmath>
#include <limits>

#include "base/number_text.hpp"
#include "elgen/evaluate.hpp"

namespace elgen {
namespace {

template <class Scalar>
Fit fit_in(const cln::cl_R& value) {
  const Scalar nearest = std::abs(ScalarTraits<Scalar>::from_real(value));
  if (nearest > std::numeric_limits<Scalar>::max()) return Fit::too_large;
  const bool is_subnormal = nearest < std::numeric_limits<Scalar>::min();
  return is_subnormal && !cln::zerop(value) ? Fit::too_small : Fit::fits;
}

template <class Scalar>
std::string shortest_in(const cln::cl_R& value) {
  char buffer[64];
  const Scalar nearest = ScalarTraits<Scalar>::from_real(value);
  const std::to_chars_result end = std::to_chars(buffer, buffer + sizeof buffer, nearest);
  std::string text(buffer, end.ptr);
  const bool is_floating = text.find_first_of(".e") != std::string::npos;
  return is_floating ? text : text + ".0";
}

/// The value itself where a reader can still read it: in as many digits as a double has.
std::optional<std::string> readable_literal(const cln::cl_R& value) {
  constexpr std::size_t readable_digits = 17;
  const std::optional<Decimal> decimal = exact_decimal(value);
  const bool is_readable =
      decimal && integer_text(cln::abs(decimal->significand)).size() <= readable_digits;
  return is_readable ? std::optional(literal_text(*decimal)) : std::nullopt;
}

}  // namespace

Fit fit(const cln::cl_R& value, ScalarKind scalar) {
  switch (scalar) {
    case ScalarKind::single_precision:
      return fit_in<float>(value);
    case ScalarKind::double_precision:
      return fit_in<double>(value);
    case ScalarKind::long_double:
      return fit_in<long double>(value);
  }
  return Fit::fits;
}

std::string shortest_literal(const cln::cl_R& value, ScalarKind scalar) {
  switch (scalar) {
    case ScalarKind::single_precision:
      return shortest_in<float>(value);
    case ScalarKind::double_precision:
      return shortest_in<double>(value);
    case ScalarKind::long_double:
      // A literal is read by the user's compiler, whose long double may have 113 bits.
      return literal_text(rounded_decimal(value, 40));
  }
  return "";
}

std::string scalar_literal(const cln::cl_R& value, ScalarKind scalar) {
  const std::optional<std::string> readable = readable_literal(value);
  return readable ? *readable : shortest_literal(value, scalar);
}

std::optional<std::string> exact_in_float(const cln::cl_R& value) {
  if (!is_rational(value) || fit(value, ScalarKind::single_precision) != Fit::fits) {
    return std::nullopt;
  }
  const float nearest = ScalarTraits<float>::from_real(value);
  const bool is_exact = exact_value(static_cast<double>(nearest)) == cln::rational(value);
  return is_exact ? readable_literal(value) : std::nullopt;
}

}  // namespace elgen
