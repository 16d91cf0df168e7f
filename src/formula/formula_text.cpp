// formula_text: writes trees in the model language, on one line, with brackets only if needed.
#include "formula/formula_text.hpp"

#include <cln/integer.h>
#include <fmt/format.h>

#include <algorithm>

#include "elgen/formula.hpp"
#include "formula/glyphs.hpp"
#include "numbers/exact_number.hpp"

namespace elgen {
namespace {

std::string join_items(const std::vector<FormulaText>& items) {
  std::string list;
  for (const FormulaText& item : items) list += (list.empty() ? "" : ", ") + item.text;
  return list;
}

/// The binding of a product: `negation` if the first operand is a negation, otherwise `product`.
Binding product_binding(const FormulaText& first) {
  return first.binding == Binding::negation ? Binding::negation : Binding::product;
}

FormulaText print_formula(const Formula& formula);

std::vector<FormulaText> print_parts(const Formula& formula) {
  std::vector<FormulaText> all;
  for (const Formula& part : formula.parts) all.push_back(print_formula(part));
  return all;
}

FormulaText number_text(const cln::cl_RA& value) {
  if (cln::minusp(value)) return negation_text(number_text(-value));
  const cln::cl_I denominator = cln::denominator(value);
  const FormulaText above{integer_text(cln::numerator(value))};
  return denominator == 1 ? above
                          : quotient_text(model_spelling, above, {integer_text(denominator)});
}

/// A term of a sum. The first term keeps its sign; a later negative term is subtracted.
Summand make_summand(const Formula& term, bool is_first) {
  if (is_first) return {bracket_if_weaker(print_formula(term), Binding::negation)};
  if (term.kind == FormulaKind::negative) return {print_formula(term.parts[0]), true};
  return {print_formula(term)};
}

FormulaText sum_text(const Formula& formula) {
  std::vector<Summand> terms;
  for (const Formula& term : formula.parts) terms.push_back(make_summand(term, terms.empty()));
  return sum_text(terms);
}

FormulaText call_text(const Formula& formula) {
  const std::vector<FormulaText> arguments = print_parts(formula);
  const std::string_view own = formula.function == FunctionId::stumpff
                                   ? stumpff_name(formula.parts.back().number)
                                   : std::string_view();
  return own.empty() ? named_call_text(function_row(formula.function).name, arguments)
                     : named_call_text(own, {arguments.front()});
}

/// Joins parts with blanks, except before punctuation.
std::string row_text(const Formula& formula) {
  std::string text;
  for (const Formula& part : formula.parts) {
    const std::string next = print_formula(part).text;
    const bool is_close = next.empty() || follows_without_blank(next);
    text += (text.empty() || is_close ? "" : " ") + next;
  }
  return text;
}

FormulaText print_formula(const Formula& formula) {
  const Formulas& parts = formula.parts;
  switch (formula.kind) {
    case FormulaKind::number:
      return formula.text.empty() ? number_text(formula.number) : FormulaText{formula.text};
    case FormulaKind::symbol:
      return {formula.symbol->name};
    case FormulaKind::negative:
      return negation_text(bracket_if_weaker(print_formula(parts[0]), Binding::product));
    case FormulaKind::plus_minus:
      return {"+-" + bracket_if_weaker(print_formula(parts[0]), Binding::product).text,
              Binding::negation};
    case FormulaKind::sum:
      return sum_text(formula);
    case FormulaKind::product:
      return product_text(model_spelling, print_parts(formula));
    case FormulaKind::quotient:
      return quotient_text(model_spelling, print_formula(parts[0]), print_formula(parts[1]));
    case FormulaKind::power:
      return power_text(print_formula(parts[0]), print_formula(parts[1]));
    case FormulaKind::root:
      return named_call_text("sqrt", print_parts(formula));
    case FormulaKind::call:
      return call_text(formula);
    case FormulaKind::absolute_value:
      return {fmt::format("|{}|", print_formula(parts[0]).text)};
    case FormulaKind::group:
      return bracket_if_weaker(print_formula(parts[0]), Binding::power);
    case FormulaKind::relation:
      return {fmt::format("{} {} {}", print_formula(parts[0]).text, formula.text,
                          print_formula(parts[1]).text),
              Binding::sum};
    case FormulaKind::list:
      return {join_items(print_parts(formula)), Binding::sum};
    case FormulaKind::tuple:
      return {fmt::format("({})", join_items(print_parts(formula)))};
    case FormulaKind::prose:
      return {formula.text, Binding::sum};
    case FormulaKind::row:
      return {row_text(formula), Binding::sum};
  }
  return {};
}

}  // namespace

FormulaText bracket_if_weaker(const FormulaText& formula, Binding least) {
  return formula.binding < least ? FormulaText{fmt::format("({})", formula.text)} : formula;
}

FormulaText negation_text(const FormulaText& operand) {
  return {"-" + bracket_if_weaker(operand, Binding::product).text, Binding::negation};
}

FormulaText sum_text(const std::vector<Summand>& terms) {
  const auto& [first, is_subtracted] = terms.front();
  const FormulaText start = is_subtracted ? negation_text(first) : first;
  if (terms.size() == 1) return start;
  std::string text = start.text;
  for (std::size_t i = 1; i < terms.size(); ++i) {
    text += terms[i].is_subtracted ? " - " : " + ";
    text += bracket_if_weaker(terms[i].term, Binding::product).text;
  }
  return {text, Binding::sum};
}

FormulaText product_text(const OperatorSpelling& spelling,
                         const std::vector<FormulaText>& factors) {
  if (factors.size() == 1) return factors.front();
  // Only the first factor may be a quotient or have a sign without brackets.
  std::string text = bracket_if_weaker(factors.front(), Binding::negation).text;
  for (std::size_t i = 1; i < factors.size(); ++i) {
    text += std::string(spelling.times) + bracket_if_weaker(factors[i], Binding::power).text;
  }
  return {text, product_binding(factors.front())};
}

FormulaText quotient_text(const OperatorSpelling& spelling, const FormulaText& above,
                          const FormulaText& below) {
  return {bracket_if_weaker(above, Binding::negation).text + std::string(spelling.over) +
              bracket_if_weaker(below, Binding::power).text,
          product_binding(above)};
}

FormulaText power_text(const FormulaText& base, const FormulaText& exponent) {
  return {fmt::format("{}^{}", bracket_if_weaker(base, Binding::atom).text,
                      bracket_if_weaker(exponent, Binding::atom).text),
          Binding::power};
}

FormulaText named_call_text(std::string_view name, const std::vector<FormulaText>& arguments) {
  return {fmt::format("{}({})", name, join_items(arguments))};
}

std::string text_of(const Formula& formula) { return print_formula(formula).text; }

std::vector<std::string> texts_of(const Formulas& formulas) {
  std::vector<std::string> texts;
  for (const Formula& formula : formulas) texts.push_back(text_of(formula));
  return texts;
}

}  // namespace elgen
