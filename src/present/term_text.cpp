// Terms as text. Factors stand as the model declares them: parameters, coordinates, rates, the
// rest.
#include "term_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "base/number_text.hpp"
#include "bounds.hpp"
#include "polynomial.hpp"

namespace elgen::presenting {
namespace {

using cln::cl_RA;

class TermText {
 public:
  TermText(const Algebra& algebra, const LeafNames& names) : algebra_(algebra), names_(names) {}

  [[nodiscard]] std::string fraction(const Fraction& x) const {
    std::string text;
    for (const Fraction& term : in_order(terms_of(algebra_, x))) {
      const auto& [monomial, coefficient] = *term.numerator.rbegin();
      const std::string angle = angle_of(monomial);
      if (angle.empty()) {
        append(text, coefficient.real, monomial, "");
        continue;
      }
      // c z + conj(c z) = 2 Re(c) cos - 2 Im(c) sin, of the angle as it is written
      append(text, coefficient.real * 2, monomial, "cos(" + angle + ")");
      append(text, coefficient.imaginary * -2, monomial, "sin(" + angle + ")");
    }
    if (text.empty()) return "0";
    if (x.denominator.empty()) return text;
    return "(" + text + ")" + divisors(x);
  }

 private:
  [[nodiscard]] std::string divisors(const Fraction& x) const {
    std::string text;
    for (const auto& [factor, exponent] : x.denominator) {
      text += "/(" + fraction({algebra_.factors[factor].shown, {}}) + ")";
      if (exponent != 1) text += fmt::format("^{}", exponent);
    }
    return text;
  }

  void append(std::string& text, const cl_RA& coefficient, const Monomial& monomial,
              const std::string& circular) const {
    if (cln::zerop(coefficient)) return;
    std::string factors;
    std::string divided;
    for (const AtomPower& power : ordered(monomial)) {
      if (algebra_.atoms[power.atom].kind == AtomKind::circular) continue;
      const std::int32_t exponent = std::abs(power.exponent);
      const std::string own =
          atom(algebra_.atoms[power.atom]) + (exponent == 1 ? "" : fmt::format("^{}", exponent));
      if (power.exponent < 0) {
        divided += "/" + own;
      } else {
        factors += "*" + own;
      }
    }
    if (!circular.empty()) factors += "*" + circular;
    const cl_RA magnitude = cln::abs(coefficient);
    const bool is_one = magnitude == 1 && !factors.empty();
    const std::string product =
        (is_one ? factors.substr(1) : exact_text(magnitude) + factors) + divided;
    const bool is_negative = cln::minusp(coefficient);
    if (text.empty()) {
      text = (is_negative ? "-" : "") + product;
    } else {
      text += (is_negative ? " - " : " + ") + product;
    }
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

  /// The sum of exponent/divisor * argument over the exponentials; empty without any.
  [[nodiscard]] std::string angle_of(const Monomial& monomial) const {
    Polynomial sum;
    std::string others;
    for (const AtomPower& power : monomial) {
      const Atom& known = algebra_.atoms[power.atom];
      if (known.kind != AtomKind::circular) continue;
      const Fraction& argument = known.arguments[0];
      const Polynomial own = scaled(argument.numerator, {power.exponent / known.divisor, 0});
      if (argument.denominator.empty()) {
        sum = presenting::sum(std::move(sum), own);
      } else {
        others += (others.empty() ? "" : " + ") + fraction({own, argument.denominator});
      }
    }
    if (sum.empty()) return others;
    return fraction({sum, {}}) + (others.empty() ? "" : " + " + others);
  }

  [[nodiscard]] std::string atom(const Atom& known) const {
    std::string arguments;
    for (const Fraction& argument : known.arguments) {
      arguments += (arguments.empty() ? "" : ", ") + fraction(argument);
    }
    switch (known.kind) {
      case AtomKind::leaf:
        return leaf(known);
      case AtomKind::root:
        return "sqrt(" + arguments + ")";
      case AtomKind::call:
        return fmt::format("{}({})", function_row(known.function).name, arguments);
      default:
        return "pi";
    }
  }

  [[nodiscard]] std::string leaf(const Atom& known) const {
    switch (known.leaf) {
      case Opcode::parameter:
        return names_.parameters[known.index];
      case Opcode::coordinate:
        return names_.q[known.index];
      case Opcode::velocity:
        return "dot(" + names_.v[known.index] + ")";
      default:
        return "t";
    }
  }

  const Algebra& algebra_;
  const LeafNames& names_;
};

}  // namespace

std::string term_text(const Algebra& algebra, const LeafNames& names, const Fraction& x) {
  return TermText(algebra, names).fraction(x);
}

}  // namespace elgen::presenting
