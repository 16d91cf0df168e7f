// Constants as forms: compares forms, and finds the signs, values and formulas of constants.
//
// If digits cancel, or an angle is large, a form is evaluated again with more digits. The weight of
// a part is a sign in sums and an exponent in products.
#include <cln/integer.h>
#include <cln/rational.h>

#include <algorithm>
#include <array>

#include "elgen/constant.hpp"
#include "elgen/formula.hpp"
#include "numbers/enclosed_number.hpp"
#include "numbers/exact_number.hpp"

namespace elgen {
namespace {

/// Correct digits of every constant.
constexpr int promised_digits = 200;
/// Digits of the floating-point numbers, tried in turn until `promised_digits` are correct.
constexpr std::array<int, 4> working_digits{220, 440, 880, 1760};

EnclosedResult value_of(const ConstantForm& form, const EnclosedArithmetic& arithmetic);

EnclosedResult value_of(const ConstantOperand& part, bool is_factor,
                        const EnclosedArithmetic& with) {
  const EnclosedResult value = value_of(part.form, with);
  if (!value.number || part.weight == 1) return value;
  return is_factor ? with.power(*value.number, part.weight) : EnclosedResult(-*value.number);
}

EnclosedNumber combine_parts(const ConstantForm& form, const std::vector<EnclosedNumber>& parts,
                             const EnclosedArithmetic& with) {
  const bool is_sum = form.kind == ConstantKind::sum;
  EnclosedNumber total{is_sum ? 0 : 1, 0};
  for (const EnclosedNumber& part : parts) {
    total = is_sum ? with.sum(total, part) : with.product(total, part);
  }
  return total;
}

EnclosedResult value_of(const ConstantForm& form, const EnclosedArithmetic& arithmetic) {
  std::vector<EnclosedNumber> parts;
  for (const ConstantOperand& part : form.operands) {
    const EnclosedResult value = value_of(part, form.kind == ConstantKind::product, arithmetic);
    if (!value.number) return value;
    parts.push_back(*value.number);
  }
  switch (form.kind) {
    case ConstantKind::rational:
      return EnclosedNumber{form.number, 0};
    case ConstantKind::pi:
      return arithmetic.pi();
    case ConstantKind::square_root:
      return arithmetic.power(parts.front(), cln::cl_RA(1) / 2);
    case ConstantKind::call:
      return arithmetic.call(form.function, parts.front(), parts.back());
    default:
      return combine_parts(form, parts, arithmetic);
  }
}

/// The value of a form, computed with `digits` digits; unknown if an error bound overflows. The
/// bound overflows for a form that no precision decides.
EnclosedResult evaluate_with_digits(const ConstantForm& form, int digits) {
  try {
    return value_of(form, EnclosedArithmetic(digits));
  } catch (const cln::floating_point_exception&) {
    return NoValueReason::unknown;
  }
}

Formula sum_formula(const std::vector<ConstantOperand>& parts) {
  Formulas terms;
  for (const ConstantOperand& part : parts) {
    Formula term = constant_formula(part.form);
    terms.push_back(part.weight < 0 ? negative_of(std::move(term)) : std::move(term));
  }
  return sum_of(std::move(terms));
}

/// The formula of form^weight. Brackets keep the sign of a sum of one negative term: (-x)^2.
Formula factor_formula(const ConstantOperand& factor) {
  const bool is_signed = factor.form.kind == ConstantKind::sum && factor.form.operands.size() == 1;
  Formula base = constant_formula(factor.form);
  if (is_signed) base = group(std::move(base));
  return factor.weight == 1 ? base : power_of(std::move(base), number_formula(factor.weight));
}

Formulas arguments_of(const ConstantForm& form) {
  Formulas arguments;
  for (const ConstantOperand& part : form.operands) {
    arguments.push_back(constant_formula(part.weight < 0 ? negated_form(part.form) : part.form));
  }
  return arguments;
}

}  // namespace

bool operator==(const ConstantForm& x, const ConstantForm& y) {
  return x.kind == y.kind && x.number == y.number && x.function == y.function &&
         x.operands == y.operands;
}

bool operator==(const ConstantOperand& x, const ConstantOperand& y) {
  return x.weight == y.weight && x.form == y.form;
}

ConstantForm rational_form(const cln::cl_RA& number) { return {.number = number, .operands = {}}; }

ConstantForm negated_form(ConstantForm x) {
  if (x.kind == ConstantKind::rational) return rational_form(-x.number);
  if (x.kind == ConstantKind::sum) {
    for (ConstantOperand& term : x.operands) term.weight = -term.weight;
    const bool is_single = x.operands.size() == 1 && x.operands.front().weight > 0;
    return is_single ? ConstantForm(x.operands.front().form) : x;
  }
  if (x.kind == ConstantKind::product) {
    const auto takes_sign = [](const ConstantOperand& factor) {
      const ConstantKind kind = factor.form.kind;
      return factor.weight % 2 != 0 &&
             (kind == ConstantKind::rational || kind == ConstantKind::sum);
    };
    const auto factor = std::find_if(x.operands.begin(), x.operands.end(), takes_sign);
    if (factor != x.operands.end()) {
      factor->form = negated_form(factor->form);
      return x;
    }
  }
  return {.kind = ConstantKind::sum, .operands = {{std::move(x), -1}}};
}

Constant rational_constant(const cln::cl_RA& number) { return {number, rational_form(number)}; }

std::optional<Constant> make_constant(ConstantForm form) {
  const std::optional<EnclosedNumber> enclosure = enclosed_value(form);
  if (!enclosure) return std::nullopt;
  const bool has_known_sign = sign_of(*enclosure).has_value();
  return Constant{has_known_sign ? enclosure->value : cln::cl_R(0), std::move(form)};
}

bool is_rational(const Constant& constant) { return constant.form.kind == ConstantKind::rational; }

std::uint32_t intern_constant(const Constant& wanted, std::vector<Constant>& constants) {
  const auto known = std::find_if(constants.begin(), constants.end(), [&](const Constant& one) {
    return one.value == wanted.value && one.form == wanted.form;
  });
  const auto position = static_cast<std::uint32_t>(known - constants.begin());
  if (known == constants.end()) constants.push_back(wanted);
  return position;
}

std::optional<EnclosedNumber> enclosed_value(const ConstantForm& form) {
  static const cln::cl_RA share = power_of_ten(-promised_digits);
  std::optional<EnclosedNumber> last;
  for (const int digits : working_digits) {
    const EnclosedResult found = evaluate_with_digits(form, digits);
    if (!found.number) continue;
    last = found.number;
    if (last->error <= share * cln::abs(last->value)) return last;
  }
  // The relative error is never small, because digits cancel. If the absolute error is at most
  // `share`, the constant is 0. Otherwise no precision decides, and the constant has no value.
  const bool is_negligible = last && last->error <= share;
  return is_negligible ? last : std::nullopt;
}

Formula constant_formula(const ConstantForm& form) {
  switch (form.kind) {
    case ConstantKind::rational:
      return number_formula(form.number);
    case ConstantKind::pi:
      return pi_formula();
    case ConstantKind::sum:
      return sum_formula(form.operands);
    case ConstantKind::product: {
      Formulas factors;
      for (const ConstantOperand& factor : form.operands) factors.push_back(factor_formula(factor));
      return product_of(std::move(factors));
    }
    case ConstantKind::square_root:
      return root_of(arguments_of(form).front());
    default:
      return call_of(form.function, arguments_of(form));
  }
}

std::string text_of(const ConstantForm& form) { return text_of(constant_formula(form)); }

}  // namespace elgen
