// literal: the digits are read as those of a model are, never through a binary number.
#include "readback/literal.hpp"

#include "base/number_text.hpp"
#include "elgen/evaluate.hpp"
#include "parse/decimal.hpp"

namespace elgen {
namespace {

constexpr std::string_view suffixes = "fFlL";
constexpr int long_double_digits = 40;

template <class Scalar>
bool has_one_nearest(const cln::cl_R& x, const cln::cl_R& y) {
  return ScalarTraits<Scalar>::from_real(x) == ScalarTraits<Scalar>::from_real(y);
}

}  // namespace

std::optional<Literal> read_literal(std::string_view text) {
  Literal literal;
  if (!text.empty() && suffixes.find(text.back()) != std::string_view::npos) {
    literal.suffix = text.back();
    text.remove_suffix(1);
  }
  const NumberExtent extent = number_extent(text, 0);
  const bool is_floating = text.find_first_of(".eE") != std::string_view::npos;
  if (!extent.well_formed || extent.end != text.size() || !is_floating) return std::nullopt;
  const DecimalParts parts = decimal_parts(text);
  if (limit_hit(parts, Limits{})) return std::nullopt;
  literal.value = decimal_value(parts);
  return literal;
}

bool rounds_alike(const cln::cl_R& written, const cln::cl_R& value, ScalarKind scalar) {
  switch (scalar) {
    case ScalarKind::single_precision:
      return has_one_nearest<float>(written, value);
    case ScalarKind::double_precision:
      return has_one_nearest<double>(written, value);
    case ScalarKind::long_double:
      return written == value || written == value_of(rounded_decimal(value, long_double_digits));
  }
  return false;
}

cln::cl_R rounded(const cln::cl_R& value, ScalarKind scalar) {
  if (scalar == ScalarKind::single_precision) {
    return exact_value(static_cast<double>(ScalarTraits<float>::from_real(value)));
  }
  return exact_value(ScalarTraits<double>::from_real(value));
}

}  // namespace elgen
