// factor_square_free: see kept_terms.hpp. Polynomials over the nodes of the graph, factored by
// Yun's algorithm (D. Y. Y. Yun, On square-free decomposition algorithms, SYMSAC 1976, pages 26 to
// 35).
#include <cln/integer.h>

#include <algorithm>
#include <utility>

#include "forms/present/polynomial.hpp"
#include "forms/write/kept_terms.hpp"

namespace elgen {
namespace {

constexpr std::size_t most_terms_of_polynomial = 30;

/// Limits of the terms of intermediate polynomials, and of products of terms. Sums that have a
/// repeated factor by design need a tenth of these limits.
constexpr std::size_t most_intermediate_terms = 200;
constexpr std::size_t most_products = 50'000;

/// exp(n x) is a power of exp(x) up to this n, because the degree of a polynomial limits its work.
constexpr int most_multiple = 16;

/// Thrown if a limit is exceeded.
struct WorkLimitExceeded {};

std::int32_t degree_of(const Polynomial& x, AtomId atom) {
  std::int32_t degree = 0;
  for (const auto& [monomial, coefficient] : x) {
    degree = std::max(degree, exponent_of(monomial, atom));
  }
  return degree;
}

Monomial atom_power(AtomId atom, std::int32_t exponent) { return power({{atom, 1}}, exponent); }

Polynomial derivative(const Polynomial& x, AtomId atom) {
  Polynomial result;
  for (const auto& [monomial, coefficient] : x) {
    const std::int32_t exponent = exponent_of(monomial, atom);
    if (exponent == 0) continue;
    add_term(result, product(monomial, atom_power(atom, -1)), product(coefficient, {exponent, 0}));
  }
  return result;
}

/// x with numbers in place of all atoms other than `atom`.
Polynomial substitute_numbers(const Polynomial& x, AtomId atom) {
  const std::vector<AtomId> atoms = atoms_of(x);
  Polynomial result;
  for (const auto& [monomial, coefficient] : x) {
    cln::cl_RA value = coefficient.real;
    for (std::size_t i = 0; i < atoms.size(); ++i) {
      if (atoms[i] == atom) continue;
      const cln::cl_RA number = 7 + 4 * static_cast<long>(i);
      value = value * cln::expt(number, cln::cl_I(exponent_of(monomial, atoms[i])));
    }
    add_term(result, atom_power(atom, exponent_of(monomial, atom)), {value, 0});
  }
  return result;
}

/// Greatest common divisors of polynomials without negative powers, by Euclid's algorithm.
class PolynomialGcd {
 public:
  Polynomial greatest_divisor(Polynomial x, Polynomial y) {
    if (x.empty() || y.empty()) return x.empty() ? y : x;
    const std::vector<AtomId> atoms = atoms_of(x);
    if (atoms.empty() || atoms_of(y).empty()) return constant_polynomial(1);
    const AtomId atom = atoms.front();
    if (degree_of(y, atom) == 0) return greatest_divisor(content(x, atom), std::move(y));
    const Polynomial shared = greatest_divisor(content(x, atom), content(y, atom));
    x = primitive_part(x, atom);
    y = primitive_part(y, atom);
    while (!y.empty()) {
      if (degree_of(x, atom) < degree_of(y, atom)) std::swap(x, y);
      if (degree_of(y, atom) == 0) return shared;
      Polynomial rest = pseudo_remainder(x, y, atom);
      x = std::move(y);
      y = rest.empty() ? rest : primitive_part(rest, atom);
    }
    return product(shared, x);
  }

  /// The greatest common divisor of the coefficients of x as a polynomial in `atom`.
  Polynomial content(const Polynomial& x, AtomId atom) {
    Polynomial shared;
    for (const auto& [exponent, coefficient] : coefficients_of(x, atom)) {
      shared = greatest_divisor(std::move(shared), coefficient);
    }
    return shared;
  }

