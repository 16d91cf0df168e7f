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
OptionalFraction complex_form(Arithmetic& arithmetic, const OptionalFraction& x,
                              const OptionalFraction& y) {
  const Fraction i = fraction_of(Polynomial{{Monomial{}, GaussianRational{0, 1}}});
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

  OptionalFraction substitute_in(const Fraction& form) {
    OptionalFraction result = of(form.numerator);
    for (const auto& [factor, exponent] : form.denominator) {
      const Polynomial shown = algebra_.factors[factor].shown;  // a copy, as factors may be added
      const OptionalFraction divisor = of(shown);
      if (!divisor || divisor->numerator.empty()) return std::nullopt;
      result = arithmetic_.divide(result, arithmetic_.power(divisor, exponent));
    }
    return result;
  }

 private:
  OptionalFraction of(const Polynomial& sum) {
    OptionalFraction result = Fraction{};
    for (const auto& [monomial, coefficient] : sum) {
      Monomial kept;
      OptionalFraction term = fraction_of(cl_RA(1));
      for (const AtomPower& power : monomial) {
        if (replaced_.contains(power.atom)) {
          term = arithmetic_.multiply(term, substitute_power(power));
        } else {
          kept.push_back(power);
        }
      }
      const Fraction rest = fraction_of(Polynomial{{kept, coefficient}});
      result = arithmetic_.add(result, arithmetic_.multiply(term, rest));
    }
    return result;
  }

  OptionalFraction substitute_power(const AtomPower& power) {
    const Atom atom = algebra_.atoms[power.atom];  // a copy, as atoms may be added
    switch (atom.kind) {
      case AtomKind::leaf:
        return checked_power(replacements_.at({atom.leaf, atom.index}).value, power.exponent);
      case AtomKind::circular:
        return circular_power(atom, power.exponent);
      case AtomKind::root:
        return checked_power(arithmetic_.square_root(substitute_in(atom.arguments[0])),
                             power.exponent);
      case AtomKind::unexpanded_sum:
        return checked_power(substitute_in(atom.arguments[0]), power.exponent);
      case AtomKind::call: {
        const OptionalFraction x = substitute_in(atom.arguments.front());
        const OptionalFraction y =
            atom.arguments.size() > 1 ? substitute_in(atom.arguments.back()) : OptionalFraction();
        return checked_power(arithmetic_.call(atom.function, x, y), power.exponent);
      }
      case AtomKind::pi:
        return fraction_of(Polynomial{{Monomial{power}, GaussianRational{1, 0}}});
    }
    return std::nullopt;
  }

  /// base^exponent; none for a negative power of 0.
  OptionalFraction checked_power(const OptionalFraction& base, std::int32_t exponent) {
    if (!base || (exponent < 0 && base->numerator.empty())) return std::nullopt;
    return arithmetic_.power(base, exponent);
  }

  /// e^(i exponent argument/divisor)
  OptionalFraction circular_power(const Atom& atom, std::int32_t exponent) {
    const cl_RA multiple = cl_RA(exponent) / atom.divisor;
    const std::optional<CosineAndSine> known = known_sinusoids(atom);
    if (known && cln::denominator(multiple) == 1) {
      // cos q - i sin q for e^(-i q) avoids the reciprocal of a sum.
      const OptionalFraction sine =
          cln::minusp(multiple) ? arithmetic_.negate(known->sine) : OptionalFraction(known->sine);
      const cln::cl_I power = cln::abs(cln::numerator(multiple));
      return checked_power(complex_form(arithmetic_, known->cosine, sine),
                           static_cast<std::int32_t>(cln::cl_I_to_long(power)));
    }
    const OptionalFraction angle =
        arithmetic_.multiply(substitute_in(atom.arguments[0]), fraction_of(multiple));
    const OptionalFraction cosine = arithmetic_.call(FunctionId::cos, angle, {});
    const OptionalFraction sine = arithmetic_.call(FunctionId::sin, angle, {});
    return complex_form(arithmetic_, cosine, sine);
  }

  /// Replacement::sinusoids of the leaf x if the argument of `atom` is a multiple of x; else none.
  [[nodiscard]] std::optional<CosineAndSine> known_sinusoids(const Atom& atom) const {
    const Atom* const leaf = find_argument_leaf(algebra_, atom);
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

bool contains_leaves(const Algebra& algebra, const Fraction& form) {
  return std::ranges::any_of(form.numerator, [&algebra](const auto& term) {
    return std::ranges::any_of(term.first, [&algebra](const AtomPower& power) {
      return algebra.atoms[power.atom].kind != AtomKind::pi;
    });
  });
}

Monomial monomial_denominator(const Fraction& form) {
  Monomial lowest = common_powers(form.numerator);
  erase_if(lowest, [](const AtomPower& power) { return power.exponent > 0; });
  return power(lowest, -1);
}

OptionalFraction full_denominator(Algebra& algebra, const Fraction& form) {
  Arithmetic arithmetic(algebra);
  OptionalFraction result =
      fraction_of(Polynomial{{monomial_denominator(form), GaussianRational{1, 0}}});
  for (const auto& [factor, exponent] : form.denominator) {
    const Fraction shown = fraction_of(algebra.factors[factor].shown);
    result = arithmetic.multiply(result, arithmetic.power(shown, exponent));
  }
  return result;
}

std::optional<LinearisedNetwork> form_program(const LeafNames& leaves, const Algebra& algebra,
                                              const Fraction& form) {
  Expressions expressions;
  const std::optional<SignedNode> value =
      build_closed_graph(expressions.graph, algebra, form, {}, ClosedFormBudget{}.terms);
  if (!value) return std::nullopt;
  expressions.values = {*value};
  LinearisedNetwork result(make_network(expressions));
  result.program.leaves = leaves;
  return result;
}

Real evaluate_form(const Algebra& algebra, const Fraction& form, const Arguments<Real>& at) {
  const std::optional<LinearisedNetwork> program = form_program({}, algebra, form);
  return program ? evaluate(program->program, program->function, at)[0] : Real::undefined();
}

const Atom* find_argument_leaf(const Algebra& algebra, const Atom& function) {
  const Fraction& argument = function.arguments[0];
  if (argument.numerator.size() != 1 || !argument.denominator.empty()) return nullptr;
  const Monomial& monomial = argument.numerator.begin()->first;
  if (monomial.size() != 1 || monomial[0].exponent != 1) return nullptr;
  const Atom& leaf = algebra.atoms[monomial[0].atom];
  return leaf.kind == AtomKind::leaf ? &leaf : nullptr;
}

OptionalFraction substitute(Algebra& algebra, const OptionalFraction& form,
                            const Replacements& replacements) {
  return form ? FormSubstitution(algebra, replacements).substitute_in(*form) : std::nullopt;
}

std::optional<Replacements> parameter_replacements(const std::vector<cln::cl_R>& values) {
  Replacements result;
  for (std::uint32_t i = 0; i < values.size(); ++i) {
    if (!is_rational(values[i])) return std::nullopt;
    result[{Opcode::parameter, i}].value = fraction_of(cln::rational(values[i]));
  }
  return result;
}

}  // namespace elgen
