// arrange: see arrange.hpp.
#include "typeset/arrange.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "choose/ways.hpp"
#include "present/polynomial.hpp"
#include "typeset/factors.hpp"

namespace elgen {
namespace {

/// Of longer sums nobody sees what their terms share.
constexpr std::size_t longest_collected = 40;

/// Longer sums get a name where the model has one for them.
constexpr std::size_t longest_filled_in = 12;

/// Of the product of rates of a term, in the order of a book: accelerations, the row's own first;
/// squares; other products; single rates; inputs; none.
int rank_of_rates(const Algebra& algebra, const Monomial& rates, std::optional<std::uint32_t> own) {
  std::int32_t degree = 0;
  bool is_input = false;
  for (const AtomPower& power : rates) {
    const Atom& atom = algebra.atoms[power.atom];
    if (atom.leaf == Opcode::acceleration) return own && atom.index == *own ? 0 : 1;
    is_input = is_input || atom.leaf == Opcode::input;
    degree += power.exponent;
  }
  if (rates.empty()) return 6;
  if (is_input) return 5;
  if (degree < 2) return 4;
  return rates.size() == 1 ? 2 : 3;
}

/// By the numbers of the leaves: atoms are numbered as they were met.
std::vector<std::pair<std::uint32_t, std::int32_t>> numbers_of(const Algebra& algebra,
                                                               const Monomial& rates) {
  std::vector<std::pair<std::uint32_t, std::int32_t>> numbers;
  for (const AtomPower& power : rates) {
    numbers.emplace_back(algebra.atoms[power.atom].index, -power.exponent);
  }
  std::ranges::sort(numbers);
  return numbers;
}

struct RateGroup {
  Monomial rates = {};
  Polynomial rest = {};
};

std::vector<RateGroup> rate_groups(const Algebra& algebra, const Polynomial& sum,
                                   std::optional<std::uint32_t> own) {
  std::map<Monomial, Polynomial, MonomialLess> parts;
  for (const auto& [monomial, coefficient] : sum) {
    Monomial rates;
    Monomial rest;
    for (const AtomPower& power : monomial) {
      (is_moving(algebra.atoms[power.atom]) ? rates : rest).push_back(power);
    }
    parts[rates].emplace(rest, coefficient);
  }
  std::vector<RateGroup> groups;
  for (auto& [rates, rest] : parts) groups.push_back({rates, std::move(rest)});
  std::ranges::stable_sort(groups, {}, [&](const RateGroup& group) {
    return std::pair(rank_of_rates(algebra, group.rates, own), numbers_of(algebra, group.rates));
  });
  return groups;
}

bool is_one(const Polynomial& sum) {
  return sum.size() == 1 && sum.begin()->first.empty() && sum.begin()->second.real == 1;
}

bool same_arguments(const Atom& x, const Atom& y) {
  const auto same_terms = [](const auto& s, const auto& t) {
    return s.first == t.first && s.second.real == t.second.real &&
           s.second.imaginary == t.second.imaginary;
  };
  return std::ranges::equal(x.arguments, y.arguments, [&](const Fraction& a, const Fraction& b) {
    return a.denominator == b.denominator &&
           std::ranges::equal(a.numerator, b.numerator, same_terms);
  });
}

/// Every square of `atom` as `one` + `sign` * the square of `other`.
Polynomial without_squares(const Polynomial& sum, AtomId atom, AtomId other, int one) {
  Polynomial result;
  for (const auto& [monomial, coefficient] : sum) {
    Polynomial term{{Monomial{}, coefficient}};
    for (const AtomPower& power : monomial) {
      const bool is_square = power.atom == atom && power.exponent >= 2;
      const std::int32_t left = is_square ? power.exponent % 2 : power.exponent;
      if (left != 0) term = scaled(term, {1, 0}, Monomial{{power.atom, left}});
      const Polynomial square = elgen::sum(constant(one), {{Monomial{{other, 2}}, {1, 0}}});
      for (std::int32_t i = 0; is_square && i < power.exponent / 2; ++i) {
        term = product(term, square);
      }
    }
    result = elgen::sum(std::move(result), term);
  }
  return result;
}

/// cosh^2 = 1 + sinh^2 in the direction that leaves fewer terms.
Polynomial by_hyperbolic_squares(const Algebra& algebra, Polynomial sum) {
  std::vector<AtomId> cosines;
  std::vector<AtomId> sines;
  for (AtomId id = 0; id < algebra.atoms.size(); ++id) {
    const Atom& atom = algebra.atoms[id];
    if (atom.kind != AtomKind::call) continue;
    if (atom.function == FunctionId::cosh) cosines.push_back(id);
    if (atom.function == FunctionId::sinh) sines.push_back(id);
  }
  for (const AtomId cosine : cosines) {
    for (const AtomId sine : sines) {
      if (!same_arguments(algebra.atoms[cosine], algebra.atoms[sine])) continue;
      for (Polynomial other :
           {without_squares(sum, sine, cosine, -1), without_squares(sum, cosine, sine, 1)}) {
        if (other.size() < sum.size()) sum = std::move(other);
      }
    }
  }
  return sum;
}

bool is_root_of(const Algebra& algebra, const BookFactor& factor, const Polynomial& radicand) {
  if (factor.kind != BookFactorKind::atom || factor.exponent < 1) return false;
  const Atom& atom = algebra.atoms[factor.atom];
  return atom.kind == AtomKind::root && atom.arguments[0].denominator.empty() &&
         sum(radicand, scaled(atom.arguments[0].numerator, {-1, 0})).empty();
}

/// Sums that no model has typed have this rank.
constexpr std::uint32_t untyped = 10'000;

bool holds_typed_sum(const BookProduct& product) {
  return std::ranges::any_of(product.factors, [](const BookFactor& factor) {
    return factor.place.group == FactorGroup::sum && factor.place.rank < untyped;
  });
}

bool same_waves(const std::vector<CircularPower>& x, const std::vector<CircularPower>& y) {
  return std::ranges::equal(x, y, [](const CircularPower& a, const CircularPower& b) {
    return a.angle == b.angle && a.cosine == b.cosine && a.sine == b.sine;
  });
}

bool holds_exponentials(const Algebra& algebra, const Polynomial& sum) {
  return std::ranges::any_of(sum, [&](const auto& term) {
    return std::ranges::any_of(term.first, [&](const AtomPower& power) {
      return algebra.atoms[power.atom].kind == AtomKind::circular;
    });
  });
}

}  // namespace

BookFactor Arranger::atom_factor(const AtomPower& power) const {
  BookFactor factor;
  factor.place = place_of(algebra_.atoms[power.atom], typed_.places);
  factor.atom = power.atom;
  factor.exponent = power.exponent;
  return factor;
}

void Arranger::multiply(BookProduct& product, const Monomial& powers) const {
  for (const AtomPower& power : powers) add_factor(product, atom_factor(power));
}

/// Sums of parameters stand where their first parameter would.
void Arranger::multiply(BookProduct& product, BookSum sum) const {
  sort_terms(sum);
  product.number = product.number * take_number(sum);
  BookFactor factor;
  factor.kind = BookFactorKind::sum;
  factor.place = {FactorGroup::sum, untyped};
  bool is_of_parameters = true;
  std::uint32_t first = UINT32_MAX;
  for (const BookProduct& term : sum.terms) {
    for (const BookFactor& each : term.factors) {
      is_of_parameters = is_of_parameters && each.place.group == FactorGroup::parameter;
      first = std::min(first, each.place.rank);
    }
  }
  if (is_of_parameters) factor.place = {FactorGroup::parameter, first};
  factor.sum = std::move(sum);
  add_factor(product, std::move(factor));
}

/// Powers that all terms have, of one sign; exponentials stay.
void Arranger::take_monomial(Polynomial& sum, BookProduct& front) const {
  if (sum.empty()) return;
  Monomial common;
  for (const AtomPower& power : sum.begin()->first) {
    if (algebra_.atoms[power.atom].kind != AtomKind::circular) common.push_back(power);
  }
  for (const auto& [monomial, coefficient] : sum) {
    for (AtomPower& power : common) {
      const auto own = std::ranges::find(monomial, power.atom, &AtomPower::atom);
      const std::int32_t exponent = own == monomial.end() ? 0 : own->exponent;
      const bool is_opposite = (exponent < 0) != (power.exponent < 0);
      if (exponent == 0 || is_opposite) {
        power.exponent = 0;
      } else if (std::abs(exponent) < std::abs(power.exponent)) {
        power.exponent = exponent;
      }
    }
    std::erase_if(common, [](const AtomPower& power) { return power.exponent == 0; });
  }
  if (common.empty()) return;
  sum = scaled(sum, {1, 0}, power(common, -1));
  multiply(front, common);
}

BookFactor Arranger::typed_factor(std::size_t typed) {
  const TypedSum& sum = typed_.sums[typed];
  BookFactor factor;
  factor.kind = BookFactorKind::sum;
  factor.place = {FactorGroup::sum, static_cast<std::uint32_t>(typed)};
  // The terms hold shorter sums only, so that this ends.
  const std::size_t outer = std::exchange(first_typed_, typed + 1);
  for (const Fraction& term : sum.terms) {
    for (BookProduct& part : in_front(term).terms) factor.sum.terms.push_back(std::move(part));
  }
  first_typed_ = outer;
  const bool of_parameters = is_of_parameters(algebra_, sum.value);
  if (of_parameters) {
    std::uint32_t first = UINT32_MAX;
    for (const auto& [monomial, coefficient] : sum.value) {
      for (const AtomPower& power : monomial)
        first = std::min(first, atom_factor(power).place.rank);
    }
    factor.place = {FactorGroup::parameter, first};
  }
  if (sum.definition && (of_parameters || written_factors(factor.sum) > longest_filled_in)) {
    factor.kind = BookFactorKind::name;
    factor.definition = *sum.definition;
  }
  return factor;
}

bool Arranger::take_typed(Polynomial& sum, BookProduct& front) {
  bool is_taken = false;
  const std::vector<AtomId> atoms = atoms_of(sum);
  for (std::size_t i = first_typed_; i < typed_.sums.size() && sum.size() > 1; ++i) {
    if (!std::ranges::includes(atoms, typed_.sums[i].atoms)) continue;
    std::int32_t exponent = 0;
    while (sum.size() > 1) {
      auto divided = elgen::quotient(sum, typed_.sums[i].value, work_);
      if (!divided) break;
      sum = std::move(*divided);
      ++exponent;
    }
    if (exponent == 0) continue;
    is_taken = true;
    BookFactor factor = typed_factor(i);
    factor.exponent = exponent;
    add_factor(front, std::move(factor));
  }
  return is_taken;
}

Arranger::Taken Arranger::taken(Polynomial sum) {
  Taken result;
  result.rest = by_hyperbolic_squares(algebra_, std::move(sum));
  take_monomial(result.rest, result.front);
  if (take_typed(result.rest, result.front)) take_monomial(result.rest, result.front);
  return result;
}

BookProduct Arranger::product(const Mixed& term) const {
  BookProduct result;
  result.number = term.number;
  multiply(result, term.powers);
  for (const CircularPower& power : term.circular) elgen::multiply(result, algebra_, power);
  return result;
}

BookProduct Arranger::product(const Taken& taken) {
  BookProduct result = taken.front;
  if (is_one(taken.rest)) return result;
  BookSum rest = terms(taken.rest);
  if (rest.terms.size() == 1) {
    elgen::multiply(result, rest.terms.front());
  } else if (!rest.terms.empty()) {
    multiply(result, std::move(rest));
  } else {
    result = {0, {}};
  }
  return result;
}

BookProduct Arranger::product(const Polynomial& sum) { return product(taken(sum)); }

void Arranger::divide(BookProduct& product, const Polynomial& factor, std::int32_t exponent) {
  if (exponent == 0) return;
  const BookProduct below = this->product(factor);
  product.number = product.number / cln::expt(below.number, exponent);
  for (BookFactor part : below.factors) {
    part.exponent *= -exponent;
    add_factor(product, std::move(part));
  }
}

/// Factors of sines and cosines are multiplied: present has sin x as 2 sin(x/2) cos(x/2).
void Arranger::divide(BookProduct& product, const Fraction& form) {
  Polynomial waves = constant(1);
  for (const auto& [factor, exponent] : form.denominator) {
    const Polynomial& shown = algebra_.factors[factor].shown;
    const auto root = std::ranges::find_if(
        product.factors, [&](const BookFactor& each) { return is_root_of(algebra_, each, shown); });
    if (root != product.factors.end()) {  // sqrt(r)/r
      BookFactor twice = *root;
      twice.exponent = -2;
      add_factor(product, std::move(twice));
      divide(product, shown, exponent - 1);
    } else if (!holds_exponentials(algebra_, shown)) {
      divide(product, shown, exponent);
    } else {
      for (std::int32_t i = 0; i < exponent; ++i) waves = elgen::product(waves, shown);
    }
    if (waves.size() > most_terms) throw TooLongForABook();
  }
  if (!is_one(waves)) divide(product, waves, 1);
}

BookProduct Arranger::product(const Fraction& form) {
  BookProduct result = product(form.numerator);
  divide(result, form);
  return result;
}

Arranger::MixedSum Arranger::mixed(const Polynomial& sum) {
  std::map<Monomial, Polynomial, MonomialLess> parts;
  for (const auto& [monomial, coefficient] : sum) {
    const auto [powers, angle] = split(algebra_, monomial);
    parts[powers].emplace(angle, coefficient);
  }
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

/// What all terms have in common, times the sum of what is left of them.
BookProduct Arranger::product(MixedSum sum) {
  Polynomial powers;
  for (const Mixed& term : sum) powers.emplace(term.powers, Gaussian{1, 0});
  BookProduct result;
  Polynomial left = powers;
  take_monomial(left, result);
  Monomial taken;
  for (const BookFactor& factor : result.factors) taken.push_back({factor.atom, -factor.exponent});
  std::ranges::sort(taken, {}, &AtomPower::atom);
  for (Mixed& term : sum) term.powers = elgen::product(term.powers, taken);
  const bool is_plain =
      std::ranges::all_of(sum, [](const Mixed& term) { return term.circular.empty(); });
  if (is_plain) {
    Polynomial plain;
    for (const Mixed& term : sum) add_term(plain, term.powers, {term.number, 0});
    Taken whole{{1, {}}, std::move(plain)};
    if (take_typed(whole.rest, whole.front)) {
      elgen::multiply(result, product(whole));
      return result;
    }
  }
  BookSum rest = collected(sum);
  if (rest.terms.size() == 1) {
    elgen::multiply(result, rest.terms.front());
  } else {
    multiply(result, std::move(rest));
  }
  return result;
}

bool Arranger::share_a_factor(const MixedSum& sum) const {
  Polynomial powers;
  for (const Mixed& term : sum) powers.emplace(term.powers, Gaussian{1, 0});
  BookProduct front;
  take_monomial(powers, front);
  return !front.factors.empty();
}

/// One product for all terms with the same coordinates, sines and cosines.
BookSum Arranger::by_kinds(const MixedSum& sum) {
  struct Kind {
    Mixed shared = {};
    MixedSum of_parameters = {};
  };
  std::vector<Kind> kinds;
  for (const Mixed& term : sum) {
    Mixed shared{1, {}, term.circular};
    Mixed rest{term.number, {}, {}};
    for (const AtomPower& power : term.powers) {
      const bool is_parameter = atom_factor(power).place.group == FactorGroup::parameter;
      (is_parameter ? rest : shared).powers.push_back(power);
    }
    auto known = std::ranges::find_if(kinds, [&](const Kind& kind) {
      return kind.shared.powers == shared.powers &&
             same_waves(kind.shared.circular, shared.circular);
    });
    if (known == kinds.end()) known = kinds.insert(known, Kind{std::move(shared), {}});
    known->of_parameters.push_back(std::move(rest));
  }
  BookSum result;
  for (const auto& [shared, of_parameters] : kinds) {
    const bool stands_alone =
        shared.powers.empty() && shared.circular.empty() && !share_a_factor(of_parameters);
    if (stands_alone || of_parameters.size() == 1) {
      for (const Mixed& term : of_parameters) {
        result.terms.push_back(product(term));
        elgen::multiply(result.terms.back(), product(shared));
      }
    } else {
      result.terms.push_back(product(of_parameters));
      elgen::multiply(result.terms.back(), product(shared));
    }
  }
  return result;
}

/// m (a + b) + c, m the parameter of the most terms, where not all have one.
std::optional<BookSum> Arranger::by_shared_parameter(const MixedSum& sum) {
  std::map<FactorPlace, std::pair<AtomId, std::size_t>> parameters;
  for (const Mixed& term : sum) {
    for (const AtomPower& power : term.powers) {
      const FactorPlace place = atom_factor(power).place;
      if (place.group != FactorGroup::parameter || power.exponent < 1) continue;
      ++parameters.try_emplace(place, power.atom, 0).first->second.second;
    }
  }
  std::pair<AtomId, std::size_t> most{0, 1};
  for (const auto& [place, found] : parameters) {
    if (found.second > most.second && found.second < sum.size()) most = found;
  }
  if (most.second < 2) return std::nullopt;
  MixedSum with;
  MixedSum without;
  for (const Mixed& term : sum) {
    const bool has_it = std::ranges::any_of(
        term.powers, [&](const AtomPower& p) { return p.atom == most.first && p.exponent > 0; });
    (has_it ? with : without).push_back(term);
  }
  BookSum result = collected(without);
  BookProduct whole = product(with);
  for (Mixed& term : with) {
    term.powers = elgen::product(term.powers, Monomial{{most.first, -1}});
  }
  BookSum rest = collected(with);
  if (holds_typed_sum(whole) || rest.terms.size() == 1) {
    result.terms.push_back(std::move(whole));
    return result;
  }
  BookProduct group;
  multiply(group, Monomial{{most.first, 1}});
  multiply(group, std::move(rest));
  result.terms.push_back(std::move(group));
  return result;
}

/// The shorter way; one with a sum as typed, where they are as long.
BookSum Arranger::collected(const MixedSum& sum) {
  BookSum best = by_kinds(sum);
  if (sum.size() > 2 && sum.size() <= longest_collected) {
    std::optional<BookSum> other = by_shared_parameter(sum);
    const bool is_typed = other && std::ranges::any_of(other->terms, holds_typed_sum);
    const std::size_t margin = is_typed ? 1 : 0;
    if (other && written_factors(*other) < written_factors(best) + margin) {
      best = std::move(*other);
    }
  }
  sort_terms(best);
  return best;
}

BookSum Arranger::terms_without_rates(const Polynomial& sum) {
  Taken whole{{1, {}}, sum};
  if (!take_typed(whole.rest, whole.front)) return collected(mixed(sum));
  take_monomial(whole.rest, whole.front);
  return {{product(whole)}};
}

BookSum Arranger::terms(const Polynomial& sum, std::optional<std::uint32_t> own) {
  BookSum result;
  for (const auto& [rates, rest] : rate_groups(algebra_, sum, own)) {
    if (rates.empty()) {
      for (BookProduct& term : terms_without_rates(rest).terms) {
        result.terms.push_back(std::move(term));
      }
      continue;
    }
    result.terms.push_back(product(rest));
    multiply(result.terms.back(), rates);
  }
  return result;
}

namespace {

/// Whether a parameter that stands first in a term of a sum would stand before the front:
/// -g ((m1 + m2) a + m2 b) is not what books write.
bool hides_leading_factors(const BookProduct& product) {
  const FactorPlace first = product.factors.front().place;
  const auto sum = std::ranges::find(product.factors, BookFactorKind::sum, &BookFactor::kind);
  if (sum == product.factors.end() || sum->exponent != 1) return false;
  return std::ranges::any_of(sum->sum.terms, [&](const BookProduct& term) {
    return !term.factors.empty() && term.factors.front().place < first;
  });
}

}  // namespace

/// The parts of a fraction by rates, each over what does not divide it.
BookSum Arranger::parts(const Fraction& form, std::optional<std::uint32_t> own) {
  BookSum result;
  for (auto& [rates, rest] : rate_groups(algebra_, form.numerator, own)) {
    Fraction part{std::move(rest), form.denominator};
    divide_out(part, algebra_, work_);
    result.terms.push_back(product(part));
    multiply(result.terms.back(), rates);
  }
  return result;
}

BookSum Arranger::in_front(const Fraction& form) {
  if (form.numerator.empty()) return {};
  Taken whole = taken(form.numerator);
  if (form.denominator.empty()) {
    if (whole.front.factors.empty()) return terms(whole.rest);
    BookProduct product = this->product(whole);
    if (hides_leading_factors(product)) return terms(form.numerator);
    return {{std::move(product)}};
  }
  BookSum sum = parts({whole.rest, form.denominator});
  const auto divided = std::ranges::count_if(sum.terms, [](const BookProduct& term) {
    return std::ranges::any_of(term.factors,
                               [](const BookFactor& factor) { return factor.exponent < 0; });
  });
  if (sum.terms.size() > 1 && divided < 2) {
    if (whole.front.factors.empty()) return sum;
    multiply(whole.front, std::move(sum));
    return {{std::move(whole.front)}};
  }
  BookProduct product = this->product(whole);
  divide(product, form);
  return {{std::move(product)}};
}

BookSum Arranger::spread(const Fraction& form, std::optional<std::uint32_t> own) {
  const Polynomial numerator = by_hyperbolic_squares(algebra_, form.numerator);
  if (form.denominator.empty()) return terms(numerator, own);
  return parts({numerator, form.denominator}, own);
}

bool Arranger::is_one_product(const Fraction& form) {
  const BookSum written = in_front(form);
  return written.terms.size() == 1 &&
         std::ranges::none_of(written.terms.front().factors, [](const BookFactor& factor) {
           return factor.kind == BookFactorKind::sum;
         });
}

BookSum Arranger::quotient(const Fraction& above, const Fraction& below) {
  if (above.numerator.empty()) return {};
  if (above.denominator != below.denominator) throw TooLongForABook();
  Taken numerator{{1, {}}, by_hyperbolic_squares(algebra_, above.numerator)};
  Taken denominator{{1, {}}, by_hyperbolic_squares(algebra_, below.numerator)};
  take_monomial(numerator.rest, numerator.front);
  take_monomial(denominator.rest, denominator.front);
  BookProduct front = std::move(numerator.front);
  for (BookFactor factor : denominator.front.factors) {
    factor.exponent = -factor.exponent;
    add_factor(front, std::move(factor));
  }
  BookSum divisor = terms(denominator.rest);
  sort_terms(divisor);
  front.number = front.number / take_number(divisor);
  BookSum dividend = terms(numerator.rest);
  BookSum result;
  if (divisor.terms.size() > 1) {
    BookFactor factor;
    factor.kind = BookFactorKind::sum;
    factor.place = {FactorGroup::sum, UINT32_MAX};
    factor.exponent = -1;
    factor.sum = std::move(divisor);
    add_factor(front, std::move(factor));
    front.number = front.number * take_number(dividend);
    if (dividend.terms.size() == 1) {
      elgen::multiply(front, dividend.terms.front());
    } else {
      multiply(front, std::move(dividend));
    }
    result.terms.push_back(std::move(front));
    return result;
  }
  for (BookFactor factor : divisor.terms.front().factors) {
    factor.exponent = -factor.exponent;
    add_factor(front, std::move(factor));
  }
  for (BookProduct& term : dividend.terms) {
    elgen::multiply(term, front);
    result.terms.push_back(std::move(term));
  }
  return result;
}

}  // namespace elgen