  /// x / y; y must divide x.
  Polynomial divide_exactly(const Polynomial& x, const Polynomial& y) {
    if (y.size() == 1)
      return multiply_by_term(x, reciprocal(y.begin()->second), power(y.begin()->first, -1));
    std::optional<Polynomial> result = quotient(x, y, products_);
    if (!result) throw WorkLimitExceeded();
    return std::move(*result);
  }

 private:
  /// x without its content, with leading coefficient 1.
  Polynomial primitive_part(const Polynomial& x, AtomId atom) {
    const Polynomial result = divide_exactly(x, content(x, atom));
    return multiply_by_term(result, reciprocal(result.rbegin()->second));
  }

  /// Pseudo-remainder: the remainder of x times a power of the leading coefficient of y.
  Polynomial pseudo_remainder(Polynomial x, const Polynomial& y, AtomId atom) {
    const Polynomial lead = coefficients_of(y, atom).rbegin()->second;
    while (!x.empty() && degree_of(x, atom) >= degree_of(y, atom)) {
      const Polynomial own = coefficients_of(x, atom).rbegin()->second;
      const std::size_t cost = x.size() * lead.size() + y.size() * own.size();
      if (cost > products_ || x.size() > most_intermediate_terms) throw WorkLimitExceeded();
      products_ -= cost;
      const Monomial shift = atom_power(atom, degree_of(x, atom) - degree_of(y, atom));
      x = sum(product(x, lead), multiply_by_term(product(y, own), {-1, 0}, shift));
    }
    return x;
  }

  std::size_t products_ = most_products;
};

struct RepeatedFactor {
  Polynomial base = {};
  std::int32_t exponent = 1;
};

/// The factors of x with their exponents. The first factor is the content of x in `atom`. None if
/// no factor is repeated.
std::optional<std::vector<RepeatedFactor>> repeated_factors(const Polynomial& x, AtomId atom) {
  PolynomialGcd divisors;
  const Polynomial simple = substitute_numbers(x, atom);
  if (simple.empty()) return std::nullopt;
  const Polynomial shared = divisors.greatest_divisor(simple, derivative(simple, atom));
  if (degree_of(shared, atom) == 0) return std::nullopt;
  Polynomial made = divisors.content(x, atom);
  std::vector<RepeatedFactor> factors;
  factors.push_back({made});
  const Polynomial whole = divisors.divide_exactly(x, made);
  Polynomial rest = divisors.greatest_divisor(whole, derivative(whole, atom));
  if (degree_of(rest, atom) == 0) return std::nullopt;
  Polynomial left = divisors.divide_exactly(whole, rest);
  for (std::int32_t exponent = 1; degree_of(left, atom) > 0; ++exponent) {
    Polynomial next = divisors.greatest_divisor(left, rest);
    Polynomial base = divisors.divide_exactly(left, next);
    rest = divisors.divide_exactly(rest, next);
    left = std::move(next);
    for (std::int32_t i = 0; i < exponent; ++i) made = product(made, base);
    factors.push_back({std::move(base), exponent});
  }
  const GaussianRational scale = product(x.rbegin()->second, reciprocal(made.rbegin()->second));
  if (multiply_by_term(made, scale) != x) return std::nullopt;
  factors.push_back({multiply_by_term(constant_polynomial(1), scale)});
  return factors;
}

class SquareFreeFactoriser : GraphTermBuilder {
 public:
  SquareFreeFactoriser(Graph& graph, RewriteOptions keeping)
      : GraphTermBuilder(graph), keeping_(keeping) {}

  std::optional<SignedNode> operator()(const std::vector<SignedNode>& terms) {
    Polynomial all;
    bool has_powers = false;
    for (const SignedNode term : terms) {
      const ScaledTerm parts = split_term(term);
      Monomial monomial;
      for (const Operand& factor : parts.factors) {
        const AtomPower power = power_of(factor);
        monomial = elgen::product(monomial, {power});
        has_powers = has_powers || (power.exponent != 1 && is_variable(power.atom));
      }
      add_term(all, monomial, {parts.coefficient, 0});
    }
    if (!has_powers) return std::nullopt;
    for (const AtomId atom : atoms_of(all)) {
      if (!is_variable(atom)) continue;
      if (const auto factored = factor_polynomial(all, atom)) return factored;
      if (const auto factored = factor_group(all, atom)) return factored;
    }
    return std::nullopt;
  }

