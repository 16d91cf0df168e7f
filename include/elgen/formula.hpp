// Formula: a formula as a tree, which is printed as text of the model language, on a screen, in
// LaTeX and in MathML.
//
//     sum(product(m, power(l, 2)), negative(u))     m*l^2 - u      m l^{2} - u
//
// The tree has the order of terms and factors. Its printers place brackets, write a fraction on one
// line or on two, and put functions behind the other factors where factors stand side by side.
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

/// The characters that a terminal can show.
enum class Alphabet : std::uint8_t {
  unicode,  ///< θ̇₁², √, ½
  ascii     ///< dot(theta1)^2, sqrt, 1/2
};

enum class FormulaKind : std::uint8_t {
  number,    ///< number, or the decimal digits of text, where number is 0
  symbol,    ///< symbol
  negative,  ///< -x; subtracted where it is a term of a sum
  either,    ///< +-x
  sum,       ///< x + y
  product,   ///< x y
  quotient,  ///< x/y
  power,     ///< x^y
  root,      ///< sqrt(x)
  call,      ///< function(x, y)
  bars,      ///< |x|
  group,     ///< (x), where x is a sum or a product: brackets that were typed
  relation,  ///< x = y, where text is the sign
  list,      ///< x, y
  tuple,     ///< (x, y)
  prose,     ///< text: words
  row,       ///< formulas and prose side by side, a blank between them
};

struct Symbol;

/// Parts are moved into trees: see the functions below.
struct Formula {
  FormulaKind kind = FormulaKind::row;
  std::vector<Formula> parts = {};
  std::string text = {};
  cln::cl_RA number = 0;
  FunctionId function = {};
  std::shared_ptr<const Symbol> symbol = {};

  /// A row of nothing: the cell of a table that has no content.
  [[nodiscard]] bool is_empty() const { return kind == FormulaKind::row && parts.empty(); }
};

using Formulas = std::vector<Formula>;

[[nodiscard]] Formula number_formula(const cln::cl_RA& value);
/// Decimal digits, perhaps with an exponent: "1.5e-07".
[[nodiscard]] Formula digits_formula(std::string digits);

/// A name of the model language. Formulas of it have no other notation.
[[nodiscard]] Formula name_formula(std::string name);
/// A symbol with its name. Where `is_long`, it has brackets in powers: V'(r).
[[nodiscard]] Formula symbol_formula(std::string name, Glyphs glyphs, bool is_long = false);
/// A formula that tables have in LaTeX. As text it is drawn on one line in ASCII.
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
/// Parts that are empty are left out; one part stands for itself.
[[nodiscard]] Formula row_of(Formulas parts);
/// "x", "x and y", "x, y and z"
[[nodiscard]] Formula enumeration(Formulas items);

/// In the model language, with as few brackets as keep the tree. Prose is as it is.
[[nodiscard]] std::string text_of(const Formula& formula);
[[nodiscard]] std::vector<std::string> texts_of(const Formulas& formulas);

/// As it is set. Equal trees give equal glyphs.
[[nodiscard]] Glyphs glyphs_of(const Formula& formula);

}  // namespace elgen
