// build_closed_graph: see closed_graph.hpp. If sqrt(r) divides the numerator and r^k divides the
// denominator, sqrt(r)/r^k is written as 1/(sqrt(r) r^(k - 1)).
#include "forms/write/closed_graph.hpp"

#include <algorithm>

#include "forms/present/polynomial.hpp"
#include "program/graph/rebuild.hpp"

namespace elgen {
namespace {

using cln::cl_RA;

/// Thrown if a sum exceeds the limit of terms.
struct TooManyTerms {};

/// The divisors that at least two terms contain, each with its lowest exponent; exponentials are
/// excluded.
Monomial shared_divisors(const Algebra& algebra, const Polynomial& sum) {
  struct Divisor {
    std::int32_t exponent = 0;
    std::size_t terms = 0;
  };
  std::map<AtomId, Divisor> divisors;
  for (const auto& [monomial, coefficient] : sum) {
    for (const AtomPower& power : split_monomial(algebra, monomial).powers) {
      if (power.exponent > 0) continue;
      Divisor& divisor = divisors[power.atom];
      divisor.exponent = std::min(divisor.exponent, power.exponent);
      ++divisor.terms;
    }
  }
  Monomial shared;
  for (const auto& [id, divisor] : divisors) {
    if (divisor.terms > 1) shared.push_back({id, divisor.exponent});
  }
  return shared;
}

std::optional<AtomId> find_root_atom(const Algebra& algebra, const Polynomial& radicand) {
  for (AtomId id = 0; id < algebra.atoms.size(); ++id) {
    const Atom& atom = algebra.atoms[id];
    if (atom.kind != AtomKind::root || !atom.arguments[0].denominator.empty()) continue;
    if (radicand == atom.arguments[0].numerator) return id;
  }
  return std::nullopt;
}

std::vector<RealTerm> terms_or_throw(std::optional<std::vector<RealTerm>> terms) {
  if (!terms) throw TooManyTerms();
  return std::move(*terms);
}

/// The terms of a sum. If `layout.trigonometry` is missing, the coefficient of each product of
/// rates gets its own shortest form.
std::vector<RealTerm> terms_of(const Algebra& algebra, const Polynomial& polynomial, Layout layout,
                               std::size_t most) {
  if (layout.trigonometry) {
    return terms_or_throw(real_terms(algebra, polynomial, *layout.trigonometry, most));
  }
  std::vector<RealTerm> all;
  for (const auto& [rates, rest] : group_terms_by_atoms(algebra, polynomial, is_rate)) {
    const Polynomial part = multiply_by_term(rest, {1, 0}, rates);
    const auto terms = terms_or_throw(shortest_terms(algebra, part, most));
    if (all.size() + terms.size() > most) throw TooManyTerms();
    all.insert(all.end(), terms.begin(), terms.end());
  }
  return all;
}

/// The factors of one term, with a list for each level of Grouping. The coefficient of the term is
/// a factor in `rest`.
struct TermFactors {
  std::vector<Power> rates = {};
  std::vector<Power> coordinates = {};
  std::vector<Power> rest = {};
};

class ClosedGraphBuilder {
 public:
  ClosedGraphBuilder(Graph& graph, const Algebra& algebra, Layout layout, std::size_t most)
      : graph_(graph), algebra_(algebra), layout_(layout), most_(most) {}

  SignedNode build_fraction(const Fraction& form) {
    std::vector<SignedNode> parts;
    for (const Fraction& part : split_by_roots(algebra_, form))
      parts.push_back(build_fraction_part(part));
    return graph_.sum(parts);
  }

 private:
  SignedNode build_fraction_part(Fraction form) {
    std::vector<Power> factors;
    merge_root_powers(form, factors);
    // x/l + y/l^2 = (x l + y)/l^2
    const Monomial divisors = shared_divisors(algebra_, form.numerator);
    for (const AtomPower& power : divisors)
      factors.push_back({build_atom(power.atom), power.exponent});
    form.numerator = multiply_by_term(form.numerator, {1, 0}, power(divisors, -1));
    factors.push_back({build_sum(form.numerator), 1});
    for (const auto& [factor, exponent] : form.denominator) {
      factors.push_back({build_sum(algebra_.factors[factor].shown), -exponent});
    }
    return graph_.product(factors);
  }

  /// n sqrt(r) / r^k -> n sqrt(r)^-1 / r^(k-1)
  void merge_root_powers(Fraction& form, std::vector<Power>& factors) {
    for (auto& [factor, exponent] : form.denominator) {
      const std::optional<AtomId> root = find_root_atom(algebra_, algebra_.factors[factor].shown);
      if (!root || exponent == 0) continue;
      if (exponent_of(common_powers(form.numerator), *root) < 1) continue;
      form.numerator = multiply_by_term(form.numerator, {1, 0}, Monomial{{*root, -1}});
      --exponent;
      const SignedNode radicand = arguments_of(*root)[0];
      factors.push_back({graph_.square_root(radicand), -1});
    }
    std::erase_if(form.denominator, [](const auto& factor) { return factor.second == 0; });
  }

  SignedNode build_sum(const Polynomial& polynomial) {
    std::vector<TermFactors> factors;
    for (const RealTerm& term : terms_of(algebra_, polynomial, layout_, most_)) {
      factors.push_back(factors_of(term));
    }
    if (layout_.grouping == Grouping::none) return sum_of_products(factors);
    return sum_of_groups(factors, &TermFactors::rates);
  }

  SignedNode sum_of_products(const std::vector<TermFactors>& terms) {
    std::vector<SignedNode> refs;
    for (const TermFactors& term : terms) {
      std::vector<Power> all = term.rest;
      all.insert(all.end(), term.coordinates.begin(), term.coordinates.end());
      all.insert(all.end(), term.rates.begin(), term.rates.end());
      refs.push_back(graph_.product(all));
    }
    return graph_.sum(refs);
  }

