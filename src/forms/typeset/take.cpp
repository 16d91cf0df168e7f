// take: extracts factors from a sum: common powers, typed sums, squares.
#include <algorithm>
#include <stdexcept>
#include <utility>

#include "forms/present/polynomial.hpp"
#include "forms/typeset/arrange.hpp"
#include "forms/write/rewritings.hpp"

namespace elgen {

using cln::cl_RA;

namespace {

/// A sum of more factors than this is written as a name if a definition has the same value.
constexpr std::size_t longest_unnamed_sum = 12;

bool is_root_of(const Algebra& algebra, const TextbookFactor& factor, const Polynomial& radicand) {
  if (factor.kind != TextbookFactorKind::atom || factor.exponent < 1) return false;
  const Atom& atom = algebra.atoms[factor.atom];
  return atom.kind == AtomKind::root && atom.arguments[0] == Fraction{radicand, {}};
}

}  // namespace

TextbookFactor Arranger::atom_factor(const AtomPower& power) const {
  TextbookFactor factor;
  factor.place = place_of(algebra_.atoms[power.atom], typed_.parameter_places);
  factor.atom = power.atom;
  factor.exponent = power.exponent;
  return factor;
}

void Arranger::multiply(TextbookProduct& product, const Monomial& powers) const {
  for (const AtomPower& power : powers) add_factor(product, atom_factor(power));
}

/// The place of a sum. A sum of parameters has the place of its first parameter, as in
/// (m1 + m2) g l, unless this parameter is g, as in m R (g - R Omega^2).
FactorPlace Arranger::place_of_sum(const TextbookSum& sum, std::uint32_t rank) const {
  TextbookFactor first;
  first.kind = TextbookFactorKind::sum;  // remains if no term has a parameter
  first.place = {FactorGroup::parameter, UINT32_MAX};
  for (const TextbookProduct& term : sum.terms) {
    for (const TextbookFactor& each : term.factors) {
      if (each.place.group != FactorGroup::parameter) return {FactorGroup::sum, rank};
      if (each.place < first.place) first = each;
    }
  }
  if (first.kind != TextbookFactorKind::atom) return first.place;
  const Atom& atom = algebra_.atoms[first.atom];
  const bool is_acceleration = atom.kind == AtomKind::leaf && typed_.are_accelerations[atom.index];
  return is_acceleration ? FactorPlace{FactorGroup::sum, rank} : first.place;
}

void Arranger::multiply(TextbookProduct& product, TextbookSum sum, std::int32_t exponent) const {
  for (TextbookFactor& circular : take_sinusoids(sum)) {
    circular.exponent *= exponent;
    add_factor(product, std::move(circular));
  }
  sort_terms(sum);
  product.number = product.number * cln::expt(extract_numeric_content(sum), exponent);
  TextbookFactor factor;
  factor.kind = TextbookFactorKind::sum;
  factor.place = place_of_sum(sum, untyped_rank);
  factor.exponent = exponent;
  factor.sum = std::move(sum);
  add_factor(product, std::move(factor));
}

/// Multiplies `product` by `sum`. A sum of a single term gets no brackets.
void Arranger::multiply_by_sum(TextbookProduct& product, TextbookSum sum) const {
  if (sum.terms.size() == 1) return elgen::multiply(product, sum.terms.front());
  multiply(product, std::move(sum), 1);
}

/// Moves to `front` each power whose exponent has the same sign in all terms, except exponentials.
void Arranger::take_monomial(Polynomial& sum, TextbookProduct& front) const {
  Monomial common;
  for (const ExponentRange& range : exponent_ranges(sum)) {
    const std::int32_t exponent = range.least > 0 ? range.least : std::min(range.greatest, 0);
    const bool is_circular = algebra_.atoms[range.atom].kind == AtomKind::circular;
    if (exponent != 0 && !is_circular) common.push_back({range.atom, exponent});
  }
  if (common.empty()) return;
  sum = multiply_by_term(sum, {1, 0}, power(common, -1));
  multiply(front, common);
}

TextbookFactor Arranger::typed_factor(std::size_t typed) {
  const auto known = typed_factors_->find(typed);
  if (known != typed_factors_->end()) return known->second;
  const TypedSum& sum = typed_.sums[typed];
  TextbookFactor factor;
  factor.kind = TextbookFactorKind::sum;
  // The terms contain only shorter sums, so the recursion ends.
  Arranger inner(algebra_, typed_);
  inner.first_typed_ = typed + 1;
  inner.typed_factors_ = typed_factors_;
  for (const Fraction& term : sum.terms) append_terms(factor.sum, inner.factor_out(term));
  // A factor this long is not typeset; the page shows the code's form.
  const bool is_too_long = count_written_factors(factor.sum, true) > longest_textbook_entry;
  if (is_too_long) throw std::length_error("a typed sum");
  factor.place = place_of_sum(factor.sum, static_cast<std::uint32_t>(typed));
  const bool of_parameters = contains_only_parameters(algebra_, sum.value);
  if (sum.definition &&
      (of_parameters || count_written_factors(factor.sum) > longest_unnamed_sum)) {
    factor.kind = TextbookFactorKind::name;
    factor.definition = *sum.definition;
  }
  return typed_factors_->emplace(typed, std::move(factor)).first->second;
}

bool Arranger::take_typed_sums(Polynomial& sum, TextbookProduct& front) {
  bool has_split = false;
  const std::vector<AtomId> atoms = atoms_of(sum);
  for (std::size_t i = first_typed_; i < typed_.sums.size() && sum.size() > 1; ++i) {
    if (!std::ranges::includes(atoms, typed_.sums[i].atoms)) continue;
    std::int32_t exponent = 0;
    const auto divide_by = [&](const Polynomial& divisor, std::int32_t power) {
      while (sum.size() > 1) {
        auto divided = elgen::quotient(sum, divisor, work_);
        if (!divided) break;
        sum = std::move(*divided);
        exponent += power;
      }
    };
    divide_by(typed_.sums[i].value, 1);
    if (!typed_.sums[i].square.empty()) divide_by(typed_.sums[i].square, 2);
    if (exponent == 0) continue;
    has_split = true;
    TextbookFactor factor = typed_factor(i);
    factor.exponent = exponent;
    add_factor(front, std::move(factor));
  }
  return has_split;
}

Arranger::SplitSum Arranger::split_sum(Polynomial sum) {
  SplitSum result;
  result.rest = reduce_hyperbolic_squares(algebra_, std::move(sum));
  take_monomial(result.rest, result.front);
  if (take_typed_sums(result.rest, result.front)) take_monomial(result.rest, result.front);
  take_square(result);
  while (take_coefficient(result)) continue;
  return result;
}

/// If rest = c (a + b)^2 with real a and b, extracts the square. For a square of sines, division
/// gives an imaginary root; this root is then multiplied by i, and c changes its sign.
void Arranger::take_square(SplitSum& split) {
  if (split.rest.size() < 3 || split.rest.size() > most_collected_terms) return;
  const GaussianRational lead = split.rest.rbegin()->second;
  if (!cln::zerop(lead.imaginary)) return;
  std::optional<Polynomial> root =
      square_root(multiply_by_term(split.rest, {cl_RA(1) / lead.real, 0}));
  if (!root) return;
  cl_RA number = lead.real;
  if (!is_real(algebra_, *root)) {
    root = multiply_by_term(*root, {0, 1});
    number = -number;
    if (!is_real(algebra_, *root)) return;
  }
  const Monomial below = common_divisor_powers(algebra_, *root);
  TextbookSum base = arrange_terms(multiply_by_term(*root, {1, 0}, power(below, -1)));
  if (base.terms.size() < 2) return;
  multiply(split.front, power(below, 2));
  multiply(split.front, std::move(base), 2);
  split.rest = constant_polynomial(number);
}

/// Extracts (a + b) from (a + b) (c + d): the coefficient of the highest power of a parameter, if
/// the coefficient divides the sum. Imaginary coefficients, as from sines of numbers, are skipped.
bool Arranger::take_coefficient(SplitSum& split) {
  if (split.rest.size() < 4 || split.rest.size() > most_collected_terms) return false;
  for (const AtomId id : atoms_of(split.rest)) {
    if (atom_factor({id, 1}).place.group != FactorGroup::parameter) continue;
    const Polynomial coefficient = coefficients_of(split.rest, id).rbegin()->second;
    if (coefficient.size() < 2 || !contains_only_parameters(algebra_, coefficient)) continue;
    if (!is_real(algebra_, coefficient)) continue;
    auto divided = elgen::quotient(split.rest, coefficient, work_);
    if (!divided || divided->size() < 2) continue;
    TextbookSum factor = arrange_terms(coefficient);
    if (factor.terms.size() < 2) continue;
    multiply(split.front, std::move(factor), 1);
    split.rest = std::move(*divided);
    return true;
  }
  return false;
}

/// front * rest, with the divisors of the terms of `rest` as divisors of the product.
TextbookProduct Arranger::book_product(const SplitSum& split) {
  TextbookProduct result = split.front;
  if (is_one(split.rest)) return result;
  const Monomial below = common_divisor_powers(algebra_, split.rest);
  multiply(result, below);
  TextbookSum rest = arrange_terms(multiply_by_term(split.rest, {1, 0}, power(below, -1)));
  if (rest.terms.empty()) return {0, {}};
  multiply_by_sum(result, std::move(rest));
  return result;
}

TextbookProduct Arranger::book_product(const Polynomial& sum) {
  return book_product(split_sum(sum));
}

void Arranger::divide(TextbookProduct& product, const Polynomial& factor, std::int32_t exponent) {
  if (exponent == 0) return;
  elgen::divide(product, this->book_product(factor), exponent);
}

/// Divides `product` by the denominator of `form`. Denominator factors with sines and cosines are
/// multiplied first, because present() writes sin x as 2 sin(x/2) cos(x/2).
void Arranger::divide(TextbookProduct& product, const Fraction& form) {
  Polynomial circular_factors = constant_polynomial(1);
  for (const auto& [factor, exponent] : form.denominator) {
    const Polynomial& shown = algebra_.factors[factor].shown;
    const auto root = std::ranges::find_if(product.factors, [&](const TextbookFactor& each) {
      return is_root_of(algebra_, each, shown);
    });
    if (root != product.factors.end()) {  // sqrt(r)/r^k = 1/(sqrt(r) r^(k - 1))
      TextbookFactor twice = *root;
      twice.exponent = -2;
      add_factor(product, std::move(twice));
      divide(product, shown, exponent - 1);
    } else if (!contains_exponentials(algebra_, shown)) {
      divide(product, shown, exponent);
    } else {
      for (std::int32_t i = 0; i < exponent; ++i) {
        circular_factors = elgen::product(circular_factors, shown);
      }
    }
    if (circular_factors.size() > most_terms) throw TextbookLengthError();
  }
  if (!is_one(circular_factors)) divide(product, circular_factors, 1);
}

TextbookProduct Arranger::book_product(const Fraction& form) {
  TextbookProduct result = book_product(form.numerator);
  divide(result, form);
  return result;
}

}  // namespace elgen
