// latex: the LaTeX of our own formulas: where fractions, sums and prose stand in it, for what stays
// text, and read again as a LatexTree, to measure it and to translate it.
//
// Only what this folder writes and what a symbol of a model may reasonably be; anything else is a
// word.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace elgen {

/// Where the brace that opens at `open` closes; npos where it does not, or none opens there.
[[nodiscard]] std::size_t closing_brace(std::string_view latex, std::size_t open);

/// \frac{above}{below}, the characters [begin, end).
struct FractionPlace {
  std::size_t begin = 0;
  std::size_t end = 0;
  std::string above = {};
  std::string below = {};
};

/// Fractions outside of braces, from left to right.
[[nodiscard]] std::vector<FractionPlace> fractions(const std::string& latex);

/// Whether the text begins with a sign between terms and its blanks.
[[nodiscard]] bool separates_terms(std::string_view rest);

/// Whether a sign stands in front, or between terms outside of braces and brackets.
[[nodiscard]] bool is_sum(std::string_view latex);

/// Where the last factor of a product begins, if it stands in brackets; else 0.
[[nodiscard]] std::size_t last_bracket(std::string_view product);

/// A formula, or prose between formulas.
struct LatexPiece {
  bool is_prose = false;
  std::string text = {};
};

/// \text{…} outside of braces is prose; so is a comma in front of it.
[[nodiscard]] std::vector<LatexPiece> pieces(const std::string& latex);

/// The components of a vector are not bold: \mathbf{g} -> g, \mathbf{bias} -> \mathrm{bias}.
[[nodiscard]] std::string without_bold(std::string latex);

[[nodiscard]] std::string without_outer_blanks(std::string_view text);

[[nodiscard]] std::string replaced(std::string text, std::string_view from, std::string_view to);

enum class LatexKind : std::uint8_t {
  row,       ///< parts, side by side
  letter,    ///< x, \theta: text is the character
  word,      ///< \mathrm{cart}, and commands unknown
  bold,      ///< \mathbf{q}, \boldsymbol{\tau}: a vector
  text,      ///< \text{stable: }: prose inside of a formula, with its blanks
  function,  ///< \sin, \operatorname{sgn}
  number,    ///< 12, 9.81
  sign,      ///< + - = , \cdot
  bracket,   ///< ( ) [ ] |
  tall,      ///< the same after \left or \right; "" for `.`
  space,     ///< text is the width in em
  fraction,  ///< parts: above, below
  root,      ///< parts: radicand
  accent,    ///< parts: base; text is the dots
  scripts,   ///< parts: base, below, above; an absent one is an empty row
};

struct LatexTree {
  LatexKind kind = LatexKind::row;
  std::string text = {};
  std::vector<LatexTree> parts = {};
  bool is_apart = false;  ///< a blank stands in front of it: M (q) and d t are products, dt is not
};

/// A row. Brackets need not match: a formula may be broken inside of them.
[[nodiscard]] LatexTree read_latex(std::string_view latex);

/// About the number of letters that fit its width.
[[nodiscard]] double width(const LatexTree& tree);

/// MathML Core: the elements of a row, without a <math> around them.
[[nodiscard]] std::string mathml(const LatexTree& tree);

/// Text between the tags of XML and HTML.
[[nodiscard]] std::string xml_text(const std::string& text);

/// Breaks a long formula before its signs, at the outermost bracket that fits; `\left` and `\right`
/// are completed on both sides. Every line is at most about `widest` letters wide, if it can be.
[[nodiscard]] std::vector<std::string> latex_lines(const std::string& latex, double widest,
                                                   double (*measured)(const LatexTree&) = &width);

}  // namespace elgen
