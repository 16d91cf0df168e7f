// factors: see factors.hpp.
#include "typeset/factors.hpp"

#include <cln/integer.h>

#include <algorithm>

#include "present/polynomial.hpp"

namespace elgen {
namespace {

/// Calls and roots stand behind sines and cosines; sinh in front of cosh.
constexpr std::uint32_t rank_of_functions = 1'000'000;

FactorGroup group_of(const Atom& atom) {
  if (atom.kind == AtomKind::pi) return FactorGroup::parameter;
  if (atom.kind != AtomKind::leaf) return FactorGroup::function;
  switch (atom.leaf) {
    case Opcode::parameter:
      return FactorGroup::parameter;
    case Opcode::velocity:
    case Opcode::momentum:
      return FactorGroup::rate;
    case Opcode::acceleration:
      return FactorGroup::acceleration;
    case Opcode::input:
      return FactorGroup::input;
    case Opcode::open_value:
      return FactorGroup::function;
    default:
      return FactorGroup::coordinate;
  }
}

bool is_same(const BookFactor& x, const BookFactor& y) {
  return x.place == y.place && x.kind == y.kind && x.atom == y.atom && x.angle == y.angle &&
         x.definition == y.definition && x.kind != BookFactorKind::sum;
}

/// What orders the terms of a sum: the places of their factors, one after the other.
std::vector<std::pair<FactorPlace, std::int32_t>> key_of(const BookProduct& product) {
  std::vector<std::pair<FactorPlace, std::int32_t>> key;
  for (const BookFactor& factor : product.factors) key.emplace_back(factor.place, -factor.exponent);
  return key;
}

/// The first coordinate in an angle, counted from 1; 0 where there is none.
std::uint32_t rank_of_angle(const Algebra& algebra, const Monomial& angle) {
  std::uint32_t rank = UINT32_MAX / 4;
  for (const AtomPower& part : angle) {
    for (const Fraction& argument : algebra.atoms[part.atom].arguments) {
      for (const auto& [monomial, coefficient] : argument.numerator) {
        for (const AtomPower& power : monomial) {
          const Atom& atom = algebra.atoms[power.atom];
          if (group_of(atom) == FactorGroup::coordinate && atom.leaf == Opcode::coordinate) {
            rank = std::min(rank, 1 + atom.index);
          }
        }
      }
    }
  }
  return rank == UINT32_MAX / 4 ? 0 : rank;
}

}  // namespace

FactorPlace place_of(const Atom& atom, const std::vector<std::uint32_t>& places) {
  const FactorGroup group = group_of(atom);
  if (atom.kind == AtomKind::leaf && atom.leaf == Opcode::parameter) {
    return {group, 1 + places[atom.index]};
  }
  if (group == FactorGroup::coordinate && atom.leaf != Opcode::coordinate) return {group, 10'000};
  if (atom.kind == AtomKind::leaf) return {group, atom.index};
  return {group, rank_of_functions + (atom.function == FunctionId::cosh ? 1U : 0U)};
}

bool is_moving(const Atom& atom) {
  const FactorGroup group = group_of(atom);
  return group == FactorGroup::rate || group == FactorGroup::acceleration ||
         group == FactorGroup::input;
}

bool is_of_parameters(const Algebra& algebra, const Polynomial& sum) {
  return std::ranges::all_of(sum, [&](const auto& term) {
    return std::ranges::all_of(term.first, [&](const AtomPower& power) {
      return group_of(algebra.atoms[power.atom]) == FactorGroup::parameter;
    });
  });
}

std::size_t written_factors(const BookSum& sum) {
  std::size_t count = 0;
  for (const BookProduct& product : sum.terms) {
    count += product.number == 1 || product.number == -1 ? 0 : 1;
    if (product.factors.empty()) ++count;
    for (const BookFactor& factor : product.factors) {
      count += factor.kind == BookFactorKind::sum ? written_factors(factor.sum) : 1;
    }
  }
  return count;
}

void add_factor(BookProduct& product, BookFactor factor) {
  const auto at = std::ranges::find_if(
      product.factors, [&](const BookFactor& known) { return is_same(known, factor); });
  if (at != product.factors.end()) {
    at->exponent += factor.exponent;
    if (at->exponent == 0) product.factors.erase(at);
    return;
  }
  const auto place =
      std::ranges::upper_bound(product.factors, factor.place, {}, &BookFactor::place);
  product.factors.insert(place, std::move(factor));
}

void multiply(BookProduct& product, const BookProduct& by) {
  product.number = product.number * by.number;
  for (const BookFactor& factor : by.factors) add_factor(product, factor);
}

void multiply(BookProduct& product, const Algebra& algebra, const CircularPower& power) {
  const std::uint32_t rank = 2 * rank_of_angle(algebra, power.angle);
  const auto add = [&](BookFactorKind kind, std::int32_t exponent, std::uint32_t place) {
    if (exponent == 0) return;
    BookFactor factor;
    factor.place = {FactorGroup::function, place};
    factor.kind = kind;
    factor.exponent = exponent;
    factor.angle = power.angle;
    add_factor(product, std::move(factor));
  };
  add(BookFactorKind::sine, power.sine, rank);
  add(BookFactorKind::cosine, power.cosine, rank + 1);
}

cln::cl_RA take_number(BookSum& sum) {
  cln::cl_I above = 0;
  cln::cl_I below = 1;
  for (const BookProduct& term : sum.terms) {
    above = cln::gcd(above, cln::numerator(term.number));
    below = cln::lcm(below, cln::denominator(term.number));
  }
  const bool is_negative = cln::minusp(sum.terms.front().number);
  const cln::cl_RA number = (is_negative ? -cln::cl_RA(above) : cln::cl_RA(above)) / below;
  for (BookProduct& term : sum.terms) term.number = term.number / number;
  return number;
}

void sort_terms(BookSum& sum) {
  std::ranges::stable_sort(sum.terms, {}, key_of);
  const auto positive = std::ranges::find_if(
      sum.terms, [](const BookProduct& term) { return cln::plusp(term.number); });
  if (positive != sum.terms.end()) {
    std::rotate(sum.terms.begin(), positive, positive + 1);
  }
}

}  // namespace elgen
