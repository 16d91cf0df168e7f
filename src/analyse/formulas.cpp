// The divisors of a form are its negative powers and its denominator; its program is that of its
// graph.
#include "analyse/formulas.hpp"

#include <algorithm>

#include "forms/present/polynomial.hpp"
#include "forms/write/closed_graph.hpp"

namespace elgen {

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

}  // namespace elgen
