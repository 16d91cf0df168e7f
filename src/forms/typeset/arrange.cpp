// arrange: see arrange.hpp. Builds sums and fractions with take.cpp and collect.cpp.
#include "forms/typeset/arrange.hpp"

#include <algorithm>
#include <utility>

#include "forms/present/polynomial.hpp"
#include "forms/write/closed_graph.hpp"

namespace elgen {
namespace {

/// The rank of a product of rates in textbook order: the row's own acceleration, other
/// accelerations, squares, other products, single rates, inputs, multipliers, no rates.
int rank_of_rates(const Algebra& algebra, const Monomial& rates, std::optional<std::uint32_t> own) {
  std::int32_t degree = 0;
  bool is_input = false;
  bool is_multiplier = false;
  for (const AtomPower& power : rates) {
    const Atom& atom = algebra.atoms[power.atom];
    if (atom.leaf == Opcode::acceleration) return own && atom.index == *own ? 0 : 1;
    is_input = is_input || atom.leaf == Opcode::input;
    is_multiplier = is_multiplier || atom.leaf == Opcode::multiplier;
    degree += power.exponent;
  }
  if (rates.empty()) return 7;
  if (is_multiplier) return 6;
  if (is_input) return 5;
  if (degree < 2) return 4;
  return rates.size() == 1 ? 2 : 3;
}

/// Pairs of the index and the negated exponent of each leaf, sorted. Ids of atoms are no sort key,
/// because ids depend on the order of creation.
std::vector<std::pair<std::uint32_t, std::int32_t>> rate_sort_key(const Algebra& algebra,
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
  std::vector<RateGroup> groups;
  for (auto& [rates, rest] : group_terms_by_atoms(algebra, sum, is_moving))
    groups.push_back({rates, std::move(rest)});
  std::ranges::stable_sort(groups, {}, [&](const RateGroup& group) {
    return std::pair(rank_of_rates(algebra, group.rates, own), rate_sort_key(algebra, group.rates));
  });
  return groups;
}

bool has_only_divisors(const TextbookProduct& product) {
  return std::ranges::all_of(product.factors,
                             [](const TextbookFactor& factor) { return factor.exponent < 0; });
}

/// True if a term of the bracketed sum starts with a factor that belongs before the first factor of
/// the product. Textbooks do not write -g ((m1 + m2) a + m2 b).
bool hides_leading_factors(const TextbookProduct& product) {
  const FactorPlace first = product.factors.front().place;
  const auto sum =
      std::ranges::find(product.factors, TextbookFactorKind::sum, &TextbookFactor::kind);
  if (sum == product.factors.end() || sum->exponent != 1) return false;
  return std::ranges::any_of(sum->sum.terms, [&](const TextbookProduct& term) {
    return !term.factors.empty() && term.factors.front().place < first;
  });
}

}  // namespace

TextbookSum Arranger::arrange_rateless_terms(const Polynomial& sum) {
  TextbookSum typed = product_with_typed_sum({sum, {}});
  return typed.terms.empty() ? collected_sum(real_term_sum(sum)) : typed;
}

TextbookSum Arranger::arrange_terms(const Polynomial& sum, std::optional<std::uint32_t> own) {
  TextbookSum result;
  for (const auto& [rates, rest] : rate_groups(algebra_, sum, own)) {
    if (rates.empty()) {
      append_terms(result, arrange_rateless_terms(rest));
      continue;
    }
    result.terms.push_back(book_product(rest));
    multiply(result.terms.back(), rates);
  }
  return result;
}

/// One term for each product of rates in the numerator, each over its own reduced denominator.
TextbookSum Arranger::arrange_fraction_parts(const Fraction& form,
                                             std::optional<std::uint32_t> own) {
  TextbookSum result;
  for (auto& [rates, rest] : rate_groups(algebra_, form.numerator, own)) {
    Fraction part{std::move(rest), form.denominator};
    cancel_common_factors(part, algebra_, work_);
    result.terms.push_back(book_product(part));
    multiply(result.terms.back(), rates);
  }
  return result;
}

TextbookSum Arranger::split_by_motion(const Fraction& form) {
  Fraction moving{{}, form.denominator};
  Fraction resting{{}, form.denominator};
  for (const auto& [monomial, coefficient] : form.numerator) {
    (contains_rate(algebra_, monomial) ? moving : resting)
        .numerator.try_emplace(monomial, coefficient);
  }
  if (moving.numerator.empty() || resting.numerator.empty()) return factor_out(form);
  TextbookSum typed = product_with_typed_sum(form);
  if (!typed.terms.empty()) return typed;
  cancel_common_factors(moving, algebra_, work_);
  cancel_common_factors(resting, algebra_, work_);
  TextbookSum result = factor_out(moving);
  append_terms(result, factor_out(resting));
  return result;
}

/// One product if a typed sum divides the form; otherwise empty.
TextbookSum Arranger::product_with_typed_sum(const Fraction& form) {
  SplitSum whole{{1, {}}, form.numerator};
  if (!form.denominator.empty() || !take_typed_sums(whole.rest, whole.front)) return {};
  take_monomial(whole.rest, whole.front);
  return {{book_product(whole)}};
}

TextbookSum Arranger::factor_out_each(const std::vector<Fraction>& summands) {
  TextbookSum result;
  for (const Fraction& form : summands) append_terms(result, factor_out(form));
  return result;
}

TextbookSum Arranger::factor_out(const Fraction& form) {
  if (form.numerator.empty()) return {};
  SplitSum whole = split_sum(form.numerator);
  if (form.denominator.empty()) {
    if (whole.front.factors.empty()) return move_positive_first(arrange_terms(whole.rest));
    if (has_only_divisors(whole.front)) return arrange_terms(form.numerator);
    TextbookProduct product = this->book_product(whole);
    if (hides_leading_factors(product)) return arrange_terms(form.numerator);
    return {{std::move(product)}};
  }
  const std::vector<Fraction> roots = split_by_roots(algebra_, form);
  if (roots.size() > 1) return factor_out_each(roots);
  TextbookSum sum = arrange_fraction_parts({whole.rest, form.denominator});
  const auto divided = std::ranges::count_if(sum.terms, [](const TextbookProduct& term) {
    return std::ranges::any_of(term.factors,
                               [](const TextbookFactor& factor) { return factor.exponent < 0; });
  });
  const bool is_nested = std::ranges::any_of(whole.rest, [&](const auto& term) {
    return std::ranges::any_of(split_monomial(algebra_, term.first).powers,
                               [](const AtomPower& power) { return power.exponent < 0; });
  });
  if (sum.terms.size() > 1 && (divided < 2 || is_nested)) {
    if (has_only_divisors(whole.front)) {
      for (TextbookProduct& term : sum.terms) elgen::multiply(term, whole.front);
      return sum;
    }
    multiply(whole.front, std::move(sum), 1);
    return {{std::move(whole.front)}};
  }
  TextbookProduct product = this->book_product(whole);
  divide(product, form);
  return {{std::move(product)}};
}

TextbookSum Arranger::arrange_summand(const Fraction& form, std::uint32_t own) {
  TextbookSum typed = product_with_typed_sum(form);
  return typed.terms.empty() ? collect_by_rates(form, own) : typed;
}

TextbookSum Arranger::collect_by_rates(const Fraction& form, std::optional<std::uint32_t> own) {
  const Polynomial numerator = reduce_hyperbolic_squares(algebra_, form.numerator);
  if (form.denominator.empty()) return arrange_terms(numerator, own);
  const std::vector<Fraction> roots = split_by_roots(algebra_, {numerator, form.denominator});
  if (roots.size() == 1) return arrange_fraction_parts(roots.front(), own);
  TextbookSum result;
  for (const Fraction& part : roots) append_terms(result, collect_by_rates(part, own));
  return result;
}

bool Arranger::is_one_product(const Fraction& form) {
  const TextbookSum written = factor_out(form);
  return written.terms.size() == 1 &&
         std::ranges::none_of(written.terms.front().factors, [](const TextbookFactor& factor) {
           return factor.kind == TextbookFactorKind::sum;
         });
}

TextbookSum Arranger::arrange_quotient(const Fraction& above, const Fraction& below) {
  if (above.numerator.empty()) return {};
  if (above.denominator != below.denominator) throw TextbookLengthError();
  SplitSum numerator{{1, {}}, reduce_hyperbolic_squares(algebra_, above.numerator)};
  SplitSum denominator{{1, {}}, reduce_hyperbolic_squares(algebra_, below.numerator)};
  for (SplitSum* const part : {&numerator, &denominator}) {
    take_monomial(part->rest, part->front);
    const Monomial divisors = common_divisor_powers(algebra_, part->rest);
    multiply(part->front, divisors);
    part->rest = multiply_by_term(part->rest, {1, 0}, power(divisors, -1));
  }
  TextbookProduct front = std::move(numerator.front);
  elgen::divide(front, {1, denominator.front.factors});
  TextbookSum divisor = arrange_terms(denominator.rest);
  sort_terms(divisor);
  front.number = front.number / extract_numeric_content(divisor);
  TextbookSum dividend = arrange_terms(numerator.rest);
  if (divisor.terms.size() > 1) {
    TextbookFactor factor;
    factor.kind = TextbookFactorKind::sum;
    factor.place = {FactorGroup::sum, UINT32_MAX};
    factor.exponent = -1;
    factor.sum = std::move(divisor);
    add_factor(front, std::move(factor));
    sort_terms(dividend);
    front.number = front.number * extract_numeric_content(dividend);
    multiply_by_sum(front, std::move(dividend));
    return {{std::move(front)}};
  }
  elgen::divide(front, {1, divisor.terms.front().factors});
  for (TextbookProduct& term : dividend.terms) elgen::multiply(term, front);
  return dividend;
}

}  // namespace elgen
