// book_sum: see book_sum.hpp. Orders the factors of a product, and merges equal bases.
#include "forms/typeset/book_sum.hpp"

#include <cln/integer.h>

#include <algorithm>
#include <optional>

#include "forms/present/polynomial.hpp"

namespace elgen {
namespace {

/// The rank of calls and roots, which follow sines and cosines. cosh has the next rank, so that it
/// follows sinh.
constexpr std::uint32_t rank_of_functions = 1'000'000;

FactorGroup group_of(const Atom& atom) {
  if (atom.kind == AtomKind::pi) return FactorGroup::parameter;
  if (atom.kind != AtomKind::leaf) return FactorGroup::function;
  return leaf_row(atom.leaf).group;
}

bool has_same_base(const TextbookFactor& x, const TextbookFactor& y);

bool are_equal_sums(const TextbookSum& x, const TextbookSum& y) {
  const auto same_power = [](const TextbookFactor& a, const TextbookFactor& b) {
    return a.exponent == b.exponent && has_same_base(a, b);
  };
  return std::ranges::equal(
      x.terms, y.terms, [&](const TextbookProduct& a, const TextbookProduct& b) {
        return a.number == b.number && std::ranges::equal(a.factors, b.factors, same_power);
      });
}

/// True if the bases are equal; exponents are ignored.
bool has_same_base(const TextbookFactor& x, const TextbookFactor& y) {
  return x.kind == y.kind && x.atom == y.atom && x.angle == y.angle &&
         x.definition == y.definition && are_equal_sums(x.sum, y.sum);
}

/// The order of terms: by the group of the last factor (l1^2 + l2^2 + 2 l1 l2 cos x), then by the
/// number of factors, then by their places.
struct TermKey {
  std::optional<FactorGroup> last = {};
  std::size_t count = 0;
  std::vector<std::pair<FactorPlace, std::int32_t>> factors = {};
  friend auto operator<=>(const TermKey&, const TermKey&) = default;
};

TermKey key_of(const TextbookProduct& product) {
  TermKey key;
  if (!product.factors.empty()) key.last = product.factors.back().place.group;
  key.count = product.factors.size();
  for (const TextbookFactor& factor : product.factors) {
    key.factors.emplace_back(factor.place, -factor.exponent);
  }
  return key;
}

/// The first coordinate in a sum, counted from 1; 0 without coordinates.
std::uint32_t first_coordinate_number(const Algebra& algebra, const Polynomial& sum) {
  std::uint32_t first = 0;
  for (const AtomId id : atoms_of(sum)) {
    const Atom& atom = algebra.atoms[id];
    const bool is_coordinate = atom.kind == AtomKind::leaf && atom.leaf == Opcode::coordinate;
    if (is_coordinate && (first == 0 || atom.index + 1 < first)) first = atom.index + 1;
  }
  return first;
}

std::uint32_t rank_of_angle(const Algebra& algebra, const Monomial& angle) {
  std::uint32_t rank = 0;
  for (const AtomPower& part : angle) {
    const Polynomial& argument = algebra.atoms[part.atom].arguments[0].numerator;
    const std::uint32_t first = first_coordinate_number(algebra, argument);
    if (first > 0 && (rank == 0 || first < rank)) rank = first;
  }
  return rank;
}

}  // namespace

FactorPlace place_of(const Atom& atom, const std::vector<std::uint32_t>& places) {
  const FactorGroup group = group_of(atom);
  if (atom.kind == AtomKind::leaf && atom.leaf == Opcode::parameter) {
    return {group, 1 + places[atom.index]};
  }
  if (group == FactorGroup::coordinate && atom.leaf != Opcode::coordinate) return {group, 10'000};
  if (atom.kind == AtomKind::leaf) return {group, atom.index};
  if (is_number(atom)) return {FactorGroup::parameter, 0};
  return {group, rank_of_functions + (atom.function == FunctionId::cosh ? 1U : 0U)};
}

bool is_number(const Atom& atom) {
  return atom.kind != AtomKind::leaf &&
         std::ranges::all_of(atom.arguments, [](const Fraction& argument) {
           return argument.denominator.empty() && rational_value(argument.numerator);
         });
}

bool is_moving(const Atom& atom) {
  const FactorGroup group = group_of(atom);
  return group == FactorGroup::rate || group == FactorGroup::acceleration ||
         group == FactorGroup::input || group == FactorGroup::multiplier;
}

bool contains_rate(const Algebra& algebra, const Monomial& term) {
  return std::ranges::any_of(
      term, [&](const AtomPower& power) { return is_moving(algebra.atoms[power.atom]); });
}

bool contains_only_parameters(const Algebra& algebra, const Polynomial& sum) {
  return std::ranges::all_of(sum, [&](const auto& term) {
    return std::ranges::all_of(term.first, [&](const AtomPower& power) {
      return group_of(algebra.atoms[power.atom]) == FactorGroup::parameter;
    });
  });
}

std::size_t count_written_factors(const TextbookSum& sum, bool opens_names) {
  std::size_t count = 0;
  for (const TextbookProduct& product : sum.terms) {
    count += product.number == 1 || product.number == -1 ? 0 : 1;
    for (const TextbookFactor& factor : product.factors) {
      const bool is_opened = factor.kind == TextbookFactorKind::sum ||
                             (opens_names && factor.kind == TextbookFactorKind::name);
      count += is_opened ? count_written_factors(factor.sum, opens_names) : 1;
    }
  }
  return count;
}

void add_factor(TextbookProduct& product, TextbookFactor factor) {
  const auto at = std::ranges::find_if(
      product.factors, [&](const TextbookFactor& known) { return has_same_base(known, factor); });
  if (at != product.factors.end()) {
    at->exponent += factor.exponent;
    if (at->exponent == 0) product.factors.erase(at);
    return;
  }
  const auto place =
      std::ranges::upper_bound(product.factors, factor.place, {}, &TextbookFactor::place);
  product.factors.insert(place, std::move(factor));
}

void multiply(TextbookProduct& product, const TextbookProduct& by) {
  product.number = product.number * by.number;
  for (const TextbookFactor& factor : by.factors) add_factor(product, factor);
}

void divide(TextbookProduct& product, const TextbookProduct& by, std::int32_t exponent) {
  product.number = product.number / cln::expt(by.number, exponent);
  for (TextbookFactor factor : by.factors) {
    factor.exponent *= -exponent;
    add_factor(product, std::move(factor));
  }
}

void multiply(TextbookProduct& product, const Algebra& algebra, const CircularPower& power) {
  const std::uint32_t rank = 2 * rank_of_angle(algebra, power.angle);
  const auto add = [&](TextbookFactorKind kind, std::int32_t exponent, std::uint32_t place) {
    if (exponent == 0) return;
    TextbookFactor factor;
    factor.place = {FactorGroup::function, place};
    factor.kind = kind;
    factor.exponent = exponent;
    factor.angle = power.angle;
    add_factor(product, std::move(factor));
  };
  add(TextbookFactorKind::sine, power.sine, rank);
  add(TextbookFactorKind::cosine, power.cosine, rank + 1);
}

void append_terms(TextbookSum& to, TextbookSum from) {
  for (TextbookProduct& term : from.terms) to.terms.push_back(std::move(term));
}

cln::cl_RA extract_numeric_content(TextbookSum& sum) {
  cln::cl_I above = 0;
  cln::cl_I below = 1;
  for (const TextbookProduct& term : sum.terms) {
    above = cln::gcd(above, cln::numerator(term.number));
    below = cln::lcm(below, cln::denominator(term.number));
  }
  const bool is_negative = cln::minusp(sum.terms.front().number);
  const cln::cl_RA number = (is_negative ? -cln::cl_RA(above) : cln::cl_RA(above)) / below;
  for (TextbookProduct& term : sum.terms) term.number = term.number / number;
  return number;
}

std::vector<TextbookFactor> take_sinusoids(TextbookSum& sum) {
  std::vector<TextbookFactor> common;
  for (TextbookFactor circular : sum.terms.front().factors) {
    const bool is_sine_or_cosine =
        circular.kind == TextbookFactorKind::sine || circular.kind == TextbookFactorKind::cosine;
    for (const TextbookProduct& term : sum.terms) {
      const auto own = std::ranges::find_if(term.factors, [&](const TextbookFactor& factor) {
        return has_same_base(factor, circular);
      });
      circular.exponent =
          own == term.factors.end() ? 0 : std::min(circular.exponent, own->exponent);
    }
    if (is_sine_or_cosine && circular.exponent > 0) common.push_back(std::move(circular));
  }
  for (const TextbookFactor& circular : common) {
    for (TextbookProduct& term : sum.terms) {
      TextbookFactor inverse = circular;
      inverse.exponent = -circular.exponent;
      add_factor(term, std::move(inverse));
    }
  }
  return common;
}

TextbookSum move_positive_first(TextbookSum sum) {
  const auto first = std::ranges::find_if(
      sum.terms, [](const TextbookProduct& term) { return cln::plusp(term.number); });
  if (first != sum.terms.end()) std::rotate(sum.terms.begin(), first, first + 1);
  return sum;
}

void sort_terms(TextbookSum& sum) {
  std::ranges::stable_sort(sum.terms, {}, key_of);
  std::stable_partition(sum.terms.begin(), sum.terms.end(),
                        [](const TextbookProduct& term) { return cln::plusp(term.number); });
}

}  // namespace elgen
