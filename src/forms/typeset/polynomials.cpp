// polynomials: see polynomials.hpp.
#include "forms/typeset/polynomials.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "forms/present/polynomial.hpp"
#include "forms/write/real_terms.hpp"

namespace elgen {
namespace {

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

/// Every square of `atom` as `one` + the square of `other`.
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

}  // namespace

bool is_one(const Polynomial& sum) {
  return sum.size() == 1 && sum.begin()->first.empty() && sum.begin()->second.real == 1;
}

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

std::optional<Polynomial> square_root(const Polynomial& x) {
  Monomial lead = x.rbegin()->first;
  for (AtomPower& power : lead) {
    if (power.exponent % 2 != 0) return std::nullopt;
    power.exponent /= 2;
  }
  Polynomial root{{lead, {1, 0}}};
  Polynomial rest = sum(x, scaled(product(root, root), {-1, 0}));
  while (!rest.empty()) {
    if (root.size() > x.size()) return std::nullopt;
    const Gaussian& next = rest.rbegin()->second;
    const Monomial monomial = product(rest.rbegin()->first, power(lead, -1));
    if (root.count(monomial) > 0) return std::nullopt;
    add_term(root, monomial, {next.real / 2, next.imaginary / 2});
    rest = sum(x, scaled(product(root, root), {-1, 0}));
  }
  return root;
}

Polynomial highest_coefficient(const Polynomial& x, AtomId atom) {
  std::map<std::int32_t, Polynomial> by_powers;
  for (const auto& [monomial, coefficient] : x) {
    const auto own = std::ranges::find(monomial, atom, &AtomPower::atom);
    const std::int32_t exponent = own == monomial.end() ? 0 : own->exponent;
    by_powers[exponent].emplace(product(monomial, power(Monomial{{atom, 1}}, -exponent)),
                                coefficient);
  }
  return by_powers.rbegin()->second;
}

Monomial lowest_powers(const Algebra& algebra, const Polynomial& sum) {
  std::map<AtomId, std::int32_t> lowest;
  for (const auto& [monomial, coefficient] : sum) {
    for (const AtomPower& power : split(algebra, monomial).powers) {
      if (power.exponent < 0) lowest[power.atom] = std::min(lowest[power.atom], power.exponent);
    }
  }
  Monomial result;
  for (const auto& [atom, exponent] : lowest) result.push_back({atom, exponent});
  return result;
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

bool holds_exponentials(const Algebra& algebra, const Polynomial& sum) {
  return std::ranges::any_of(sum, [&](const auto& term) {
    return std::ranges::any_of(term.first, [&](const AtomPower& power) {
      return algebra.atoms[power.atom].kind == AtomKind::circular;
    });
  });
}

}  // namespace elgen
