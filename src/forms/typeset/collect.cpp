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

bool holds_typed_sum(const BookProduct& product) {
  return std::ranges::any_of(product.factors, [](const BookFactor& factor) {
    return factor.place.group == FactorGroup::sum && factor.place.rank < untyped;
  });
}

}  // namespace

Arranger::MixedSum Arranger::mixed(const Polynomial& sum) {
  const auto parts = group_terms_by(
      algebra_, sum, [](const Atom& atom) { return atom.kind != AtomKind::circular; });
  MixedSum result;
  for (const auto& [powers, circular] : parts) {
    if (circular.size() == 1 && circular.begin()->first.empty()) {
      result.push_back({circular.begin()->second.real, powers, {}});
      continue;
    }
    const auto terms = shortest_terms(algebra_, circular, most_terms);
    if (!terms) throw TooLongForABook();
    for (const RealTerm& term : *terms) result.push_back({term.coefficient, powers, term.circular});
  }
  if (result.size() > most_terms) throw TooLongForABook();
  return result;
}

BookProduct Arranger::book_product(const RealTerm& term) const {
  BookProduct result;
  result.number = term.coefficient;
  multiply(result, term.powers);
  for (const CircularPower& power : term.circular) elgen::multiply(result, algebra_, power);
  return result;
}

/// The powers common to all terms.
BookProduct Arranger::shared_powers(const MixedSum& sum) const {
  Polynomial powers;
  for (const RealTerm& term : sum) powers.try_emplace(term.powers, Gaussian{1, 0});
  BookProduct shared;
  take_monomial(powers, shared);
  return shared;
}

/// The common factors of all terms times the sum of the remaining factors.
BookProduct Arranger::book_product(MixedSum sum) {
  BookProduct result = shared_powers(sum);
  Monomial taken;
  for (const BookFactor& factor : result.factors) taken.push_back({factor.atom, -factor.exponent});
  std::ranges::sort(taken, {}, &AtomPower::atom);
  for (RealTerm& term : sum) term.powers = elgen::product(term.powers, taken);
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
  multiply_once(result, collected(sum));
  return result;
}

/// Combines all terms with the same coordinates, sines and cosines into one product.
BookSum Arranger::group_by_kind(const MixedSum& sum) {
  struct Kind {
    RealTerm shared = {};
    MixedSum of_parameters = {};
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
  BookSum result;
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

/// m (a + b) + c, if m is the parameter that most terms, but not all, contain.
std::optional<BookSum> Arranger::collect_by_parameter(const MixedSum& sum) {
  std::map<std::pair<FactorPlace, AtomId>, std::size_t> parameters;  // numbers share one place
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
  MixedSum with;
  MixedSum without;
  for (const RealTerm& term : sum) {
    const bool has_it = std::ranges::any_of(
        term.powers, [&](const AtomPower& p) { return p.atom == most.first && p.exponent > 0; });
    (has_it ? with : without).push_back(term);
  }
  BookSum result = collected(without);
  BookProduct whole = book_product(with);
  for (RealTerm& term : with) {
    term.powers = elgen::product(term.powers, Monomial{{most.first, -1}});
  }
  BookProduct group;
  multiply(group, Monomial{{most.first, 1}});
  multiply(group, collected(with), 1);
  const bool is_whole =
      holds_typed_sum(whole) || written_factors({{whole}}) < written_factors({{group}});
  result.terms.push_back(is_whole ? std::move(whole) : std::move(group));
  return result;
}

const BookSum& Arranger::collected(const MixedSum& sum) {
  const auto known = collected_.find(sum);
  if (known != collected_.end()) return known->second;
  return collected_.emplace(sum, collect_terms(sum)).first->second;
}

/// The shorter result of group_by_kind() and collect_by_parameter(). If both are equally long, the
/// result that contains a typed sum.
BookSum Arranger::collect_terms(const MixedSum& sum) {
  BookSum best = group_by_kind(sum);
  if (sum.size() > 2 && sum.size() <= longest_collected) {
    std::optional<BookSum> other = collect_by_parameter(sum);
    const bool is_typed = other && std::ranges::any_of(other->terms, holds_typed_sum);
    const std::size_t margin = is_typed ? 1 : 0;
    if (other && written_factors(*other) < written_factors(best) + margin) {
      best = std::move(*other);
    }
  }
  sort_terms(best);
  return best;
}

}  // namespace elgen