  /// Collects terms whose factors `key` are equal. Each group gives one product: `key` times the
  /// sum of the terms without the factors `key`.
  SignedNode sum_of_groups(const std::vector<TermFactors>& terms,
                           std::vector<Power> TermFactors::*key) {
    using Group = std::pair<SignedNode, std::vector<TermFactors>>;
    std::vector<Group> groups;
    for (TermFactors term : terms) {
      const SignedNode shared = graph_.product(term.*key);
      (term.*key).clear();
      auto known = std::ranges::find(groups, shared, &Group::first);
      if (known == groups.end()) known = groups.insert(known, Group{shared, {}});
      known->second.push_back(std::move(term));
    }
    const bool is_split_again =
        key == &TermFactors::rates && layout_.grouping == Grouping::by_rates_and_coordinates;
    std::vector<SignedNode> refs;
    for (const auto& [shared, members] : groups) {
      const SignedNode rest = is_split_again ? sum_of_groups(members, &TermFactors::coordinates)
                                             : sum_of_products(members);
      refs.push_back(graph_.product({{shared, 1}, {rest, 1}}));
    }
    return graph_.sum(refs);
  }

  TermFactors factors_of(const RealTerm& term) {
    TermFactors factors;
    factors.rest.push_back({graph_.rational(term.coefficient), 1});
    for (const AtomPower& power : term.powers) {
      const Atom& atom = algebra_.atoms[power.atom];
      auto& part = is_rate(atom)        ? factors.rates
                   : is_parameter(atom) ? factors.rest
                                        : factors.coordinates;
      part.push_back({this->build_atom(power.atom), power.exponent});
    }
    for (const CircularPower& power : term.circular) {
      const SignedNode value = build_angle(power.angle);
      const SignedNode cosine = graph_.call(FunctionId::cos, {value});
      const SignedNode sine = graph_.call(FunctionId::sin, {value});
      if (power.cosine != 0) factors.coordinates.push_back({cosine, power.cosine});
      if (power.sine != 0) factors.coordinates.push_back({sine, power.sine});
    }
    return factors;
  }

  SignedNode build_angle(const Monomial& parts) {
    std::vector<SignedNode> terms;
    for (const AtomPower& part : parts) {
      const Atom& atom = algebra_.atoms[part.atom];
      const SignedNode argument = arguments_of(part.atom)[0];
      const SignedNode multiple = graph_.rational(cl_RA(part.exponent) / atom.divisor);
      terms.push_back(graph_.product({{multiple, 1}, {argument, 1}}));
    }
    return graph_.sum(terms);
  }

  SignedNode build_atom(AtomId id) {
    const Atom& atom = algebra_.atoms[id];
    if (atom.kind == AtomKind::leaf) return graph_.leaf(atom.leaf, atom.index);
    if (atom.kind == AtomKind::pi) return graph_.pi();
    if (atom.kind == AtomKind::unexpanded_sum)
      return copy_typed_sum(*algebra_.unexpanded_sums, atom.index);
    const std::vector<SignedNode>& arguments = arguments_of(id);
    if (atom.kind == AtomKind::root) return graph_.square_root(arguments[0]);
    return graph_.call(atom.function, arguments);
  }

  SignedNode copy_typed_sum(const Program& sums, std::uint32_t index) {
    const Function& sum = sums.functions[index];
    return copy_value(graph_, expressions_from_program(sums, sum, entries_of(sum)));
  }

  /// The arguments of an atom, memoised because arguments nest and an atom occurs in many terms.
  const std::vector<SignedNode>& arguments_of(AtomId id) {
    const auto known = arguments_.find(id);
    if (known != arguments_.end()) return known->second;
    std::vector<SignedNode> arguments;
    for (const Fraction& argument : algebra_.atoms[id].arguments) {
      arguments.push_back(build_fraction(argument));
    }
    return arguments_.emplace(id, std::move(arguments)).first->second;
  }

  Graph& graph_;
  const Algebra& algebra_;
  Layout layout_;
  std::size_t most_;
  std::map<AtomId, std::vector<SignedNode>> arguments_ = {};
};

}  // namespace

std::vector<Fraction> split_by_roots(const Algebra& algebra, const Fraction& form) {
  const auto parts = group_terms_by_atoms(
      algebra, form.numerator, [](const Atom& atom) { return atom.kind == AtomKind::root; });
  std::vector<Fraction> result;
  for (const auto& [roots, rest] : parts) {
    std::size_t work = 100'000;
    Fraction part{multiply_by_term(rest, {1, 0}, roots), form.denominator};
    if (parts.size() > 1) cancel_common_factors(part, algebra, work);
    result.push_back(std::move(part));
  }
  return result;
}

bool is_rate(const Atom& atom) {
  constexpr LeafSet others = Opcode::parameter | Opcode::coordinate | Opcode::time;
  return atom.kind == AtomKind::leaf && !others.has_any(atom.leaf);
}

bool is_parameter(const Atom& atom) {
  return atom.kind == AtomKind::pi ||
         (atom.kind == AtomKind::leaf && atom.leaf == Opcode::parameter);
}

std::optional<SignedNode> build_closed_graph(Graph& graph, const Algebra& algebra,
                                             const Fraction& form, Layout layout,
                                             std::size_t most) {
  try {
    return ClosedGraphBuilder(graph, algebra, layout, most).build_fraction(form);
  } catch (const TooManyTerms&) {
    return std::nullopt;
  }
}

}  // namespace elgen
