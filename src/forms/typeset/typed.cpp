// typed: the sums that the author of a model typed, the order and signs of their terms, and the
// order of parameters in products. Expectations are excluded: they state the expected result.
#include <algorithm>
#include <utility>

#include "elgen/references.hpp"
#include "forms/present/arithmetic.hpp"
#include "forms/present/polynomial.hpp"
#include "forms/typeset/arrange.hpp"

namespace elgen {
namespace {

constexpr std::size_t most_sums = 200;
constexpr std::size_t most_terms_of_a_sum = 30;

/// True if the author of the model wrote the expression of a root. elgen itself adds the places,
/// spins and inertias of points and bodies in frames, the reactions, and, in a model with frames,
/// the equations of constraints.
bool is_typed_by_author(const Model& model, const Root& root) {
  const auto stands_in_frame = [&](const auto& entries) {
    return entries[root.entity.index].local.has_value();
  };
  const bool is_in_frame =
      (root.entity.kind == EntityKind::point && stands_in_frame(model.points)) ||
      (root.entity.kind == EntityKind::body && stands_in_frame(model.bodies));
  if (is_in_frame) return root.role == RootRole::mass;
  if (root.entity.kind == EntityKind::force) return root.role == RootRole::value;
  if (root.entity.kind == EntityKind::constraint) {
    return root.role == RootRole::value && model.frames.empty();
  }
  return true;
}

/// The author's expressions of energies, definitions, points, bodies, forces and constraints, in
/// this order. The first occurrence of a sum decides how the sum is written.
std::vector<ExpressionId> typed_roots(const Model& model) {
  const std::vector<Root> all = roots_of(model);
  std::vector<ExpressionId> written;
  for (const EntityKind kind : {EntityKind::energy, EntityKind::definition, EntityKind::point,
                                EntityKind::body, EntityKind::force, EntityKind::constraint}) {
    for (const Root& root : all) {
      if (root.entity.kind == kind && is_typed_by_author(model, root))
        written.push_back(root.expression);
    }
  }
  return written;
}

std::vector<ExpressionId> find_sums(const Model& model, const std::vector<ExpressionId>& all) {
  std::vector<ExpressionId> sums;
  for (const ExpressionId id : all) {
    const Expression& e = model.expressions[id];
    if (e.kind == ExpressionKind::add && e.operands.size() <= most_terms_of_a_sum) {
      sums.push_back(id);
    }
  }
  return sums;
}

std::optional<TypedSum> typed_sum(ClosedForms& forms, const Model& model,
                                  const FixedParameters& fixed, ExpressionId id) {
  const std::optional<Fraction> whole = closed_form(forms, model, fixed, id);
  if (!whole || !whole->denominator.empty() || whole->numerator.size() < 2) return std::nullopt;
  TypedSum sum{whole->numerator, atoms_of(whole->numerator)};
  for (const ExpressionId operand : model.expressions[id].operands) {
    std::optional<Fraction> term = closed_form(forms, model, fixed, operand);
    if (!term) return std::nullopt;
    if (!term->numerator.empty()) sum.terms.push_back(std::move(*term));
  }
  const bool is_number = std::ranges::all_of(
      sum.atoms, [&forms](AtomId atom) { return elgen::is_number(forms.algebra.atoms[atom]); });
  if (sum.terms.size() < 2 || is_number) return std::nullopt;  // a sum of numbers is no typed sum
  const bool holds_root = std::ranges::any_of(sum.atoms, [&forms](AtomId atom) {
    return forms.algebra.atoms[atom].kind == AtomKind::root;
  });
  if (holds_root) {
    const OptionalFraction square = Arithmetic(forms.algebra).multiply(*whole, *whole);
    if (square && square->denominator.empty()) sum.square = square->numerator;
  }
  const auto named =
      std::ranges::find(model.definitions, id, [](const NamedExpression& d) { return d.value; });
  if (named != model.definitions.end()) {
    sum.definition = static_cast<std::uint32_t>(named - model.definitions.begin());
  }
  return sum;
}

/// The value of an expression, if it is a single term with a root or a function; otherwise the
/// empty sum.
Polynomial single_function_term(ClosedForms& forms, const Model& model,
                                const FixedParameters& fixed, ExpressionId id) {
  const std::optional<Fraction> form = closed_form(forms, model, fixed, id);
  if (!form || !form->denominator.empty() || form->numerator.size() != 1) return {};
  const bool is_long = std::ranges::any_of(atoms_of(form->numerator), [&forms](AtomId atom) {
    const AtomKind kind = forms.algebra.atoms[atom].kind;
    return kind == AtomKind::root || kind == AtomKind::call;
  });
  return is_long ? form->numerator : Polynomial{};
}

/// For each parameter: true if its unit is `unit`, or if it is a leaf of one of the expressions.
std::vector<bool> parameter_flags(const Model& model, const Unit& unit,
                                  const std::vector<ExpressionId>& expressions) {
  std::vector<bool> result;
  for (const Parameter& parameter : model.parameters) {
    result.push_back(parameter.unit && *parameter.unit == unit);
  }
  for (const ExpressionId id : reachable_expressions(model, expressions)) {
    const Expression& e = model.expressions[id];
    if (is_leaf(e, Opcode::parameter)) result[e.index] = true;
  }
  return result;
}

/// For each parameter: true for g and other accelerations.
std::vector<bool> acceleration_flags(const Model& model) {
  static const Unit second = *find_unit("s");
  return parameter_flags(model, *find_unit("m") / (second * second),
                         filter_roots(model, [](const Root& root) {
                           return root.entity.kind == EntityKind::gravity;
                         }));
}

std::vector<bool> mass_flags(const Model& model) {
  return parameter_flags(model, *find_unit("kg"), filter_roots(model, [](const Root& root) {
                           return root.role == RootRole::mass;
                         }));
}

/// The order of declaration, except that g and other accelerations follow the last mass.
std::vector<std::uint32_t> declared_order(const Model& model,
                                          const std::vector<bool>& are_accelerations) {
  const std::vector<bool> are_masses = mass_flags(model);
  std::vector<std::uint32_t> order;
  std::vector<std::uint32_t> weights;
  std::size_t behind_masses = 0;
  for (std::uint32_t i = 0; i < model.parameters.size(); ++i) {
    if (are_accelerations[i]) {
      weights.push_back(i);
      continue;
    }
    order.push_back(i);
    if (are_masses[i]) behind_masses = order.size();
  }
  order.insert(order.begin() + static_cast<std::ptrdiff_t>(behind_masses), weights.begin(),
               weights.end());
  return order;
}

/// The parameters in each factor of a typed product: k and l for k*(x - l)^2.
std::vector<std::vector<std::uint32_t>> parameters_by_factor(const Model& model,
                                                             const Expression& product) {
  std::vector<std::vector<std::uint32_t>> factors;
  for (const ExpressionId operand : product.operands) {
    std::vector<std::uint32_t>& parameters = factors.emplace_back();
    for (const ExpressionId id : reachable_expressions(model, {operand})) {
      const Expression& e = model.expressions[id];
      if (is_leaf(e, Opcode::parameter)) parameters.push_back(e.index);
    }
  }
  return factors;
}

/// Reorders parameters as in typed products. The first product that contains two parameters decides
/// the order of these two parameters.
class ParameterOrder {
 public:
  explicit ParameterOrder(std::vector<std::uint32_t> declared)
      : order_(std::move(declared)), is_known_(order_.size() * order_.size()) {}

