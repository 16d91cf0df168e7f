// Converts an expression of a model to a closed form without using the derivation, so that
// [[expect]] can be compared with the derived form.
#include <cln/integer.h>

#include <utility>

#include "elgen/closed_forms.hpp"
#include "elgen/model.hpp"
#include "elgen/references.hpp"
#include "forms/present/arithmetic.hpp"
#include "forms/present/polynomial.hpp"

namespace elgen {

using cln::cl_RA;

namespace {

class ExpressionConverter {
 public:
  ExpressionConverter(Arithmetic& arithmetic, const Model& model, const FixedParameters& fixed)
      : arithmetic_(arithmetic), model_(model), fixed_(fixed), known_(model.expressions.size()) {}

  /// The closed form of `wanted`. A stack replaces recursion, since expressions may nest deeply.
  OptionalFraction operator()(ExpressionId wanted) {
    if (known_[wanted].is_done) return known_[wanted].form;
    std::vector<ExpressionId> pending{wanted};
    while (!pending.empty()) {
      const ExpressionId id = pending.back();
      const std::size_t before = pending.size();
      for (const ExpressionId operand : dependencies_of(id)) {
        if (!known_[operand].is_done) pending.push_back(operand);
      }
      if (pending.size() > before) continue;
      pending.pop_back();
      if (!known_[id].is_done) known_[id] = {true, convert_expression(id)};
    }
    return known_[wanted].form;
  }

 private:
  struct ConvertedForm {
    bool is_done = false;
    OptionalFraction form = {};
  };

  /// The expressions to be converted first: the operands. For a fixed parameter: the expression of
  /// the value, if the value has an expression.
  [[nodiscard]] std::vector<ExpressionId> dependencies_of(ExpressionId id) const {
    const Expression& e = model_.expressions[id];
    if (!is_leaf(e, Opcode::parameter)) return references(model_, id);
    const auto fixed = fixed_.find(e.index);
    if (fixed == fixed_.end() || !fixed->second.exact_expression) return {};
    return {*fixed->second.exact_expression};
  }

  OptionalFraction parameter_form(std::uint32_t index) {
    const auto fixed = fixed_.find(index);
    if (fixed == fixed_.end()) return arithmetic_.leaf(Opcode::parameter, index);
    const FixedValue& value = fixed->second;
    if (value.exact_expression) return known_[*value.exact_expression].form;
    return fraction_of(cln::rational(value.number));
  }

  OptionalFraction convert_expression(ExpressionId id) {
    const Expression& e = model_.expressions[id];
    const auto operand = [&](std::size_t i) -> const OptionalFraction& {
      return known_[e.operands[i]].form;
    };
    switch (e.kind) {
      case ExpressionKind::number:
        return fraction_of(e.number);
      case ExpressionKind::pi:
        return arithmetic_.pi();
      case ExpressionKind::leaf:
        return e.leaf == Opcode::parameter ? parameter_form(e.index)
                                           : arithmetic_.leaf(e.leaf, e.index);
      case ExpressionKind::named:
        return known_[dependencies_of(id).front()].form;
      case ExpressionKind::negate:
        return arithmetic_.negate(operand(0));
      case ExpressionKind::add:
        return fold_operands(e, Fraction{}, &Arithmetic::add);
      case ExpressionKind::multiply:
        return fold_operands(e, fraction_of(cl_RA(1)), &Arithmetic::multiply);
      case ExpressionKind::divide:
        return arithmetic_.divide(operand(0), operand(1));
      case ExpressionKind::power:
        return power(operand(0), e.number);
      case ExpressionKind::function:
        return call(e);
      case ExpressionKind::time_derivative:
        // The derivative of a leaf is a leaf itself. Other derivatives are checked at samples.
        return std::nullopt;
    }
    return std::nullopt;
  }

  using BinaryOperation = OptionalFraction (Arithmetic::*)(const OptionalFraction&,
                                                           const OptionalFraction&);

  /// Folds the operands into `total`, which starts as the neutral element.
  OptionalFraction fold_operands(const Expression& e, OptionalFraction total,
                                 BinaryOperation join) {
    for (const ExpressionId id : e.operands) total = (arithmetic_.*join)(total, known_[id].form);
    return total;
  }

  OptionalFraction power(const OptionalFraction& base, const cl_RA& exponent) {
    const cl_RA halves = exponent * 2;
    if (cln::denominator(halves) != 1 || cln::abs(halves) > 128) return std::nullopt;
    const auto count = static_cast<std::int32_t>(cln::cl_I_to_long(cln::numerator(halves)));
    if (count % 2 == 0) return arithmetic_.power(base, count / 2);
    return arithmetic_.power(arithmetic_.square_root(base), count);
  }

  OptionalFraction call(const Expression& e) {
    return arithmetic_.call(e.function, known_[e.operands.front()].form,
                            known_[e.operands.back()].form);
  }

  Arithmetic& arithmetic_;
  const Model& model_;
  const FixedParameters& fixed_;
  std::vector<ConvertedForm> known_;
};

}  // namespace

std::optional<Fraction> closed_form(ClosedForms& forms, const Model& model,
                                    const FixedParameters& fixed, ExpressionId expression) {
  Arithmetic arithmetic(forms.algebra, ClosedFormBudget{}.products_per_function);
  return ExpressionConverter(arithmetic, model, fixed)(expression);
}

OpenValueRates open_value_rates(ClosedForms& forms, const Model& model,
                                const FixedParameters& fixed) {
  OpenValueRates all(model.open_values.size());
  for (std::uint32_t i = 0; i < all.size(); ++i) {
    const OpenFunction& function = model.functions[model.open_values[i].function];
    std::vector<OpenValueRateTerm> terms;
    for (std::uint32_t k = 0; k < function.arguments.size(); ++k) {
      const auto derivative = find_open_derivative(model, i, k);
      const auto argument = closed_form(forms, model, fixed, function.arguments[k]);
      if (derivative && argument) terms.push_back({*derivative, *argument});
    }
    if (terms.size() == function.arguments.size()) all[i] = std::move(terms);
  }
  return all;
}

}  // namespace elgen
