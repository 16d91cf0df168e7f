// Sparse sums, ordered by a group order, so that division and equality need no further thought.
#include "forms/present/polynomial.hpp"

#include <algorithm>
#include <utility>

namespace elgen {

bool MonomialLess::operator()(const Monomial& x, const Monomial& y) const {
  auto i = x.begin();
  auto j = y.begin();
  for (; i != x.end() && j != y.end(); ++i, ++j) {
    if (i->atom != j->atom) return i->atom < j->atom ? i->exponent < 0 : j->exponent > 0;
    if (i->exponent != j->exponent) return i->exponent < j->exponent;
  }
  if (i != x.end()) return i->exponent < 0;
  return j != y.end() && j->exponent > 0;
}

using cln::cl_RA;

Monomial product(const Monomial& x, const Monomial& y) {
  Monomial result;
  result.reserve(x.size() + y.size());
  auto i = x.begin();
  auto j = y.begin();
  while (i != x.end() && j != y.end()) {
    if (i->atom < j->atom) {
      result.push_back(*i++);
    } else if (j->atom < i->atom) {
      result.push_back(*j++);
    } else {
      const std::int32_t exponent = i->exponent + j->exponent;
      if (exponent != 0) result.push_back({i->atom, exponent});
      ++i;
      ++j;
    }
  }
  result.insert(result.end(), i, x.end());
  result.insert(result.end(), j, y.end());
  return result;
}

Monomial power(const Monomial& x, std::int32_t exponent) {
  if (exponent == 0) return {};
  Monomial result = x;
  for (AtomPower& factor : result) factor.exponent *= exponent;
  return result;
}

Gaussian product(const Gaussian& x, const Gaussian& y) {
  const bool real = cln::zerop(x.imaginary) && cln::zerop(y.imaginary);
  if (real) return {x.real * y.real, 0};
  return {x.real * y.real - x.imaginary * y.imaginary, x.real * y.imaginary + x.imaginary * y.real};
}

Gaussian reciprocal(const Gaussian& x) {
  const cl_RA square = x.real * x.real + x.imaginary * x.imaginary;
  return {x.real / square, -x.imaginary / square};
}

bool is_zero(const Gaussian& x) { return cln::zerop(x.real) && cln::zerop(x.imaginary); }

Polynomial constant(const cl_RA& value) {
  if (cln::zerop(value)) return {};
  return {{Monomial{}, Gaussian{value, 0}}};
}

Polynomial sum(Polynomial x, const Polynomial& y) {
  for (const auto& [monomial, coefficient] : y) add_term(x, monomial, coefficient);
  return x;
}

Polynomial scaled(const Polynomial& x, const Gaussian& coefficient, const Monomial& monomial) {
  Polynomial result;
  for (const auto& [own, value] : x) {
    result.emplace_hint(result.end(), product(own, monomial), product(value, coefficient));
  }
  return result;
}

Polynomial product(const Polynomial& x, const Polynomial& y) {
  Polynomial result;
  for (const auto& [left, a] : x) {
    for (const auto& [right, b] : y) add_term(result, product(left, right), product(a, b));
  }
  return result;
}

namespace {

/// Least and greatest exponent of each atom in a polynomial.
using Box = std::map<AtomId, std::pair<std::int32_t, std::int32_t>>;

Box box_of(const Polynomial& x) {
  Box box;
  std::map<AtomId, std::size_t> occurrences;
  for (const auto& [monomial, coefficient] : x) {
    for (const AtomPower& factor : monomial) {
      const auto [at, is_new] = box.try_emplace(factor.atom, factor.exponent, factor.exponent);
      at->second.first = std::min(at->second.first, factor.exponent);
      at->second.second = std::max(at->second.second, factor.exponent);
      ++occurrences[factor.atom];
    }
  }
  // Where an atom is absent its exponent is 0.
  for (auto& [atom, range] : box) {
    if (occurrences[atom] == x.size()) continue;
    range.first = std::min(range.first, 0);
    range.second = std::max(range.second, 0);
  }
  return box;
}

/// The exponents that x / y can have; none where there are no such.
std::optional<Box> quotient_box(const Polynomial& x, const Polynomial& y) {
  Box box = box_of(x);
  for (const auto& [atom, range] : box_of(y)) {
    auto& own = box[atom];
    own = {own.first - range.first, own.second - range.second};
  }
  for (const auto& [atom, range] : box) {
    if (range.first > range.second) return std::nullopt;
  }
  return box;
}

bool is_inside(const Monomial& monomial, const Box& box) {
  std::size_t seen = 0;
  for (const AtomPower& factor : monomial) {
    const auto at = box.find(factor.atom);
    if (at == box.end()) return false;
    if (factor.exponent < at->second.first || factor.exponent > at->second.second) return false;
    ++seen;
  }
  if (seen == box.size()) return true;
  return std::all_of(box.begin(), box.end(), [&](const auto& side) {
    const bool present = std::any_of(monomial.begin(), monomial.end(), [&](const AtomPower& power) {
      return power.atom == side.first;
    });
    return present || (side.second.first <= 0 && side.second.second >= 0);
  });
}

}  // namespace

std::optional<Polynomial> quotient(const Polynomial& x, const Polynomial& y, std::size_t& work) {
  const std::optional<Box> box = quotient_box(x, y);
  if (!box) return std::nullopt;
  const Monomial inverse_lead = power(y.rbegin()->first, -1);
  const Gaussian inverse_coefficient = reciprocal(y.rbegin()->second);
  const Monomial last = product(x.begin()->first, power(y.begin()->first, -1));
  if (!is_inside(last, *box)) return std::nullopt;
  Polynomial rest = x;
  Polynomial result;
  while (!rest.empty()) {
    const Monomial monomial = product(rest.rbegin()->first, inverse_lead);
    if (!is_inside(monomial, *box) || work < y.size()) return std::nullopt;
    work -= y.size();
    const Gaussian coefficient = product(rest.rbegin()->second, inverse_coefficient);
    for (const auto& [own, value] : y) {
      const Gaussian term = product(value, coefficient);
      add_term(rest, product(own, monomial), {-term.real, -term.imaginary});
    }
    add_term(result, monomial, coefficient);
  }
  return result;
}

void divide_out(Fraction& x, const Algebra& algebra, std::size_t& work) {
  for (auto& [factor, exponent] : x.denominator) {
    while (exponent > 0 && x.numerator.size() > 1) {
      auto divided = quotient(x.numerator, algebra.factors[factor].shown, work);
      if (!divided) break;
      x.numerator = std::move(*divided);
      --exponent;
    }
  }
  std::erase_if(x.denominator, [](const auto& factor) { return factor.second == 0; });
}

std::optional<cl_RA> rational_value(const Polynomial& x) {
  if (x.empty()) return cl_RA(0);
  if (x.size() > 1 || !x.begin()->first.empty()) return std::nullopt;
  if (!cln::zerop(x.begin()->second.imaginary)) return std::nullopt;
  return x.begin()->second.real;
}
}  // namespace elgen
