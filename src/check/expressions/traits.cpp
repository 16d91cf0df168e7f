// One pass over the arena. The degree of a sum is the largest degree of a term, its lowest degree
// the smallest. The degree of a product is the sum over its factors. Quotients, functions and
// fractional powers are polynomial only if the denominator, argument or base has degree 0.
#include "check/expressions/traits.hpp"

#include <cln/integer.h>

#include <algorithm>

#include "elgen/references.hpp"

namespace elgen {
namespace {

Traits leaf(Ingredients ingredients) { return {ingredients, 0, 0, 0, false}; }

/// Traits of the number 0. It has no terms, so its lowest degree is the largest possible.
Traits nothing() {
  Traits traits;
  traits.lowest_rate_degree = not_polynomial;
  return traits;
}

std::uint8_t saturated(unsigned degree) {
  return static_cast<std::uint8_t>(std::min<unsigned>(degree, not_polynomial));
}

Traits sum(const Traits& a, const Traits& b) {
  return {static_cast<Ingredients>(a.ingredients | b.ingredients),
          std::max(a.rate_degree, b.rate_degree),
          std::min(a.lowest_rate_degree, b.lowest_rate_degree),
          std::max(a.input_degree, b.input_degree), a.input_times_rate || b.input_times_rate};
}

bool meets(const Traits& inputs, const Traits& rates) {
  return inputs.input_degree > 0 && rates.rate_degree > 0;
}

Traits product(const Traits& a, const Traits& b) {
  Traits result = sum(a, b);
  result.rate_degree = saturated(unsigned{a.rate_degree} + b.rate_degree);
  result.lowest_rate_degree = saturated(unsigned{a.lowest_rate_degree} + b.lowest_rate_degree);
  result.input_degree = saturated(unsigned{a.input_degree} + b.input_degree);
  result.input_times_rate = result.input_times_rate || meets(a, b) || meets(b, a);
  return result;
}

/// Traits of a function, which is no polynomial in the rates and inputs in its argument.
Traits opaque(Traits argument) {
  argument.rate_degree = argument.rate_degree > 0 ? not_polynomial : 0;
  argument.lowest_rate_degree = 0;
  argument.input_degree = argument.input_degree > 0 ? not_polynomial : 0;
  return argument;
}

Traits power(const Traits& base, const cln::cl_RA& exponent) {
  if (cln::denominator(exponent) != 1 || cln::minusp(exponent)) return opaque(base);
  Traits result;
  // Degrees saturate at 3, so four factors give the same result as more.
  const long factors = cln::cl_I_to_long(cln::min(cln::numerator(exponent), cln::cl_I(4)));
  for (long i = 0; i < factors; ++i) result = product(result, base);
  return result;
}

/// d/dt e = de/dq v + de/dv a + de/dt
Traits time_derivative(const Traits& argument) {
  if ((argument.ingredients & (uses_coordinate | uses_rate | uses_time)) == 0) return nothing();
  Traits result = argument;
  if ((argument.ingredients & uses_coordinate) != 0) {
    result.ingredients |= uses_rate;
    result.rate_degree = saturated(argument.rate_degree + 1U);
    const bool moves_by_itself = (argument.ingredients & uses_time) != 0;
    result.lowest_rate_degree = moves_by_itself ? 0 : saturated(argument.lowest_rate_degree + 1U);
  }
  if ((argument.ingredients & uses_rate) != 0) result.ingredients |= uses_acceleration;
  if ((argument.ingredients & uses_open_function) != 0) result.ingredients |= uses_open_derivative;
  return result;
}

class TraitFinder {
 public:
  explicit TraitFinder(const Model& model) : model_(model), traits_(model.expressions.size()) {}

  std::vector<Traits> find() && {
    for (const ExpressionId id : topological_order(model_)) traits_[id] = of(id);
    return std::move(traits_);
  }

 private:
  [[nodiscard]] Traits of(ExpressionId id) const {
    const Expression& node = model_.expressions[id];
    switch (node.kind) {
      case ExpressionKind::number:
        return cln::zerop(node.number) ? nothing() : Traits{};
      case ExpressionKind::pi:
        return {};
      case ExpressionKind::leaf:
        return node.leaf == Opcode::open_value ? of_open_value(node) : of_leaf(node.leaf);
      default:
        return of_compound(node, references(model_, id));
    }
  }

  [[nodiscard]] static Traits of_leaf(Opcode kind) {
    Traits result = leaf(ingredient_bit(leaf_kind(kind)));
    if (kind == Opcode::velocity) result.rate_degree = result.lowest_rate_degree = 1;
    if (kind == Opcode::input) result.input_degree = 1;
    return result;
  }

  [[nodiscard]] Traits of_open_value(const Expression& node) const {
    Traits result = leaf(uses_open_function);
    for (const ExpressionId argument : node.operands) {
      result = sum(result, opaque(traits_[argument]));
    }
    if ((result.ingredients & uses_rate) != 0) result.ingredients |= uses_open_rate;
    const bool is_derivative = !model_.open_values[node.index].by.empty();
    if (is_derivative) result.ingredients |= uses_open_derivative;
    return result;
  }

  [[nodiscard]] Traits of_compound(const Expression& node,
                                   const std::vector<ExpressionId>& parts) const {
    const Traits& first = traits_[parts.front()];
    switch (node.kind) {
      case ExpressionKind::named:
        return node.named == NamedKind::prescribed ? sum(leaf(uses_time), first) : first;
      case ExpressionKind::add:
        return folded(parts, sum);
      case ExpressionKind::multiply:
        return folded(parts, product);
      case ExpressionKind::divide:
        return product(first, opaque(traits_[parts[1]]));
      case ExpressionKind::power:
        return power(first, node.number);
      case ExpressionKind::function:
        return sum(leaf(is_kinked(node.function) ? Ingredients{uses_kink} : 0),
                   opaque(folded(parts, sum)));
      case ExpressionKind::time_derivative:
        return time_derivative(first);
      default:
        return first;
    }
  }

  template <class Combine>
  [[nodiscard]] Traits folded(const std::vector<ExpressionId>& parts, Combine combine) const {
    Traits result = traits_[parts.front()];
    for (std::size_t i = 1; i < parts.size(); ++i) result = combine(result, traits_[parts[i]]);
    return result;
  }

  const Model& model_;
  std::vector<Traits> traits_;
};

}  // namespace

std::vector<Traits> find_traits(const Model& model) { return TraitFinder(model).find(); }

}  // namespace elgen
