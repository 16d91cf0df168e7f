// formula: builds trees. A sum, product, list or row with a single part is that part.
#include "elgen/formula.hpp"

#include <utility>

#include "formula/drawing.hpp"
#include "formula/glyphs.hpp"

namespace elgen {
namespace {

Formula make_formula(FormulaKind kind, Formulas parts) { return {kind, std::move(parts)}; }

template <class... Parts>
Formula make_node(FormulaKind kind, Parts... parts) {
  Formula formula{kind};
  (formula.parts.push_back(std::move(parts)), ...);
  return formula;
}

Formula wrap_unless_single(FormulaKind kind, Formulas parts) {
  if (parts.size() == 1) return std::move(parts.front());
  return make_formula(kind, std::move(parts));
}

/// Appends a part. Nested rows are flattened, and adjacent words are joined.
void append_part(Formulas& row, Formula part) {
  if (part.kind == FormulaKind::row) {
    for (Formula& inner : part.parts) append_part(row, std::move(inner));
  } else if (part.kind != FormulaKind::prose) {
    row.push_back(std::move(part));
  } else if (row.empty() || row.back().kind != FormulaKind::prose) {
    if (!part.text.empty()) row.push_back(std::move(part));
  } else if (!part.text.empty()) {
    row.back().text += (follows_without_blank(part.text) ? "" : " ") + part.text;
  }
}

/// x, except that a number -n becomes the negation of the number n, so that a sum subtracts n.
Formula extract_sign(Formula x) {
  const bool is_below = x.kind == FormulaKind::number && cln::minusp(x.number);
  if (is_below) return negative_of(number_formula(-x.number));
  return x;
}

}  // namespace

bool follows_without_blank(std::string_view words) { return words.find_first_of(";:,") == 0; }

Formula number_formula(const cln::cl_RA& value) {
  Formula formula{FormulaKind::number};
  formula.number = value;
  return formula;
}

Formula digits_formula(std::string digits) {
  if (digits.starts_with('-')) return negative_of(digits_formula(digits.substr(1)));
  return {FormulaKind::number, {}, std::move(digits)};
}

Formula name_formula(std::string name) { return symbol_formula(std::move(name), {}); }

Formula symbol_formula(std::string name, Glyphs glyphs, bool is_long) {
  Formula formula{FormulaKind::symbol};
  formula.symbol =
      std::make_shared<const Symbol>(Symbol{std::move(name), std::move(glyphs), is_long});
  return formula;
}

Formula latex_formula(std::string_view latex) {
  Glyphs glyphs = read_latex(latex);
  const TextBlock drawn = draw_glyphs(glyphs, Alphabet::ascii, FractionStyle::in_line);
  return symbol_formula(drawn.lines[drawn.base], std::move(glyphs));
}

Formula pi_formula() { return symbol_formula("pi", read_latex("\\pi")); }

Formula negative_of(Formula x) { return make_node(FormulaKind::negative, std::move(x)); }

Formula sum_of(Formulas terms) {
  for (std::size_t i = 1; i < terms.size(); ++i) terms[i] = extract_sign(std::move(terms[i]));
  return wrap_unless_single(FormulaKind::sum, std::move(terms));
}

Formula with_term(Formula sum, Formula term) {
  if (sum.kind != FormulaKind::sum) return sum_of({std::move(sum), std::move(term)});
  sum.parts.push_back(extract_sign(std::move(term)));
  return sum;
}

Formula product_of(Formulas factors) {
  return wrap_unless_single(FormulaKind::product, std::move(factors));
}

Formula quotient_of(Formula above, Formula below) {
  return make_node(FormulaKind::quotient, std::move(above), std::move(below));
}

Formula power_of(Formula base, Formula exponent) {
  return make_node(FormulaKind::power, std::move(base), std::move(exponent));
}

Formula root_of(Formula radicand) { return make_node(FormulaKind::root, std::move(radicand)); }

Formula call_of(FunctionId function, Formulas arguments) {
  Formula formula = make_formula(FormulaKind::call, std::move(arguments));
  formula.function = function;
  return formula;
}

Formula plus_minus(Formula x) { return make_node(FormulaKind::plus_minus, std::move(x)); }

Formula absolute_value_of(Formula x) {
  return make_node(FormulaKind::absolute_value, std::move(x));
}

Formula group(Formula x) { return make_node(FormulaKind::group, std::move(x)); }

Formula relation(Formula left, Formula right, std::string sign) {
  Formula formula = make_node(FormulaKind::relation, std::move(left), std::move(right));
  formula.text = std::move(sign);
  return formula;
}

Formula list_of(Formulas items) { return wrap_unless_single(FormulaKind::list, std::move(items)); }

Formula tuple_of(Formulas items) { return make_formula(FormulaKind::tuple, std::move(items)); }

Formula prose(std::string words) { return {FormulaKind::prose, {}, std::move(words)}; }

Formula row_of(Formulas parts) {
  Formulas row;
  for (Formula& part : parts) append_part(row, std::move(part));
  return wrap_unless_single(FormulaKind::row, std::move(row));
}

Formula enumeration(Formulas items) {
  if (items.size() < 2) return list_of(std::move(items));
  Formula last = std::move(items.back());
  items.pop_back();
  return row_of({list_of(std::move(items)), prose("and"), std::move(last)});
}

}  // namespace elgen
