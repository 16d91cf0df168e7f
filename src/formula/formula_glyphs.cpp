// formula_glyphs: typesets trees: factors side by side, fractions stacked, brackets as tall as
// their content.
#include <cln/integer.h>
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "base/ascii.hpp"
#include "elgen/formula.hpp"
#include "formula/formula_text.hpp"
#include "formula/glyphs.hpp"
#include "numbers/exact_number.hpp"

namespace elgen {
namespace {

/// Pieces in a row. If the row is a call, an exponent is set on the first piece: sin^2 x.
struct TypesetRow {
  Glyphs row = {};
  Binding binding = Binding::atom;
  bool is_call = false;
};

TypesetRow typeset_formula(const Formula& formula);

Glyphs digit_row(const std::string& text) { return make_row({GlyphKind::number, text}); }

Glyphs integer_row(const cln::cl_I& value) { return digit_row(integer_text(value)); }

bool is_tall(const Glyphs& glyphs) {
  return glyphs.kind == GlyphKind::fraction || glyphs.kind == GlyphKind::root ||
         std::ranges::any_of(glyphs.parts, is_tall);
}

bool has_exponent(const Glyphs& glyphs) {
  const bool has = glyphs.kind == GlyphKind::scripts && !glyphs.parts[2].parts.empty();
  return has || std::ranges::any_of(glyphs.parts, has_exponent);
}

Glyphs add_brackets(Glyphs content) {
  const bool grows = is_tall(content);
  return enclose(std::move(content), "(", ")", grows);
}

Glyphs bracket_if_weaker(TypesetRow formula, Binding least) {
  return formula.binding < least ? add_brackets(std::move(formula.row)) : std::move(formula.row);
}

TypesetRow negate_row(TypesetRow operand) {
  Glyphs row;
  append_sign(row, "-", false);
  append(row, bracket_if_weaker(std::move(operand), Binding::product), false);
  return {std::move(row), Binding::negation};
}

TypesetRow typeset_fraction(Glyphs above, Glyphs below) {
  return {fraction_row(std::move(above), std::move(below)), Binding::power};
}

/// True if `value` is written as a decimal number, such as 9.81: the fraction is too long to read,
/// unlike 1/2 and 2/5, and the denominator is divisible by 5.
bool is_written_decimal(const cln::cl_RA& value) {
  constexpr int longest = 16;
  const cln::cl_I denominator = cln::denominator(value);
  const bool is_short = cln::numerator(value) <= longest && denominator <= longest;
  return !is_short && cln::zerop(cln::mod(denominator, 5)) && exact_decimal(value) &&
         exact_text(value).find('e') == std::string::npos;
}

TypesetRow typeset_number(const cln::cl_RA& value) {
  if (cln::minusp(value)) return negate_row(typeset_number(-value));
  const cln::cl_I denominator = cln::denominator(value);
  if (denominator == 1) return {integer_row(cln::numerator(value))};
  if (is_written_decimal(value)) return {digit_row(exact_text(value))};
  return typeset_fraction(integer_row(cln::numerator(value)), integer_row(denominator));
}

/// Sets 1.5e-07 as 1.5 10^-7.
TypesetRow typeset_digits(const std::string& text) {
  const std::size_t e = text.find('e');
  Glyphs row = digit_row(text.substr(0, e));
  if (e == std::string::npos) return {std::move(row)};
  append_sign(row, "⋅", true);
  append(row, digit_row("10"), true);
  const int exponent = std::stoi(text.substr(e + 1));
  Glyphs above = digit_row(std::to_string(std::abs(exponent)));
  if (exponent < 0) above.parts.insert(above.parts.begin(), {GlyphKind::sign, "-"});
  add_script(row, 2, std::move(above));
  return {std::move(row), Binding::product};
}

/// Appends a sign and a term: "-" and the operand for a negative term, otherwise "+" and the term.
void append_term(Glyphs& row, const Formula& term) {
  const bool is_negative = term.kind == FormulaKind::negative;
  append_sign(row, is_negative ? "-" : "+", true);
  append(row,
         bracket_if_weaker(typeset_formula(is_negative ? term.parts[0] : term), Binding::product),
         true);
}

TypesetRow typeset_sum(const Formula& formula) {
  TypesetRow first = typeset_formula(formula.parts.front());
  Glyphs row = std::move(first.row);
  for (std::size_t i = 1; i < formula.parts.size(); ++i) append_term(row, formula.parts[i]);
  return {std::move(row), Binding::sum};
}

bool begins_with_word(const Glyphs& row) {
  return !row.parts.empty() && base_of(row.parts.front()).kind == GlyphKind::word;
}

/// True if a row ends like c \sin x: a factor after it would be read as part of the argument.
bool has_open_argument(const Glyphs& row) {
  return std::ranges::adjacent_find(row.parts, [](const Glyphs& head, const Glyphs& argument) {
           return base_of(head).kind == GlyphKind::function && argument.has_space_before;
         }) != row.parts.end();
}

/// Multiplies factors. A dot separates two factors that could be read as one.
TypesetRow multiply_rows(std::vector<TypesetRow> factors) {
  if (factors.size() == 1) return std::move(factors.front());
  // Calls come last, because factors after them could be read as part of the argument.
  std::stable_partition(factors.begin(), factors.end(),
                        [](const TypesetRow& x) { return !x.is_call; });
  const bool is_negation = factors.front().binding == Binding::negation;
  bool last_is_word = begins_with_word(factors.front().row);
  const bool is_open = !factors.front().is_call && has_open_argument(factors.front().row);
  Glyphs row =
      bracket_if_weaker(std::move(factors.front()), is_open ? Binding::power : Binding::negation);
  for (std::size_t i = 1; i < factors.size(); ++i) {
    const bool is_word = begins_with_word(factors[i].row);
    Glyphs next = bracket_if_weaker(std::move(factors[i]), Binding::power);
    const Glyphs& head = base_of(next.parts.front());
    if (last_is_word || begins_with_word(next) || head.kind == GlyphKind::number) {
      append_sign(row, "⋅", true);
    }
    append(row, std::move(next), true);
    last_is_word = is_word;
  }
  return {std::move(row), is_negation ? Binding::negation : Binding::product};
}

/// True if a factor is 1/x^n, which is set as a divisor x^n.
bool is_reciprocal(const Formula& factor) {
  if (factor.kind != FormulaKind::power) return false;
  const Formula& exponent = factor.parts[1];
  return exponent.kind == FormulaKind::number && cln::minusp(exponent.number) &&
         cln::denominator(exponent.number) == 1;
}

TypesetRow typeset_power(const Formula& base, TypesetRow exponent) {
  TypesetRow below = typeset_formula(base);
  if (below.is_call && below.row.parts.front().kind != GlyphKind::scripts) {
    Glyphs head = make_row(std::move(below.row.parts.front()));
    add_script(head, 2, std::move(exponent.row));
    below.row.parts.front() = std::move(head.parts.front());
    return {std::move(below.row), Binding::power, true};
  }
  const bool is_grouped = below.binding == Binding::atom && has_exponent(below.row);
  const bool is_long = base.kind == FormulaKind::symbol && base.symbol->is_long;
  Glyphs row = is_long ? add_brackets(std::move(below.row))
                       : bracket_if_weaker(std::move(below), Binding::atom);
  if (is_grouped) row = make_row(std::move(row));
  add_script(row, 2, std::move(exponent.row));
  return {std::move(row), Binding::power};
}

TypesetRow typeset_factor(const Formula& factor) {
  if (!is_reciprocal(factor)) return typeset_formula(factor);
  const cln::cl_RA exponent = -factor.parts[1].number;
  return exponent == 1 ? typeset_formula(factor.parts[0])
                       : typeset_power(factor.parts[0], typeset_number(exponent));
}

TypesetRow typeset_product(const Formulas& factors) {
  std::vector<TypesetRow> above;
  std::vector<TypesetRow> below;
  for (const Formula& factor : factors) {
    (is_reciprocal(factor) ? below : above).push_back(typeset_factor(factor));
  }
  if (above.empty()) above.push_back({digit_row("1")});
  TypesetRow numerator = multiply_rows(std::move(above));
  if (below.empty()) return numerator;
  return typeset_fraction(std::move(numerator.row), multiply_rows(std::move(below)).row);
}

/// Sets a quotient. If the first factor of the numerator is a fraction, the fraction precedes the
/// quotient: 3/4 g/l.
TypesetRow typeset_quotient(const Formula& formula) {
  const Formula& above = formula.parts[0];
  TypesetRow below = typeset_formula(formula.parts[1]);
  const bool has_fraction = above.kind == FormulaKind::product &&
                            above.parts[0].kind == FormulaKind::number &&
                            cln::denominator(above.parts[0].number) != 1;
  if (!has_fraction) return typeset_fraction(typeset_formula(above).row, std::move(below.row));
  TypesetRow rest = typeset_product({above.parts.begin() + 1, above.parts.end()});
  std::vector<TypesetRow> factors;
  factors.push_back(typeset_formula(above.parts[0]));
  factors.push_back(typeset_fraction(std::move(rest.row), std::move(below.row)));
  return multiply_rows(std::move(factors));
}

void append_item(Glyphs& list, const Formula& item) {
  if (!list.parts.empty()) append_sign(list, ",", false);
  append(list, typeset_formula(item).row, true);
}

Glyphs list_row(const Formulas& items) {
  Glyphs list;
  for (const Formula& item : items) append_item(list, item);
  return list;
}

TypesetRow typeset_root(Glyphs radicand) {
  return {make_row({GlyphKind::root, "", {std::move(radicand)}}), Binding::power};
}

TypesetRow join_call(Glyphs head, Glyphs argument, bool is_apart) {
  append(head, std::move(argument), is_apart);
  return {std::move(head), Binding::power, true};
}

/// The textbook forms of log1p(x), expm1(x) and hypot(x, y): log(1 + x), e^x - 1, and the root of a
/// sum of squares.
std::optional<Formula> expand_call(const Formula& call) {
  const Formula& x = call.parts.front();
  const Formula one = number_formula(1);
  if (call.function == FunctionId::log1p) return call_of(FunctionId::log, {sum_of({one, x})});
  if (call.function == FunctionId::expm1) {
    return sum_of({call_of(FunctionId::exp, {x}), negative_of(one)});
  }
  if (call.function != FunctionId::hypot) return std::nullopt;
  const Formula two = number_formula(2);
  return root_of(sum_of({power_of(x, two), power_of(call.parts.back(), two)}));
}

TypesetRow typeset_call(const Formula& formula) {
  if (const std::optional<Formula> other = expand_call(formula)) return typeset_formula(*other);
  const FunctionId function = formula.function;
  if (function == FunctionId::abs) return {enclose(list_row(formula.parts), "|", "|", true)};
  if (function == FunctionId::stumpff) {
    const std::string_view own = stumpff_name(formula.parts.back().number);
    if (!own.empty()) {
      return join_call(make_row({GlyphKind::word, std::string(own)}),
                       add_brackets(typeset_formula(formula.parts.front()).row), false);
    }
  }
  Glyphs head = read_latex(function_row(function).latex);
  TypesetRow first = typeset_formula(formula.parts.front());
  const bool is_alone = first.binding == Binding::atom && !first.is_call;
  const bool is_fraction = first.row.parts.front().kind == GlyphKind::fraction;
  const bool stands_free = function != FunctionId::sign && formula.parts.size() == 1 &&
                           (is_alone || (is_fraction && first.binding == Binding::power));
  if (stands_free) return join_call(std::move(head), std::move(first.row), true);
  Glyphs arguments = std::move(first.row);  // typeset once, as calls may be nested deeply
  if (formula.parts.size() > 1) append_item(arguments, formula.parts[1]);
  return join_call(std::move(head), add_brackets(std::move(arguments)), false);
}

/// Sets a row. Words next to formulas get blanks at their ends.
TypesetRow typeset_row(const Formula& formula) {
  Glyphs row;
  for (std::size_t i = 0; i < formula.parts.size(); ++i) {
    const Formula& part = formula.parts[i];
    if (part.kind != FormulaKind::prose) {
      append(row, typeset_formula(part).row, true);
      continue;
    }
    const bool is_behind = i > 0 && !follows_without_blank(part.text);
    const bool is_before = i + 1 < formula.parts.size();
    const std::string words = (is_behind ? " " : "") + part.text + (is_before ? " " : "");
    append(row, {GlyphKind::prose, words}, true);
  }
  return {std::move(row), Binding::sum};
}

TypesetRow typeset_relation(const Formula& formula) {
  Glyphs row = typeset_formula(formula.parts[0]).row;
  append_sign(row, formula.text, true);
  append(row, typeset_formula(formula.parts[1]).row, true);
  return {std::move(row), Binding::sum};
}

TypesetRow typeset_either(TypesetRow x) {
  Glyphs row = make_row({GlyphKind::letter, "±"});
  append(row, bracket_if_weaker(std::move(x), Binding::product), true);
  return {std::move(row), Binding::negation};
}

TypesetRow typeset_formula(const Formula& formula) {
  const Formulas& parts = formula.parts;
  switch (formula.kind) {
    case FormulaKind::number:
      return formula.text.empty() ? typeset_number(formula.number) : typeset_digits(formula.text);
    case FormulaKind::symbol:
      return {formula.symbol->glyphs};
    case FormulaKind::negative:
      return negate_row(typeset_formula(parts[0]));
    case FormulaKind::plus_minus:
      return typeset_either(typeset_formula(parts[0]));
    case FormulaKind::sum:
      return typeset_sum(formula);
    case FormulaKind::product:
      return typeset_product(parts);
    case FormulaKind::quotient:
      return typeset_quotient(formula);
    case FormulaKind::power:
      return is_reciprocal(formula) ? typeset_product({formula})
                                    : typeset_power(parts[0], typeset_formula(parts[1]));
    case FormulaKind::root:
      return typeset_root(typeset_formula(parts[0]).row);
    case FormulaKind::call:
      return typeset_call(formula);
    case FormulaKind::absolute_value:
      return {enclose(typeset_formula(parts[0]).row, "|", "|", true)};
    case FormulaKind::group:
      return {bracket_if_weaker(typeset_formula(parts[0]), Binding::power), Binding::power};
    case FormulaKind::relation:
      return typeset_relation(formula);
    case FormulaKind::list:
      return {list_row(parts), Binding::sum};
    case FormulaKind::tuple:
      return {enclose(list_row(parts), "(", ")", false)};
    case FormulaKind::prose:
      return {make_row({GlyphKind::prose, formula.text}), Binding::sum};
    case FormulaKind::row:
      return typeset_row(formula);
  }
  return {};
}

}  // namespace

Glyphs glyphs_of(const Formula& formula) { return typeset_formula(formula).row; }

}  // namespace elgen