  void add_product(const std::vector<std::vector<std::uint32_t>>& factors) {
    for (std::size_t i = 0; i + 1 < factors.size(); ++i) {
      for (std::size_t k = i + 1; k < factors.size(); ++k) {
        for (const std::uint32_t first : factors[i]) {
          for (const std::uint32_t second : factors[k]) order_pair(first, second);
        }
      }
    }
  }

  [[nodiscard]] std::vector<std::uint32_t> parameter_positions() const {
    std::vector<std::uint32_t> result(order_.size());
    for (std::uint32_t i = 0; i < order_.size(); ++i) result[order_[i]] = i;
    return result;
  }

 private:
  void order_pair(std::uint32_t first, std::uint32_t second) {
    const std::size_t pair = first * order_.size() + second;
    const std::size_t opposite = second * order_.size() + first;
    if (first == second || is_known_[pair] || is_known_[opposite]) return;
    is_known_[pair] = true;
    const auto at = std::ranges::find(order_, first);
    const auto other = std::ranges::find(order_, second);
    if (at < other) return;
    // The order stays if typed products require a parameter between `second` and `first` to follow
    // `second` or to precede `first`.
    const bool is_bound = std::any_of(other, at, [&](std::uint32_t between) {
      return is_known_[second * order_.size() + between] ||
             is_known_[between * order_.size() + first];
    });
    if (!is_bound) std::rotate(other, at, at + 1);
  }

  std::vector<std::uint32_t> order_;
  std::vector<bool> is_known_;
};

}  // namespace

TypedForms typed_forms(Algebra& algebra, const Model& model, const FixedParameters& fixed) {
  const std::vector<ExpressionId> all = reachable_expressions(model, typed_roots(model));
  const std::vector<ExpressionId> ids = find_sums(model, all);
  TypedForms result;
  result.are_accelerations = acceleration_flags(model);
  ParameterOrder order(declared_order(model, result.are_accelerations));
  const bool is_robot = ids.size() > most_sums;
  for (const ExpressionId id : all) {
    const Expression& e = model.expressions[id];
    if (!is_robot && e.kind == ExpressionKind::multiply)
      order.add_product(parameters_by_factor(model, e));
  }
  result.parameter_places = order.parameter_positions();
  if (is_robot) return result;
  ClosedForms forms{std::move(algebra), {}};
  for (const NamedExpression& function : model.prescribed) {
    result.prescribed_values.push_back(single_function_term(forms, model, fixed, function.value));
  }
  for (const ExpressionId id : ids) {
    std::optional<TypedSum> sum = typed_sum(forms, model, fixed, id);
    const auto is_same = [&](const TypedSum& known) {
      return ratio_of(known.value, sum->value).has_value();
    };
    if (!sum) continue;
    const auto known = std::ranges::find_if(result.sums, is_same);
    if (known == result.sums.end()) {
      result.sums.push_back(std::move(*sum));
    } else if (sum->definition && !known->definition) {
      *known = std::move(*sum);  // prefer the value of a definition
    }
  }
  algebra = std::move(forms.algebra);
  std::ranges::stable_sort(result.sums, std::greater<>(),
                           [](const TypedSum& sum) { return sum.value.size(); });
  return result;
}

}  // namespace elgen
