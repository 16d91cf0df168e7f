// The chain rule through definitions. No function recurses from a definition to its operands,
// because chains of definitions may be too long for the call stack.
#include "derive/formulate/chain_rule.hpp"

#include <map>
#include <utility>

namespace elgen {

using GiNaC::ex;

namespace {

LeafSet seed_dependence(const Definitions& definitions, const Seeds& seeds) {
  LeafSet mask;
  for (const auto& [leaf, seed] : seeds) mask |= definitions.places.at(leaf).leaf_dependence;
  return mask;
}

template <class IsWanted>
void append_partials(const Definitions& definitions, const ex& term, const IsWanted& is_wanted,
                     std::vector<PartialDerivative>& result) {
  for (const ex& symbol : symbols_of(definitions, term)) {
    if (!is_wanted(symbol)) continue;
    const ex partial = term.diff(GiNaC::ex_to<GiNaC::symbol>(symbol));
    if (!partial.is_zero()) result.push_back({symbol, partial});
  }
}

bool is_sum(const ex& value) { return GiNaC::is_a<GiNaC::add>(value); }

/// The partial derivatives of `value` with respect to its symbols for which `is_wanted` is true.
template <class IsWanted>
std::vector<PartialDerivative> wanted_partials(const Definitions& definitions, const ex& value,
                                               const IsWanted& is_wanted) {
  std::vector<PartialDerivative> result;
  if (!is_sum(value)) {
    append_partials(definitions, value, is_wanted, result);
    return result;
  }
  // Differentiates term by term. Differentiating the whole sum of n terms with respect to each of n
  // symbols would cost n^2.
  ExpressionMap<GiNaC::exvector> by_symbol;
  for (std::size_t i = 0; i < value.nops(); ++i) {
    std::vector<PartialDerivative> of_term;
    append_partials(definitions, value.op(i), is_wanted, of_term);
    for (const PartialDerivative& partial : of_term)
      by_symbol[partial.variable].push_back(partial.value);
  }
  for (const ex& symbol : symbols_of(definitions, value)) {
    const auto terms = by_symbol.find(symbol);
    if (terms == by_symbol.end()) continue;
    const ex sum = GiNaC::add(terms->second);
    if (!sum.is_zero()) result.push_back({symbol, sum});
  }
  return result;
}

/// The partial derivatives of a definition with respect to the symbols for which `is_wanted` is
/// true. A non-empty list `definition.derivatives` contains these derivatives.
template <class IsWanted>
std::vector<PartialDerivative> wanted_partials(const Definitions& definitions,
                                               const Definition& definition,
                                               const IsWanted& is_wanted) {
  if (definition.derivatives.empty())
    return wanted_partials(definitions, definition.value, is_wanted);
  std::vector<PartialDerivative> result;
  for (const auto& [leaf, slope] : definition.derivatives) {
    if (is_wanted(leaf)) result.push_back({leaf, slope});
  }
  return result;
}

/// The partial derivatives of `value`, an expression or a definition, with respect to its symbols
/// that depend on a leaf in `mask`.
template <class Value>
std::vector<PartialDerivative> partials_by_leaves(const Definitions& definitions,
                                                  const Value& value, LeafSet mask) {
  return wanted_partials(definitions, value, [&](const ex& symbol) {
    return definitions.places.at(symbol).leaf_dependence.has_any(mask);
  });
}

}  // namespace

std::vector<PartialDerivative> partial_derivatives(const Definitions& definitions, const ex& value,
                                                   LeafSet mask) {
  return partials_by_leaves(definitions, value, mask);
}

void add_seeds(Seeds& seeds, const std::vector<ex>& leaves, const std::vector<ex>& values) {
  for (std::size_t i = 0; i < leaves.size(); ++i) seeds.emplace(leaves[i], values[i]);
}

std::array<std::array<ex, 3>, 4> rate_matrix(const Symbols& symbols,
                                             const RotationPlace& rotation) {
  const std::size_t first = rotation.first_coordinate;
  const ex w = symbols.q[first] / 2;
  const ex x = symbols.q[first + 1] / 2;
  const ex y = symbols.q[first + 2] / 2;
  const ex z = symbols.q[first + 3] / 2;
  return {{{-x, -y, -z}, {w, -z, y}, {z, w, -x}, {-y, x, w}}};
}

Seeds motion_seeds(const Symbols& symbols) {
  Seeds seeds;
  add_seeds(seeds, symbols.q, symbols.q_rates);
  add_seeds(seeds, symbols.v, symbols.a);
  seeds.emplace(symbols.t, 1);
  return seeds;
}

Tangent::Tangent(Definitions& definitions, Seeds seeds, std::string suffix)
    : definitions_(definitions), tangents_(std::move(seeds)), suffix_(std::move(suffix)) {
  mask_ = seed_dependence(definitions_, tangents_);
}

template <class Value>
ex Tangent::differentiate_value(const Value& value) const {
  GiNaC::exvector terms;
  // Differentiates only with respect to symbols in `tangents_`. For the n columns of a matrix,
  // differentiating with respect to all n symbols would cost n^2 derivatives.
  const auto has_tangent = [this](const ex& symbol) {
    return tangents_.find(symbol) != tangents_.end();
  };
  for (const PartialDerivative& partial : wanted_partials(definitions_, value, has_tangent)) {
    terms.push_back(partial.value * tangents_.at(partial.variable));
  }
  return GiNaC::add(terms);
}

void Tangent::differentiate_definition(std::uint32_t definition) {
  const ex symbol = definitions_.list[definition].symbol;
  const std::string& base = definitions_.list[definition].name;
  Label label{base.empty() || suffix_.empty() ? std::string() : base + suffix_,
              definitions_.list[definition].origin};
  const ex rate = differentiate_value(definitions_.list[definition]);
  const ex defined = define(definitions_, rate, std::move(label));
  if (!defined.is_zero()) tangents_.emplace(symbol, defined);
}

ex Tangent::operator()(const ex& value) {
  // Outputs share the definitions of rates, so rates get no names from the current output.
  ValueMeaning wording = std::exchange(definitions_.meaning, {});
  visit_needed_definitions(definitions_, value, mask_, visited_, [this](std::uint32_t definition) {
    differentiate_definition(definition);
  });
  definitions_.meaning = std::move(wording);
  return differentiate_value(value);
}

namespace {

/// The summands of the adjoints: of the definitions that are not processed yet (latest first), and
/// of the variables of the gradient.
struct Adjoints {
  std::map<std::uint32_t, GiNaC::exvector, std::greater<>> by_definition;
  ExpressionMap<GiNaC::exvector> by_variable;
};

void accumulate_adjoints(const Definitions& definitions,
                         const std::vector<PartialDerivative>& factors, const ex& weight,
                         Adjoints& adjoints) {
  for (const PartialDerivative& factor : factors) {
    const SymbolPlace& at = definitions.places.at(factor.variable);
    const ex term = weight * factor.value;
    if (at.is_definition) {
      adjoints.by_definition[at.index].push_back(term);
    } else if (const auto found = adjoints.by_variable.find(factor.variable);
               found != adjoints.by_variable.end()) {
      found->second.push_back(term);
    }
  }
}

}  // namespace

std::vector<ex> gradient(Definitions& definitions, const std::vector<WeightedTerm>& sum,
                         const std::vector<ex>& variables) {
  Adjoints adjoints;
  LeafSet mask;
  for (const ex& variable : variables) {
    adjoints.by_variable.emplace(variable, GiNaC::exvector());
    mask |= definitions.places.at(variable).leaf_dependence;
  }
  for (const WeightedTerm& term : sum) {
    if (term.weight.is_zero()) continue;
    accumulate_adjoints(definitions, partial_derivatives(definitions, term.value, mask),
                        term.weight, adjoints);
  }
  while (!adjoints.by_definition.empty()) {
    const auto latest = adjoints.by_definition.begin();
    const std::uint32_t index = latest->first;
    const ex adjoint = define(definitions, GiNaC::add(latest->second));
    adjoints.by_definition.erase(latest);
    if (adjoint.is_zero()) continue;
    const std::vector<PartialDerivative> factors =
        partials_by_leaves(definitions, definitions.list[index], mask);
    accumulate_adjoints(definitions, factors, adjoint, adjoints);
  }
  std::vector<ex> result;
  result.reserve(variables.size());
  for (const ex& variable : variables) {
    result.emplace_back(GiNaC::add(adjoints.by_variable.at(variable)));
  }
  return result;
}

Substitution::Substitution(Definitions& definitions, Seeds values)
    : definitions_(definitions), values_(std::move(values)) {
  mask_ = seed_dependence(definitions_, values_);
}

ex Substitution::substitute_value(const ex& value) const {
  GiNaC::exmap replacements;
  for (const ex& symbol : symbols_of(definitions_, value)) {
    const auto found = values_.find(symbol);
    if (found != values_.end()) replacements.emplace(symbol, found->second);
  }
  return replacements.empty() ? value : value.subs(replacements, GiNaC::subs_options::no_pattern);
}

void Substitution::substitute_definition(std::uint32_t definition) {
  const Definition& old = definitions_.list[definition];
  const ex symbol = old.symbol;
  Label label{old.name, old.origin};
  const ex replaced = define(definitions_, substitute_value(old.value), std::move(label));
  if (!replaced.is_equal(symbol)) values_.emplace(symbol, replaced);
  auto& names = definitions_.value_names.names;
  if (const auto old_name = names.find(symbol); old_name != names.end()) {
    names.emplace(replaced, old_name->second);
  }
}

ex Substitution::operator()(const ex& value) {
  visit_needed_definitions(definitions_, value, mask_, visited_,
                           [this](std::uint32_t definition) { substitute_definition(definition); });
  return substitute_value(value);
}

}  // namespace elgen
