// constant_formula: weights are signs, or exponents: those below zero stand below a stacked
// fraction.
#include "lower/constants/constant_formula.hpp"

#include <cstdlib>

namespace elgen {
namespace {

Formula sum_of(const Spelling& spelling, const std::vector<ConstantPart>& parts) {
  std::vector<Summand> terms;
  for (const ConstantPart& part : parts) {
    terms.push_back({constant_formula(spelling, part.form), part.weight < 0});
  }
  return sum(spelling, terms);
}

/// The base with its exponent; a sum of one term keeps its sign in brackets.
Formula raised(const Spelling& spelling, const ConstantPart& factor, std::int32_t exponent) {
  Formula base = constant_formula(spelling, factor.form);
  const bool is_signed = factor.form.kind == ConstantKind::sum && base.binding == Binding::negation;
  if (is_signed) base = at_least(spelling, base, Binding::product);
  return exponent == 1 ? base : power(spelling, base, number(spelling, exponent));
}

Formula product_of(const Spelling& spelling, const std::vector<ConstantPart>& factors) {
  std::vector<Formula> above;
  std::vector<Formula> below;
  for (const ConstantPart& factor : factors) {
    const bool is_below = spelling.is_two_dimensional && factor.weight < 0;
    (is_below ? below : above)
        .push_back(raised(spelling, factor, is_below ? -factor.weight : factor.weight));
  }
  if (above.empty()) above.push_back({"1"});
  const Formula numerator = product(spelling, above);
  return below.empty() ? numerator : quotient(spelling, numerator, product(spelling, below));
}

std::vector<Formula> arguments_of(const Spelling& spelling, const ConstantForm& form) {
  std::vector<Formula> arguments;
  for (const ConstantPart& part : form.parts) {
    arguments.push_back(
        constant_formula(spelling, part.weight < 0 ? negated(part.form) : part.form));
  }
  return arguments;
}

}  // namespace

Formula constant_formula(const Spelling& spelling, const ConstantForm& form) {
  switch (form.kind) {
    case ConstantKind::rational:
      return number(spelling, form.number);
    case ConstantKind::pi:
      return {spelling.is_two_dimensional ? "\\pi" : "pi"};
    case ConstantKind::sum:
      return sum_of(spelling, form.parts);
    case ConstantKind::product:
      return product_of(spelling, form.parts);
    case ConstantKind::square_root:
      return square_root(spelling, arguments_of(spelling, form).front());
    default:
      return call(spelling, form.function, arguments_of(spelling, form));
  }
}

std::string text_of(const ConstantForm& form) {
  return constant_formula(model_spelling(), form).text();
}

}  // namespace elgen
