// collect: groups terms that share coordinates or a parameter:
//
//     (m1 + m2) g l1 sin x + m2 g l2 sin y
#include <algorithm>
#include <map>
#include <utility>

#include "forms/present/polynomial.hpp"
#include "forms/typeset/arrange.hpp"
#include "forms/write/rewritings.hpp"

namespace elgen {
namespace {

bool contains_typed_sum(const TextbookProduct& product) {
  return std::ranges::any_of(product.factors, [](const TextbookFactor& factor) {
    return factor.place.group == FactorGroup::sum && factor.place.rank < untyped_rank;
  });
}

}  // namespace

Arranger::RealTermSum Arranger::real_term_sum(const Polynomial& sum) {
  const auto parts = group_terms_by_atoms(
      algebra_, sum, [](const Atom& atom) { return atom.kind != AtomKind::circular; });
  RealTermSum result;
  for (const auto& [powers, circular] : parts) {
    if (circular.size() == 1 && circular.begin()->first.empty()) {
      result.push_back({circular.begin()->second.real, powers, {}});
      continue;
    }
    const auto terms = shortest_terms(algebra_, circular, most_terms);
    if (!terms) throw TextbookLengthError();
    for (const RealTerm& term : *terms) result.push_back({term.coefficient, powers, term.circular});
  }
  if (result.size() > most_terms) throw TextbookLengthError();
  return result;
}

TextbookProduct Arranger::book_product(const RealTerm& term) const {
  TextbookProduct result;
  result.number = term.coefficient;
  multiply(result, term.powers);
  for (const CircularPower& power : term.circular) elgen::multiply(result, algebra_, power);
  return result;
}

/// The powers common to all terms.
TextbookProduct Arranger::shared_powers(const RealTermSum& sum) const {
  Polynomial powers;
  for (const RealTerm& term : sum) powers.try_emplace(term.powers, GaussianRational{1, 0});
  TextbookProduct shared;
  take_monomial(powers, shared);
  return shared;
}

/// `sum` as one product: its common factors, times the sum of the terms divided by these factors.
TextbookProduct Arranger::book_product(RealTermSum sum) {
  TextbookProduct result = shared_powers(sum);
  Monomial shift;
  for (const TextbookFactor& factor : result.factors)
    shift.push_back({factor.atom, -factor.exponent});
  std::ranges::sort(shift, {}, &AtomPower::atom);
  for (RealTerm& term : sum) term.powers = elgen::product(term.powers, shift);
  const bool is_plain =
      std::ranges::all_of(sum, [](const RealTerm& term) { return term.circular.empty(); });
  if (is_plain) {
    Polynomial plain;
    for (const RealTerm& term : sum) add_term(plain, term.powers, {term.coefficient, 0});
    const SplitSum whole = this->split_sum(std::move(plain));
    if (!whole.front.factors.empty()) {
      elgen::multiply(result, book_product(whole));
      return result;
    }
  }
  multiply_by_sum(result, collected_sum(sum));
  return result;
}

/// Combines all terms with the same coordinates, sines and cosines into one product.
TextbookSum Arranger::group_by_coordinates(const RealTermSum& sum) {
  struct Kind {
    RealTerm shared = {};
    RealTermSum of_parameters = {};
  };
  std::vector<Kind> kinds;
  for (const RealTerm& term : sum) {
    RealTerm shared{1, {}, term.circular};
    RealTerm rest{term.coefficient, {}, {}};
    for (const AtomPower& power : term.powers) {
      const bool is_parameter = atom_factor(power).place.group == FactorGroup::parameter;
      (is_parameter ? rest : shared).powers.push_back(power);
    }
    auto known = std::ranges::find_if(kinds, [&](const Kind& kind) {
      return kind.shared.powers == shared.powers && kind.shared.circular == shared.circular;
    });
    if (known == kinds.end()) known = kinds.insert(known, Kind{std::move(shared), {}});
    known->of_parameters.push_back(std::move(rest));
  }
  TextbookSum result;
  for (const auto& [shared, of_parameters] : kinds) {
    const bool stands_alone = shared.powers.empty() && shared.circular.empty() &&
                              shared_powers(of_parameters).factors.empty();
    if (stands_alone || of_parameters.size() == 1) {
      for (const RealTerm& term : of_parameters) {
        result.terms.push_back(book_product(term));
        elgen::multiply(result.terms.back(), book_product(shared));
      }
    } else {
      result.terms.push_back(book_product(of_parameters));
      elgen::multiply(result.terms.back(), book_product(shared));
    }
  }
  return result;
}

/// m (a + b) + c, with m the most frequent parameter that some term lacks; none if m occurs once.
std::optional<TextbookSum> Arranger::collect_by_parameter(const RealTermSum& sum) {
  std::map<std::pair<FactorPlace, AtomId>, std::size_t> parameters;  // pi and sqrt(2) share a place
  for (const RealTerm& term : sum) {
    for (const AtomPower& power : term.powers) {
      const FactorPlace place = atom_factor(power).place;
      if (place.group != FactorGroup::parameter || power.exponent < 1) continue;
      ++parameters[{place, power.atom}];
    }
  }
  std::pair<AtomId, std::size_t> most{0, 1};
  for (const auto& [parameter, count] : parameters) {
    if (count > most.second && count < sum.size()) most = {parameter.second, count};
  }
  if (most.second < 2) return std::nullopt;
  RealTermSum with;
  RealTermSum without;
  for (const RealTerm& term : sum) {
    const bool has_it = std::ranges::any_of(
        term.powers, [&](const AtomPower& p) { return p.atom == most.first && p.exponent > 0; });
    (has_it ? with : without).push_back(term);
  }
  TextbookSum result = collected_sum(without);
  TextbookProduct whole = book_product(with);
  for (RealTerm& term : with) {
    term.powers = elgen::product(term.powers, Monomial{{most.first, -1}});
  }
  TextbookProduct group;
  multiply(group, Monomial{{most.first, 1}});
  multiply(group, collected_sum(with), 1);
  const bool is_whole = contains_typed_sum(whole) ||
                        count_written_factors({{whole}}) < count_written_factors({{group}});
  result.terms.push_back(is_whole ? std::move(whole) : std::move(group));
  return result;
}

const TextbookSum& Arranger::collected_sum(const RealTermSum& sum) {
  const auto known = collected_.find(sum);
  if (known != collected_.end()) return known->second;
  return collected_.emplace(sum, collect_terms(sum)).first->second;
}

/// The shorter result of group_by_coordinates() and collect_by_parameter(). On a tie, the result of
/// collect_by_parameter() if this result contains a typed sum, otherwise the other result.
TextbookSum Arranger::collect_terms(const RealTermSum& sum) {
  TextbookSum best = group_by_coordinates(sum);
  if (sum.size() > 2 && sum.size() <= most_collected_terms) {
    std::optional<TextbookSum> other = collect_by_parameter(sum);
    const bool is_typed = other && std::ranges::any_of(other->terms, contains_typed_sum);
    const std::size_t margin = is_typed ? 1 : 0;
    if (other && count_written_factors(*other) < count_written_factors(best) + margin) {
      best = std::move(*other);
    }
  }
  sort_terms(best);
  return best;
}

}  // namespace elgen
