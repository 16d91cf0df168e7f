// The divisors of a form are its negative powers and its denominator. A substitution goes term by
// term and rebuilds every atom that contains a replaced leaf from its substituted arguments.
#include "analyse/formulas.hpp"

#include <cln/integer.h>

#include <algorithm>

#include "forms/present/polynomial.hpp"
#include "forms/write/closed_graph.hpp"
#include "numbers/exact_number.hpp"
#include "program/network/linearise.hpp"

namespace elgen {
namespace {

using cln::cl_RA;

/// x + i y with real x, y.
Value complex_form(Arithmetic& arithmetic, const Value& x, const Value& y) {
  const Fraction i = fraction_of(Polynomial{{Monomial{}, Gaussian{0, 1}}});
  return arithmetic.add(x, arithmetic.multiply(y, i));
}

class FormSubstitution {
 public:
  FormSubstitution(Algebra& algebra, const Replacements& replacements)
      : algebra_(algebra),
        replacements_(replacements),
        arithmetic_(algebra),
        replaced_(algebra, [&replacements](const Atom& leaf) {
          return replacements.contains({leaf.leaf, leaf.index});
        }) {}

  Value of(const Fraction& form) {
    Value result = of(form.numerator);
    for (const auto& [factor, exponent] : form.denominator) {
      const Polynomial shown = algebra_.factors[factor].shown;  // a copy, as factors may be added
      const Value divisor = of(shown);
      if (!divisor || divisor->numerator.empty()) return std::nullopt;
      result = arithmetic_.divide(result, arithmetic_.power(divisor, exponent));
    }
    return result;
  }

 private:
  Value of(const Polynomial& sum) {
    Value result = Fraction{};
    for (const auto& [monomial, coefficient] : sum) {
      Monomial kept;
      Value term = fraction_of(cl_RA(1));
      for (const AtomPower& power : monomial) {
        if (replaced_.holds(power.atom)) {
          term = arithmetic_.multiply(term, of_power(power));
        } else {
          kept.push_back(power);
        }
      }
      const Fraction rest = fraction_of(Polynomial{{kept, coefficient}});
      result = arithmetic_.add(result, arithmetic_.multiply(term, rest));
    }
    return result;
  }

  Value of_power(const AtomPower& power) {
    const Atom atom = algebra_.atoms[power.atom];  // a copy, as atoms may be added
    switch (atom.kind) {
      case AtomKind::leaf:
        return powered(replacements_.at({atom.leaf, atom.index}).value, power.exponent);
      case AtomKind::circular:
        return circular_power(atom, power.exponent);
      case AtomKind::root:
        return powered(arithmetic_.square_root(of(atom.arguments[0])), power.exponent);
      case AtomKind::sum:
        return powered(of(atom.arguments[0]), power.exponent);
      case AtomKind::call: {
        const Value x = of(atom.arguments.front());
        const Value y = atom.arguments.size() > 1 ? of(atom.arguments.back()) : Value();
        return powered(arithmetic_.call(atom.function, x, y), power.exponent);
      }
      case AtomKind::pi:
        return fraction_of(Polynomial{{Monomial{power}, Gaussian{1, 0}}});
    }
    return std::nullopt;
  }

  /// base^exponent; none for a negative power of 0.
  Value powered(const Value& base, std::int32_t exponent) {
    if (!base || (exponent < 0 && base->numerator.empty())) return std::nullopt;
    return arithmetic_.power(base, exponent);
  }

