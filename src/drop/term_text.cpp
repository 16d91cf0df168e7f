// Terms as text. Factors stand as the model declares them: parameters, coordinates, rates, the
// rest.
#include "drop/term_text.hpp"

#include <algorithm>
#include <tuple>

#include "base/formula.hpp"
#include "base/number_text.hpp"
#include "drop/bounds.hpp"
#include "present/polynomial.hpp"

namespace elgen {
namespace {

using cln::cl_RA;

class TermText {
 public:
  TermText(const Algebra& algebra, const LeafNames& names) : algebra_(algebra), names_(names) {}

  [[nodiscard]] Formula fraction(const Fraction& x) const {
    std::vector<Summand> terms;
    for (const Fraction& term : in_order(terms_of(algebra_, x))) {
      const auto& [monomial, coefficient] = *term.numerator.rbegin();
      const std::vector<Summand> angle = angle_of(monomial);
      if (angle.empty()) {
        append(terms, coefficient.real, monomial, {});
        continue;
      }
      // c z + conj(c z) = 2 Re(c) cos - 2 Im(c) sin, of the angle as it is written
      const std::vector<Formula> argument = {elgen::sum(spelling_, angle)};
      append(terms, coefficient.real * 2, monomial, {called("cos", argument)});
      append(terms, coefficient.imaginary * -2, monomial, {called("sin", argument)});
    }
    if (terms.empty()) return {"0"};
    const Formula total = elgen::sum(spelling_, terms);
    return x.denominator.empty() ? total : divided(total, x);
  }

 private:
  /// Numerator and factors of the denominator in brackets, whatever they are.
  [[nodiscard]] Formula divided(const Formula& numerator, const Fraction& x) const {
    Formula result = called("", {numerator});
    for (const auto& [factor, exponent] : x.denominator) {
      const Formula own = called("", {fraction({algebra_.factors[factor].shown, {}})});
      result = quotient(spelling_, result, raised(own, exponent));
    }
    return result;
  }

  [[nodiscard]] Formula raised(const Formula& base, std::int32_t exponent) const {
    return exponent == 1 ? base : power(spelling_, base, number(spelling_, exponent));
  }

  void append(std::vector<Summand>& terms, const cl_RA& coefficient, const Monomial& monomial,
              const std::vector<Formula>& circular) const {
    if (cln::zerop(coefficient)) return;
    std::vector<Formula> factors;
    std::vector<Formula> divisors;
    for (const AtomPower& power : ordered(monomial)) {
      const Atom& known = algebra_.atoms[power.atom];
      if (known.kind == AtomKind::circular) continue;
      (power.exponent < 0 ? divisors : factors)
          .push_back(raised(atom(known), std::abs(power.exponent)));
    }
    factors.insert(factors.end(), circular.begin(), circular.end());
    const cl_RA magnitude = cln::abs(coefficient);
    if (magnitude != 1 || factors.empty()) factors.insert(factors.begin(), {exact_text(magnitude)});
    Formula term = product(spelling_, factors);
    for (const Formula& divisor : divisors) term = quotient(spelling_, term, divisor);
    terms.push_back({term, cln::minusp(coefficient)});
  }

  using Key = std::tuple<bool, Opcode, std::uint32_t, AtomId>;

  /// Leaves as they are declared, then the rest as it was met.
  [[nodiscard]] Key key_of(const AtomPower& power) const {
    const Atom& known = algebra_.atoms[power.atom];
    if (known.kind != AtomKind::leaf) return {true, Opcode::constant, 0, power.atom};
    return {false, known.leaf, known.index, power.atom};
  }

  [[nodiscard]] Monomial ordered(Monomial monomial) const {
    std::sort(monomial.begin(), monomial.end(),
              [&](const AtomPower& a, const AtomPower& b) { return key_of(a) < key_of(b); });
    return monomial;
  }

  [[nodiscard]] std::vector<Fraction> in_order(std::vector<Fraction> terms) const {
    const auto keys = [&](const Fraction& term) {
      std::vector<Key> result;
      for (const AtomPower& power : ordered(term.numerator.rbegin()->first)) {
        result.push_back(key_of(power));
      }
      return result;
    };
    std::stable_sort(terms.begin(), terms.end(),
                     [&](const Fraction& a, const Fraction& b) { return keys(a) < keys(b); });
    return terms;
  }

  /// exponent/divisor * argument of the exponentials, in one sum but for those with denominators.
  [[nodiscard]] std::vector<Summand> angle_of(const Monomial& monomial) const {
    Polynomial whole;
    std::vector<Summand> terms;
    for (const AtomPower& power : monomial) {
      const Atom& known = algebra_.atoms[power.atom];
      if (known.kind != AtomKind::circular) continue;
      const Fraction& argument = known.arguments[0];
      const Polynomial own = scaled(argument.numerator, {power.exponent / known.divisor, 0});
      if (argument.denominator.empty()) {
        whole = elgen::sum(std::move(whole), own);
      } else {
        terms.push_back({fraction({own, argument.denominator})});
      }
    }
    if (!whole.empty()) terms.insert(terms.begin(), {fraction({whole, {}})});
    return terms;
  }

  [[nodiscard]] Formula atom(const Atom& known) const {
    std::vector<Formula> arguments;
    for (const Fraction& argument : known.arguments) arguments.push_back(fraction(argument));
    switch (known.kind) {
      case AtomKind::leaf:
        return {leaf_text(names_, known.leaf, known.index)};
      case AtomKind::root:
        return square_root(spelling_, arguments.front());
      case AtomKind::call:
        return call(spelling_, known.function, arguments);
      default:
        return {"pi"};
    }
  }

  const Algebra& algebra_;
  const LeafNames& names_;
  const Spelling& spelling_ = model_spelling();
};

}  // namespace

std::string term_text(const Algebra& algebra, const LeafNames& names, const Fraction& x) {
  return TermText(algebra, names).fraction(x).text();
}

}  // namespace elgen
