// Sparse sums of terms, sorted by monomial. Multiplication by a monomial preserves the order, so
// division and equality are simple.
#include "forms/present/polynomial.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace elgen {

using cln::cl_RA;

Monomial product(const Monomial& x, const Monomial& y) {
  Monomial result;
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
  while (i != x.end()) result.push_back(*i++);
  while (j != y.end()) result.push_back(*j++);
  return result;
}

Monomial power(const Monomial& x, std::int32_t exponent) {
  if (exponent == 0) return {};
  Monomial result = x;
  for (AtomPower& factor : result) factor.exponent *= exponent;
  return result;
}

GaussianRational product(const GaussianRational& x, const GaussianRational& y) {
  const bool is_real_product = cln::zerop(x.imaginary) && cln::zerop(y.imaginary);
  if (is_real_product) return {x.real * y.real, 0};
  return {x.real * y.real - x.imaginary * y.imaginary, x.real * y.imaginary + x.imaginary * y.real};
}

GaussianRational reciprocal(const GaussianRational& x) {
  const cl_RA square = x.real * x.real + x.imaginary * x.imaginary;
  return {x.real / square, -x.imaginary / square};
}

bool is_zero(const GaussianRational& x) { return cln::zerop(x.real) && cln::zerop(x.imaginary); }

Polynomial constant_polynomial(const cl_RA& value) {
  if (cln::zerop(value)) return {};
  return {{Monomial{}, GaussianRational{value, 0}}};
}

namespace {

/// The sum of two ascending ranges; terms with equal monomials are added.
template <class Iterator>
Polynomial merge_terms(Iterator i, Iterator i_end, Iterator j, Iterator j_end) {
  Polynomial::Terms terms;
  terms.reserve(static_cast<std::size_t>((i_end - i) + (j_end - j)));
  while (i != i_end && j != j_end) {
    const Polynomial::value_type& x = *i;
    const Polynomial::value_type& y = *j;
    const std::strong_ordering order = compare_exponents(x.first, y.first);
    if (order != 0) {
      terms.push_back(order < 0 ? *i++ : *j++);
      continue;
    }
    GaussianRational both{x.second.real + y.second.real, x.second.imaginary + y.second.imaginary};
    if (!is_zero(both)) terms.emplace_back(x.first, std::move(both));
    ++i;
    ++j;
  }
  terms.insert(terms.end(), i, i_end);
  terms.insert(terms.end(), j, j_end);
  return Polynomial(std::move(terms));
}

/// The terms in [first, last) times y: merges the products of both halves.
Polynomial multiply_range(Polynomial::const_iterator first, Polynomial::const_iterator last,
                          const Polynomial& y) {
  if (first == last) return {};
  if (last - first == 1) return multiply_by_term(y, first->second, first->first);
  const auto middle = first + (last - first) / 2;
  Polynomial x = multiply_range(first, middle, y);
  Polynomial z = multiply_range(middle, last, y);
  return merge_terms(std::make_move_iterator(x.begin()), std::make_move_iterator(x.end()),
                     std::make_move_iterator(z.begin()), std::make_move_iterator(z.end()));
}

}  // namespace

Polynomial sum(const Polynomial& x, const Polynomial& y) {
  return merge_terms(x.begin(), x.end(), y.begin(), y.end());
}

Polynomial product(const Polynomial& x, const Polynomial& y) {
  return x.size() < y.size() ? multiply_range(x.begin(), x.end(), y)
                             : multiply_range(y.begin(), y.end(), x);
}

Polynomial multiply_by_term(const Polynomial& x, const GaussianRational& coefficient,
                            const Monomial& monomial) {
  Polynomial::Terms terms;
  terms.reserve(x.size());
  for (const auto& [own, value] : x) {
    terms.emplace_back(product(own, monomial), product(value, coefficient));
  }
  return Polynomial(std::move(terms));
}

std::optional<cl_RA> ratio_of(const Polynomial& x, const Polynomial& y) {
  if (x.size() != y.size()) return std::nullopt;
  const GaussianRational ratio = product(x.begin()->second, reciprocal(y.begin()->second));
  if (!cln::zerop(ratio.imaginary)) return std::nullopt;
  const auto is_multiple = [&ratio](const auto& own, const auto& other) {
    return own.first == other.first && own.second == product(other.second, ratio);
  };
  if (!std::ranges::equal(x, y, is_multiple)) return std::nullopt;
  return ratio.real;
}

std::optional<cl_RA> rational_value(const Polynomial& x) {
  if (x.empty()) return cl_RA(0);
  if (x.size() > 1 || !x.begin()->first.empty()) return std::nullopt;
  if (!cln::zerop(x.begin()->second.imaginary)) return std::nullopt;
  return x.begin()->second.real;
}

SplitMonomial split_monomial(const Algebra& algebra, const Monomial& monomial) {
  SplitMonomial result;
  for (const AtomPower& factor : monomial) {
    const bool is_circular = algebra.atoms[factor.atom].kind == AtomKind::circular;
    (is_circular ? result.angle : result.powers).push_back(factor);
  }
  return result;
}

