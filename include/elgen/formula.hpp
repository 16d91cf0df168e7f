// Formula: a formula as a tree, printed in the model language, on screens, as LaTeX and as MathML.
//
//     sum(product(m, power(l, 2)), negative(u))     m*l^2 - u      m l^{2} - u
//
// The tree keeps the order of terms and factors. Printers add brackets, write fractions on one line
// or two, and put functions after the other factors where factors stand side by side.
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

/// The characters that a terminal shows.
enum class Alphabet : std::uint8_t {
  unicode,  ///< θ̇₁², √, ½
  ascii     ///< dot(theta1)^2, sqrt, 1/2
};

enum class FormulaKind : std::uint8_t {
  number,    ///< number, or the decimal digits of text if number is 0
  symbol,    ///< symbol
  negative,  ///< -x; subtracted as a term of a sum
  either,    ///< +-x
  sum,       ///< x + y
  product,   ///< x y
  quotient,  ///< x/y
  power,     ///< x^y
  root,      ///< sqrt(x)
  call,      ///< function(x, y)
  bars,      ///< |x|
  group,     ///< (x) of a sum or product x: brackets that the author typed
  relation,  ///< x = y; text is the sign
  list,      ///< x, y
  tuple,     ///< (x, y)
  prose,     ///< text: words
  row,       ///< formulas and prose, separated by blanks
};

struct Symbol;

/// A node. Parts are moved into trees by the functions below.
struct Formula {
  FormulaKind kind = FormulaKind::row;
  std::vector<Formula> parts = {};
  std::string text = {};
  cln::cl_RA number = 0;
  FunctionId function = {};
  std::shared_ptr<const Symbol> symbol = {};

  /// Whether this is a row without parts: an empty cell of a table.
  [[nodiscard]] bool is_empty() const { return kind == FormulaKind::row && parts.empty(); }
};

using Formulas = std::vector<Formula>;

[[nodiscard]] Formula number_formula(const cln::cl_RA& value);
/// Decimal digits, with or without an exponent: "1.5e-07".
[[nodiscard]] Formula digits_formula(std::string digits);

/// A name of the model language, without another notation.
[[nodiscard]] Formula name_formula(std::string name);
/// A symbol with its name. `is_long`: it needs brackets in powers, as V'(r) does.
[[nodiscard]] Formula symbol_formula(std::string name, Glyphs glyphs, bool is_long = false);
/// A formula that tables have in LaTeX. Its text is an ASCII drawing on one line.
[[nodiscard]] Formula typed_formula(std::string_view latex);

[[nodiscard]] Formula pi_formula();

[[nodiscard]] Formula negative(Formula x);
/// The parts that are `negative` are subtracted, and numbers below 0 behind the first become such.
/// One term stands for itself.
[[nodiscard]] Formula sum_of(Formulas terms);
/// A sum with one more term.
[[nodiscard]] Formula with_term(Formula sum, Formula term);
[[nodiscard]] Formula product_of(Formulas factors);
[[nodiscard]] Formula quotient_of(Formula above, Formula below);
[[nodiscard]] Formula power_of(Formula base, Formula exponent);
[[nodiscard]] Formula root_of(Formula radicand);
[[nodiscard]] Formula call_of(FunctionId function, Formulas arguments);
[[nodiscard]] Formula either_sign(Formula x);
[[nodiscard]] Formula bars(Formula x);
[[nodiscard]] Formula group(Formula x);
[[nodiscard]] Formula relation(Formula left, Formula right, std::string sign = "=");
[[nodiscard]] Formula list_of(Formulas items);
[[nodiscard]] Formula tuple_of(Formulas items);
[[nodiscard]] Formula prose(std::string words);
/// Makes a row without its empty parts. A single part is returned as it is.
[[nodiscard]] Formula row_of(Formulas parts);
/// "x", "x and y", "x, y and z"
[[nodiscard]] Formula enumeration(Formulas items);

/// Prints in the model language with as few brackets as keep the tree. Prose is unchanged.
[[nodiscard]] std::string text_of(const Formula& formula);
[[nodiscard]] std::vector<std::string> texts_of(const Formulas& formulas);

/// Typesets a formula. Equal trees give equal glyphs.
[[nodiscard]] Glyphs glyphs_of(const Formula& formula);

}  // namespace elgen
