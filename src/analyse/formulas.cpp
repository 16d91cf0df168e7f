// A closed form is treated like an entry of an output: written as in a book, or by its shortest
// rewriting where it is long, turned into a function, and printed.
#include "analyse/formulas.hpp"

#include <algorithm>
#include <map>

#include "choose/entries.hpp"
#include "elgen/typeset.hpp"
#include "forms/write/closed_graph.hpp"
#include "numbers/exact_number.hpp"
#include "program/network/linearise.hpp"
#include "render/function_formulas.hpp"

namespace elgen {
namespace {

Formula text_of(const Printed& formula) { return {formula.text, formula.binding}; }
Formula latex_of(const Printed& formula) { return {formula.latex, formula.latex_binding}; }

Printed printed(const Formula& text, const Formula& latex) {
  return {text.text(), latex.text(), text.binding, latex.binding};
}

}  // namespace

Printed at_least(const Printed& formula, Binding least) {
  return printed(at_least(model_spelling, text_of(formula), least),
                 at_least(latex_spelling, latex_of(formula), least));
}

Printed product_with_power(const Printed& x, const Printed& y, std::uint32_t exponent) {
  const auto made = [exponent](const Spelling& spelling, const Formula& first,
                               const Formula& base) {
    return product(spelling, {first, power(spelling, base, number(spelling, exponent))});
  };
  return printed(made(model_spelling, text_of(x), text_of(y)),
                 made(latex_spelling, latex_of(x), latex_of(y)));
}

Printed sum(const Printed& x, const Printed& y, bool is_subtracted) {
  return printed(sum(model_spelling, {{text_of(x)}, {text_of(y), is_subtracted}}),
                 sum(latex_spelling, {{latex_of(x)}, {latex_of(y), is_subtracted}}));
}

std::optional<Printed> printed(const Model& model, const Algebra& algebra,
                               const std::optional<Fraction>& form) {
  if (!form) return std::nullopt;
  LeafNames leaves = leaf_names(model);
  leaves.momenta = leaves.v;
  leaves.E = energy_name(model);
  Program program{leaves};
  Function function = typeset_value(model, {}, algebra, *form, program);
  if (function.fields.empty()) {
    const std::optional<ReadableForm> readable =
        shortest(rewritings_of(algebra, *form).collected, nullptr, mixed_points(leaves));
    if (!readable) return std::nullopt;
    const Function shape{.fields = {Field{"", 1, 1, {0}}}};
    function = lowered_one_by_one({readable}, shape, program);
  }
  program.functions = {function};
  program.readable = {std::move(function)};
  const ReadFormula read = first_entry(model, program);
  return printed(read.text, read.latex);
}

bool holds_leaves(const Algebra& algebra, const Fraction& form) {
  return std::ranges::any_of(form.numerator, [&algebra](const auto& term) {
    return std::ranges::any_of(term.first, [&algebra](const AtomPower& power) {
      return algebra.atoms[power.atom].kind != AtomKind::pi;
    });
  });
}

Monomial divisor_powers(const Fraction& form) {
  std::map<AtomId, std::int32_t> lowest;
  for (const auto& [monomial, coefficient] : form.numerator) {
    for (const AtomPower& power : monomial) {
      std::int32_t& least = lowest[power.atom];
      least = std::min(least, power.exponent);
    }
  }
  Monomial monomial;
  for (const auto& [atom, exponent] : lowest) {
    if (exponent < 0) monomial.push_back({atom, -exponent});
  }
  return monomial;
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

std::optional<FormProgram> form_program(const LeafNames& leaves, const Algebra& algebra,
                                        const std::vector<Fraction>& forms) {
  Expressions expressions;
  for (const Fraction& form : forms) {
    const std::optional<Ref> value =
        closed_graph(expressions.graph, algebra, form, {}, PresentBudget{}.terms);
    if (!value) return std::nullopt;
    expressions.values.push_back(*value);
  }
  FormProgram result{Program{leaves}};
  Function function;
  Field& field = function.fields.emplace_back();
  field.rows = static_cast<std::uint32_t>(forms.size());
  for (std::uint32_t i = 0; i < forms.size(); ++i) field.entries.push_back(i);
  linearise(make_network(expressions), result.program, function);
  result.program.functions.push_back(std::move(function));
  return result;
}

Real value_of(const Algebra& algebra, const Fraction& form, const Arguments<Real>& at) {
  const std::optional<FormProgram> program = form_program({}, algebra, {form});
  return program ? evaluate(program->program, program->function(), at)[0] : Real::undefined();
}

}  // namespace elgen
