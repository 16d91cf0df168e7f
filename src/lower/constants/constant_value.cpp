// enclosure_of: where digits cancel, or an angle is large, the form is evaluated again with more.
#include "lower/constants/constant_value.hpp"

#include <array>

#include "base/exact_number.hpp"

namespace elgen {
namespace {

/// What a constant is known to.
constexpr int promised_digits = 200;
/// Of the floats, one after the other until that is kept.
constexpr std::array<int, 4> working_digits{220, 440, 880, 1760};

Enclosed value_of(const ConstantForm& form, const EnclosedArithmetic& with);

Enclosed value_of(const ConstantPart& part, bool is_factor, const EnclosedArithmetic& with) {
  const Enclosed value = value_of(part.form, with);
  if (!value.number || part.weight == 1) return value;
  return is_factor ? with.power(*value.number, part.weight) : Enclosed(-*value.number);
}

EnclosedNumber folded(const ConstantForm& form, const std::vector<EnclosedNumber>& parts,
                      const EnclosedArithmetic& with) {
  const bool is_sum = form.kind == ConstantKind::sum;
  EnclosedNumber total{is_sum ? 0 : 1, 0};
  for (const EnclosedNumber& part : parts) {
    total = is_sum ? with.sum(total, part) : with.product(total, part);
  }
  return total;
}

Enclosed value_of(const ConstantForm& form, const EnclosedArithmetic& with) {
  std::vector<EnclosedNumber> parts;
  for (const ConstantPart& part : form.parts) {
    const Enclosed value = value_of(part, form.kind == ConstantKind::product, with);
    if (!value.number) return value;
    parts.push_back(*value.number);
  }
  switch (form.kind) {
    case ConstantKind::rational:
      return EnclosedNumber{form.number, 0};
    case ConstantKind::pi:
      return with.pi();
    case ConstantKind::square_root:
      return with.power(parts.front(), cln::cl_RA(1) / 2);
    case ConstantKind::call:
      return with.call(form.function, parts.front(), parts.back());
    default:
      return folded(form, parts, with);
  }
}

/// Errors of what no length tells may grow beyond all floats.
Enclosed value_with(const ConstantForm& form, int digits) {
  try {
    return value_of(form, EnclosedArithmetic(digits));
  } catch (const cln::floating_point_exception&) {
    return NoValue::unknown;
  }
}

}  // namespace

std::optional<EnclosedNumber> enclosure_of(const ConstantForm& form) {
  static const cln::cl_RA share = power_of_ten(-promised_digits);
  std::optional<EnclosedNumber> last;
  for (const int digits : working_digits) {
    const Enclosed found = value_with(form, digits);
    if (!found.number) continue;
    last = found.number;
    if (last->error <= share * cln::abs(last->value)) return last;
  }
  // A sum that cancels to so little at full length is taken for 0. Where no length tells, there is
  // no value.
  const bool is_negligible = last && last->error <= share;
  return is_negligible ? last : std::nullopt;
}

}  // namespace elgen