  /// e^(i exponent argument/divisor)
  Value circular_power(const Atom& atom, std::int32_t exponent) {
    const cl_RA multiple = cl_RA(exponent) / atom.divisor;
    const std::optional<CosineAndSine> known = known_sinusoids(atom);
    if (known && cln::denominator(multiple) == 1) {
      // cos q - i sin q for e^(-i q) avoids the reciprocal of a sum.
      const Value sine =
          cln::minusp(multiple) ? arithmetic_.negate(known->sine) : Value(known->sine);
      const cln::cl_I power = cln::abs(cln::numerator(multiple));
      return powered(complex_form(arithmetic_, known->cosine, sine),
                     static_cast<std::int32_t>(cln::cl_I_to_long(power)));
    }
    const Value angle = arithmetic_.multiply(of(atom.arguments[0]), fraction_of(multiple));
    const Value cosine = arithmetic_.call(FunctionId::cos, angle, {});
    const Value sine = arithmetic_.call(FunctionId::sin, angle, {});
    return complex_form(arithmetic_, cosine, sine);
  }

  /// The cosine and sine of the atom's leaf, if its replacement has them.
  [[nodiscard]] std::optional<CosineAndSine> known_sinusoids(const Atom& atom) const {
    const Atom* const leaf = leaf_within(algebra_, atom);
    if (leaf == nullptr) return std::nullopt;
    const auto found = replacements_.find({leaf->leaf, leaf->index});
    return found == replacements_.end() ? std::nullopt : found->second.sinusoids;
  }

  Algebra& algebra_;
  const Replacements& replacements_;
  Arithmetic arithmetic_;
  LeafSearch replaced_;
};

}  // namespace

bool holds_leaves(const Algebra& algebra, const Fraction& form) {
  return std::ranges::any_of(form.numerator, [&algebra](const auto& term) {
    return std::ranges::any_of(term.first, [&algebra](const AtomPower& power) {
      return algebra.atoms[power.atom].kind != AtomKind::pi;
    });
  });
}

Monomial divisor_powers(const Fraction& form) {
  Monomial lowest = common_powers(form.numerator);
  erase_if(lowest, [](const AtomPower& power) { return power.exponent > 0; });
  return power(lowest, -1);
}

Value divisor_of(Algebra& algebra, const Fraction& form) {
  Arithmetic arithmetic(algebra);
  Value result = fraction_of(Polynomial{{divisor_powers(form), Gaussian{1, 0}}});
  for (const auto& [factor, exponent] : form.denominator) {
    const Fraction shown = fraction_of(algebra.factors[factor].shown);
    result = arithmetic.multiply(result, arithmetic.power(shown, exponent));
  }
  return result;
}

std::optional<Linearised> form_program(const LeafNames& leaves, const Algebra& algebra,
                                       const Fraction& form) {
  Expressions expressions;
  const std::optional<Ref> value =
      closed_graph(expressions.graph, algebra, form, {}, PresentBudget{}.terms);
  if (!value) return std::nullopt;
  expressions.values = {*value};
  Linearised result(make_network(expressions));
  result.program.leaves = leaves;
  return result;
}

Real value_of(const Algebra& algebra, const Fraction& form, const Arguments<Real>& at) {
  const std::optional<Linearised> program = form_program({}, algebra, form);
  return program ? evaluate(program->program, program->function, at)[0] : Real::undefined();
}

const Atom* leaf_within(const Algebra& algebra, const Atom& function) {
  const Fraction& argument = function.arguments[0];
  if (argument.numerator.size() != 1 || !argument.denominator.empty()) return nullptr;
  const Monomial& monomial = argument.numerator.begin()->first;
  if (monomial.size() != 1 || monomial[0].exponent != 1) return nullptr;
  const Atom& leaf = algebra.atoms[monomial[0].atom];
  return leaf.kind == AtomKind::leaf ? &leaf : nullptr;
}

Value substituted(Algebra& algebra, const Value& form, const Replacements& replacements) {
  return form ? FormSubstitution(algebra, replacements).of(*form) : std::nullopt;
}

std::optional<Replacements> parameter_values(const std::vector<cln::cl_R>& values) {
  Replacements result;
  for (std::uint32_t i = 0; i < values.size(); ++i) {
    if (!is_rational(values[i])) return std::nullopt;
    result[{Opcode::parameter, i}].value = fraction_of(cln::rational(values[i]));
  }
  return result;
}

}  // namespace elgen
