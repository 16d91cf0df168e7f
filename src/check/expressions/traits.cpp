// One pass over the arena. A sum has the largest degree and the smallest lowest degree of its
// terms. The degree of a product is the sum over its factors. Quotients, functions and fractional
// powers are polynomial only if the denominator, argument or base has degree 0.
#include "check/expressions/traits.hpp"

#include <cln/integer.h>

#include <algorithm>

#include "elgen/references.hpp"

namespace elgen {
namespace {

ExpressionTraits leaf_traits(Ingredients ingredients) { return {ingredients, 0, 0, 0, false}; }

/// Traits of the number 0. It has no terms, so its lowest degree is the largest possible.
ExpressionTraits zero_traits() {
  ExpressionTraits traits;
  traits.lowest_rate_degree = not_polynomial;
  return traits;
}

std::uint8_t saturate_degree(unsigned degree) {
  return static_cast<std::uint8_t>(std::min<unsigned>(degree, not_polynomial));
}

ExpressionTraits sum_traits(const ExpressionTraits& a, const ExpressionTraits& b) {
  return {static_cast<Ingredients>(a.ingredients | b.ingredients),
          std::max(a.rate_degree, b.rate_degree),
          std::min(a.lowest_rate_degree, b.lowest_rate_degree),
          std::max(a.input_degree, b.input_degree), a.input_times_rate || b.input_times_rate};
}

bool multiplies_input_by_rate(const ExpressionTraits& inputs, const ExpressionTraits& rates) {
  return inputs.input_degree > 0 && rates.rate_degree > 0;
}

ExpressionTraits product_traits(const ExpressionTraits& a, const ExpressionTraits& b) {
  ExpressionTraits result = sum_traits(a, b);
  result.rate_degree = saturate_degree(unsigned{a.rate_degree} + b.rate_degree);
  result.lowest_rate_degree =
      saturate_degree(unsigned{a.lowest_rate_degree} + b.lowest_rate_degree);
  result.input_degree = saturate_degree(unsigned{a.input_degree} + b.input_degree);
  result.input_times_rate =
      result.input_times_rate || multiplies_input_by_rate(a, b) || multiplies_input_by_rate(b, a);
  return result;
}

/// Traits of a function, which is no polynomial in the rates and inputs in its argument.
ExpressionTraits opaque_traits(ExpressionTraits argument) {
  argument.rate_degree = argument.rate_degree > 0 ? not_polynomial : 0;
  argument.lowest_rate_degree = 0;
  argument.input_degree = argument.input_degree > 0 ? not_polynomial : 0;
  return argument;
}

ExpressionTraits power_traits(const ExpressionTraits& base, const cln::cl_RA& exponent) {
  if (cln::denominator(exponent) != 1 || cln::minusp(exponent)) return opaque_traits(base);
  ExpressionTraits result;
  // Degrees saturate at 3, so four factors give the same result as more.
  const long factors = cln::cl_I_to_long(cln::min(cln::numerator(exponent), cln::cl_I(4)));
  for (long i = 0; i < factors; ++i) result = product_traits(result, base);
  return result;
}

/// d/dt e = de/dq v + de/dv a + de/dt
ExpressionTraits derivative_traits(const ExpressionTraits& argument) {
  constexpr Ingredients varying =
      uses_coordinate | uses_rate | uses_acceleration | uses_multiplier | uses_time;
  if ((argument.ingredients & varying) == 0) return zero_traits();
  ExpressionTraits result = argument;
  if ((argument.ingredients & uses_coordinate) != 0) {
    result.ingredients |= uses_rate;
    result.rate_degree = saturate_degree(argument.rate_degree + 1U);
    const bool moves_by_itself = (argument.ingredients & uses_time) != 0;
    result.lowest_rate_degree =
        moves_by_itself ? 0 : saturate_degree(argument.lowest_rate_degree + 1U);
  }
  if ((argument.ingredients & uses_rate) != 0) result.ingredients |= uses_acceleration;
  if ((argument.ingredients & uses_open_function) != 0) result.ingredients |= uses_open_derivative;
  return result;
}

class TraitFinder {
 public:
  explicit TraitFinder(const Model& model) : model_(model), traits_(model.expressions.size()) {}

  std::vector<ExpressionTraits> find() && {
    for (const ExpressionId id : topological_order(model_)) traits_[id] = node_traits(id);
    return std::move(traits_);
  }

 private:
  [[nodiscard]] ExpressionTraits node_traits(ExpressionId id) const {
    const Expression& node = model_.expressions[id];
    switch (node.kind) {
      case ExpressionKind::number:
        return cln::zerop(node.number) ? zero_traits() : ExpressionTraits{};
      case ExpressionKind::pi:
        return {};
      case ExpressionKind::leaf:
        return node.leaf == Opcode::open_value ? open_value_traits(node)
                                               : variable_traits(node.leaf);
      default:
        return compound_traits(node, references(model_, id));
    }
  }

  [[nodiscard]] static ExpressionTraits variable_traits(Opcode kind) {
    ExpressionTraits result = leaf_traits(ingredient_bit(leaf_kind(kind)));
    if (kind == Opcode::velocity) result.rate_degree = result.lowest_rate_degree = 1;
    if (kind == Opcode::input) result.input_degree = 1;
    return result;
  }

  [[nodiscard]] ExpressionTraits open_value_traits(const Expression& node) const {
    ExpressionTraits result = leaf_traits(uses_open_function);
    for (const ExpressionId argument : node.operands) {
      result = sum_traits(result, opaque_traits(traits_[argument]));
    }
    if ((result.ingredients & uses_rate) != 0) result.ingredients |= uses_open_rate;
    const bool is_derivative = !model_.open_values[node.index].derivative_arguments.empty();
    if (is_derivative) result.ingredients |= uses_open_derivative;
    return result;
  }

  [[nodiscard]] ExpressionTraits compound_traits(const Expression& node,
                                                 const std::vector<ExpressionId>& parts) const {
    const ExpressionTraits& first = traits_[parts.front()];
    switch (node.kind) {
      case ExpressionKind::named:
        return node.named == NamedKind::prescribed ? sum_traits(leaf_traits(uses_time), first)
                                                   : first;
      case ExpressionKind::add:
        return fold_traits(parts, sum_traits);
      case ExpressionKind::multiply:
        return fold_traits(parts, product_traits);
      case ExpressionKind::divide:
        return product_traits(first, opaque_traits(traits_[parts[1]]));
      case ExpressionKind::power:
        return power_traits(first, node.number);
      case ExpressionKind::function:
        return sum_traits(leaf_traits(is_kinked(node.function) ? Ingredients{uses_kink} : 0),
                          opaque_traits(fold_traits(parts, sum_traits)));
      case ExpressionKind::time_derivative:
        return derivative_traits(first);
      default:
        return first;
    }
  }

  template <class Combine>
  [[nodiscard]] ExpressionTraits fold_traits(const std::vector<ExpressionId>& parts,
                                             Combine combine) const {
    ExpressionTraits result = traits_[parts.front()];
    for (std::size_t i = 1; i < parts.size(); ++i) result = combine(result, traits_[parts[i]]);
    return result;
  }

  const Model& model_;
  std::vector<ExpressionTraits> traits_;
};

}  // namespace

std::vector<ExpressionTraits> find_traits(const Model& model) { return TraitFinder(model).find(); }

}  // namespace elgen
