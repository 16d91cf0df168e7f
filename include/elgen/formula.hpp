// Formula: a formula as a tree, printed in the model language, on screens, as LaTeX and as MathML.
//
//     sum(product(m, power(l, 2)), negative(u))     m*l^2 - u      m l^{2} - u
//
// The tree keeps the order of terms and factors. Printers add brackets and write fractions on one
// line or two. In notations without a multiplication sign, they move functions behind the other
// factors.
#pragma once

#include <cln/rational.h>

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "elgen/functions.hpp"

namespace elgen {

struct Glyphs;

/// The characters that a terminal can display.
enum class Alphabet : std::uint8_t {
  unicode,  ///< θ̇₁², √, ½
  ascii     ///< dot(theta1)^2, sqrt, 1/2
};

enum class FormulaKind : std::uint8_t {
  number,          ///< the decimal digits in `text`, or the member `number` if `text` is empty
  symbol,          ///< the member `symbol`
  negative,        ///< -x; as a term of a sum it is subtracted
  plus_minus,      ///< +-x
  sum,             ///< x + y
  product,         ///< x y
  quotient,        ///< x/y
  power,           ///< x^y
  root,            ///< sqrt(x)
  call,            ///< function(x, y)
  absolute_value,  ///< |x|
  group,           ///< (x) of a sum or product x: brackets that the author typed
  relation,        ///< x = y; `text` is the relation sign
  list,            ///< x, y
  tuple,           ///< (x, y)
  prose,           ///< the words in `text`
  row,             ///< formulas and prose, separated by blanks
};

struct Symbol;

/// A node of the tree; the functions below build it.
struct Formula {
  FormulaKind kind = FormulaKind::row;
  std::vector<Formula> parts = {};
  std::string text = {};
  cln::cl_RA number = 0;
  FunctionId function = {};
  std::shared_ptr<const Symbol> symbol = {};

  /// True for a row without parts: an empty cell of a table.
  [[nodiscard]] bool is_empty() const { return kind == FormulaKind::row && parts.empty(); }
};

using Formulas = std::vector<Formula>;

[[nodiscard]] Formula number_formula(const cln::cl_RA& value);
/// The number with these decimal digits, with or without exponent: "1.5e-07".
[[nodiscard]] Formula digits_formula(std::string digits);

/// A symbol without glyphs: text_of() prints `name`, all other notations print nothing.
[[nodiscard]] Formula name_formula(std::string name);
/// A symbol: `name` in the model language, `glyphs` in all other notations. `is_long`: the symbol
/// needs brackets in powers, for example V'(r).
[[nodiscard]] Formula symbol_formula(std::string name, Glyphs glyphs, bool is_long = false);
/// A symbol with the glyphs of `latex`, which is in the subset of LaTeX that the tables of elgen
/// use. text_of() prints the symbol in ASCII on one line.
[[nodiscard]] Formula latex_formula(std::string_view latex);

[[nodiscard]] Formula pi_formula();

[[nodiscard]] Formula negative_of(Formula x);
/// The sum of the terms. Terms of kind `negative`, and negative numbers after the first term, are
/// printed as subtractions. A single term is returned unchanged.
[[nodiscard]] Formula sum_of(Formulas terms);
[[nodiscard]] Formula with_term(Formula sum, Formula term);
[[nodiscard]] Formula product_of(Formulas factors);
[[nodiscard]] Formula quotient_of(Formula above, Formula below);
[[nodiscard]] Formula power_of(Formula base, Formula exponent);
[[nodiscard]] Formula root_of(Formula radicand);
[[nodiscard]] Formula call_of(FunctionId function, Formulas arguments);
[[nodiscard]] Formula plus_minus(Formula x);
[[nodiscard]] Formula absolute_value_of(Formula x);
[[nodiscard]] Formula group(Formula x);
[[nodiscard]] Formula relation(Formula left, Formula right, std::string sign = "=");
[[nodiscard]] Formula list_of(Formulas items);
[[nodiscard]] Formula tuple_of(Formulas items);
[[nodiscard]] Formula prose(std::string words);
/// A row of the parts that are not empty. A single part is returned unchanged.
[[nodiscard]] Formula row_of(Formulas parts);
/// A row of the items with commas and "and": "x", "x and y", "x, y and z".
[[nodiscard]] Formula enumeration(Formulas items);

/// The formula in the model language, with the fewest brackets that preserve the tree. Prose is
/// unchanged.
[[nodiscard]] std::string text_of(const Formula& formula);
[[nodiscard]] std::vector<std::string> texts_of(const Formulas& formulas);

/// The typeset formula. Equal trees give equal glyphs.
[[nodiscard]] Glyphs glyphs_of(const Formula& formula);

}  // namespace elgen