std::vector<AtomId> atoms_of(const Polynomial& sum) {
  std::vector<AtomId> atoms;
  for (const auto& [monomial, coefficient] : sum) {
    for (const AtomPower& power : monomial) atoms.push_back(power.atom);
  }
  std::ranges::sort(atoms);
  atoms.erase(std::unique(atoms.begin(), atoms.end()), atoms.end());
  return atoms;
}

std::map<Monomial, Polynomial, MonomialLess> group_terms_by_atoms(
    const Algebra& algebra, const Polynomial& sum, bool (*is_key_atom)(const Atom&)) {
  std::map<Monomial, Polynomial, MonomialLess> parts;
  for (const auto& [monomial, coefficient] : sum) {
    Monomial key;
    Monomial rest;
    for (const AtomPower& power : monomial) {
      (is_key_atom(algebra.atoms[power.atom]) ? key : rest).push_back(power);
    }
    parts[key].try_emplace(rest, coefficient);
  }
  return parts;
}

namespace {

/// Replaces each square of `atom` by one + other^2, with `one` = 1 or -1.
Polynomial replace_squares(const Polynomial& sum, AtomId atom, AtomId other, int one) {
  Polynomial result;
  for (const auto& [monomial, coefficient] : sum) {
    Polynomial term{{Monomial{}, coefficient}};
    for (const AtomPower& power : monomial) {
      const bool is_square = power.atom == atom && power.exponent >= 2;
      const std::int32_t left = is_square ? power.exponent % 2 : power.exponent;
      if (left != 0) term = multiply_by_term(term, {1, 0}, Monomial{{power.atom, left}});
      const Polynomial square =
          elgen::sum(constant_polynomial(one), {{Monomial{{other, 2}}, {1, 0}}});
      for (std::int32_t i = 0; is_square && i < power.exponent / 2; ++i) {
        term = product(term, square);
      }
    }
    for (const auto& [own, value] : term) add_term(result, own, value);
  }
  return result;
}

}  // namespace

bool is_one(const Polynomial& sum) {
  return sum.size() == 1 && sum.begin()->first.empty() && sum.begin()->second.real == 1;
}

Polynomial reduce_hyperbolic_squares(const Algebra& algebra, Polynomial sum) {
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
      if (algebra.atoms[cosine].arguments != algebra.atoms[sine].arguments) continue;
      for (Polynomial other :
           {replace_squares(sum, sine, cosine, -1), replace_squares(sum, cosine, sine, 1)}) {
        if (other.size() < sum.size()) sum = std::move(other);
      }
    }
  }
  return sum;
}

std::optional<Monomial> square_root(Monomial x) {
  for (AtomPower& power : x) {
    if (power.exponent % 2 != 0) return std::nullopt;
    power.exponent /= 2;
  }
  return x;
}

std::optional<Polynomial> square_root(const Polynomial& x) {
  const std::optional<Monomial> lead = square_root(x.rbegin()->first);
  if (!lead) return std::nullopt;
  Polynomial root{{*lead, {1, 0}}};
  Polynomial rest = sum(x, multiply_by_term(product(root, root), {-1, 0}));
  while (!rest.empty()) {
    if (root.size() > x.size()) return std::nullopt;
    const GaussianRational& next = rest.rbegin()->second;
    const Monomial monomial = product(rest.rbegin()->first, power(*lead, -1));
    if (root.find(monomial) != root.end()) return std::nullopt;
    add_term(root, monomial, {next.real / 2, next.imaginary / 2});
    rest = sum(x, multiply_by_term(product(root, root), {-1, 0}));
  }
  return root;
}

std::int32_t exponent_of(const Monomial& monomial, AtomId atom) {
  const auto own = std::ranges::find(monomial, atom, &AtomPower::atom);
  return own == monomial.end() ? 0 : own->exponent;
}

std::map<std::int32_t, Polynomial> coefficients_of(const Polynomial& x, AtomId atom) {
  std::map<std::int32_t, Polynomial> by_powers;
  for (const auto& [monomial, coefficient] : x) {
    const std::int32_t exponent = exponent_of(monomial, atom);
    by_powers[exponent].try_emplace(product(monomial, power(Monomial{{atom, 1}}, -exponent)),
                                    coefficient);
  }
  return by_powers;
}

Monomial common_divisor_powers(const Algebra& algebra, const Polynomial& sum) {
  Monomial lowest = split_monomial(algebra, common_powers(sum)).powers;
  erase_if(lowest, [](const AtomPower& power) { return power.exponent > 0; });
  return lowest;
}

bool is_real(const Algebra& algebra, const Polynomial& sum) {
  return std::ranges::all_of(sum, [&](const auto& term) {
    Monomial conjugate = term.first;
    for (AtomPower& power : conjugate) {
      const bool is_circular = algebra.atoms[power.atom].kind == AtomKind::circular;
      if (is_circular) power.exponent = -power.exponent;
    }
    const auto other = sum.find(conjugate);
    return other != sum.end() && other->second.real == term.second.real &&
           other->second.imaginary == -term.second.imaginary;
  });
}

bool contains_exponentials(const Algebra& algebra, const Polynomial& sum) {
  return std::ranges::any_of(
      sum, [&](const auto& term) { return !split_monomial(algebra, term.first).angle.empty(); });
}

}  // namespace elgen