 private:
  /// True for a coordinate and for a call that is not constant.
  [[nodiscard]] bool is_variable(AtomId atom) const {
    const Node& node = graph_.node(atom);
    const bool is_coordinate = node.kind == NodeKind::leaf && node.leaf == Opcode::coordinate;
    return is_coordinate || (node.kind == NodeKind::call && !graph_.is_constant(atom));
  }

  /// The factor as a power of an atom: exp(n x)^w = exp(x)^(n w).
  AtomPower power_of(const Operand& factor) {
    const bool is_exponential = is_call(graph_.node(factor.node), FunctionId::exp);
    if (!is_exponential) return {factor.node, factor.weight};
    ScaledTerm argument = split_term(argument_of(graph_.node(factor.node)));
    const cln::cl_I multiple = cln::abs(cln::numerator(argument.coefficient));
    if (multiple > cln::cl_I(most_multiple)) return {factor.node, factor.weight};
    argument.coefficient = argument.coefficient / multiple;
    return {call(FunctionId::exp, product(argument)).node,
            cln::cl_I_to_int(multiple) * factor.weight};
  }

  std::optional<SignedNode> factor_polynomial(const Polynomial& whole, AtomId atom) {
    const Monomial common = common_powers(whole);
    const Polynomial x = elgen::multiply_by_term(whole, {1, 0}, power(common, -1));
    if (x.size() < 3 || degree_of(x, atom) < 2) return std::nullopt;
    const auto factors = repeated_factors(x, atom);
    if (!factors) return std::nullopt;
    std::vector<Power> powers{{build_sum({{common, {1, 0}}})}};
    for (const auto& [base, exponent] : *factors) {
      const SignedNode value = build_sum(base);
      powers.push_back({rewrite_sum(graph_, keeping_, value).value_or(value), exponent});
    }
    return graph_.product(powers);
  }

  /// Factors the sum of the terms in which every factor is `atom` or has a parameter term; adds the
  /// other terms unchanged.
  std::optional<SignedNode> factor_group(const Polynomial& all, AtomId atom) {
    Polynomial group;
    Polynomial others;
    for (const auto& [monomial, coefficient] : all) {
      const bool is_alone = std::ranges::all_of(monomial, [&](const AtomPower& power) {
        return power.atom == atom || has_parameter_term({power.atom, false});
      });
      (is_alone ? group : others).try_emplace(monomial, coefficient);
    }
    if (others.empty() || group.size() < 3) return std::nullopt;
    const auto factored = factor_polynomial(group, atom);
    return factored ? std::optional(graph_.sum({*factored, build_sum(others)})) : std::nullopt;
  }

  SignedNode build_sum(const Polynomial& x) {
    std::vector<SignedNode> terms;
    for (const auto& [monomial, coefficient] : x) {
      std::vector<Operand> factors;
      for (const AtomPower& power : monomial) factors.push_back({power.atom, power.exponent});
      terms.push_back(product(coefficient.real, factors));
    }
    return graph_.sum(terms);
  }

  RewriteOptions keeping_;
};

}  // namespace

std::optional<SignedNode> factor_square_free(Graph& graph, RewriteOptions keeping,
                                             const std::vector<SignedNode>& terms) {
  if (terms.size() < 3 || terms.size() > most_terms_of_polynomial) return std::nullopt;
  try {
    return SquareFreeFactoriser(graph, keeping)(terms);
  } catch (const WorkLimitExceeded&) {
    return std::nullopt;
  }
}

}  // namespace elgen
