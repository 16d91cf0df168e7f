// glyphs: a formula as it is set, in pieces that stand side by side, above and below each other;
// read from the LaTeX of tables and of models, and printed as LaTeX, as MathML and on screens.
//
// Only the commands of our tables and of what a symbol of a model may reasonably be are known.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace elgen {

enum class GlyphKind : std::uint8_t {
  row,       ///< parts, side by side
  letter,    ///< x, \theta: text is the character
  word,      ///< \mathrm{cart}
  command,   ///< a command that is not known: its name
  bold,      ///< \mathbf{q}, \boldsymbol{\tau}: a vector
  prose,     ///< \text{ is stable}: words inside of a formula, with their blanks
  function,  ///< \sin, \operatorname{sgn}
  number,    ///< 12, 9.81
  sign,      ///< + - = , \cdot
  bracket,   ///< ( ) [ ] |
  left,      ///< the same behind \left: it grows with the content; "" for `.`
  right,     ///< behind \right
  space,     ///< text is the width in em
  fraction,  ///< parts: above, below
  root,      ///< parts: radicand
  accent,    ///< parts: base; text is the dots
  scripts,   ///< parts: base, below, above; an absent one is an empty row
};

struct Glyphs {
  GlyphKind kind = GlyphKind::row;
  std::string text = {};
  std::vector<Glyphs> parts = {};
  bool is_apart = false;  ///< a blank stands in front of it: M (q) and d t are products, dt is not

  friend bool operator==(const Glyphs&, const Glyphs&) = default;
};

using GlyphRows = std::vector<Glyphs>;

/// A row. Brackets need not match: a formula may be broken inside of them.
[[nodiscard]] Glyphs read_latex(std::string_view latex);
/// The LaTeX that is read as these glyphs.
[[nodiscard]] std::string latex(const Glyphs& glyphs);

/// MathML Core: the elements of a row, without a <math> around them.
[[nodiscard]] std::string mathml(const Glyphs& glyphs);

/// Text between the tags of XML and HTML.
[[nodiscard]] std::string xml_text(const std::string& text);

/// About the number of letters that fit its width.
[[nodiscard]] double width(const Glyphs& glyphs);

/// The character of a Greek letter's command ("theta"); empty for other words.
[[nodiscard]] std::string_view greek_letter(std::string_view command);
/// The command of a Greek letter; empty for other characters.
[[nodiscard]] std::string_view greek_command(std::string_view letter);

[[nodiscard]] Glyphs row_with(Glyphs piece);
[[nodiscard]] Glyphs fraction_row(Glyphs above, Glyphs below);
/// Brackets that grow stand apart from their content.
[[nodiscard]] Glyphs enclosed(Glyphs content, std::string_view open, std::string_view close,
                              bool grows);

/// The base of scripts, or the piece itself.
[[nodiscard]] const Glyphs& base_of(const Glyphs& piece);

/// Whether scripts have this one.
[[nodiscard]] bool is_there(const Glyphs& script);

/// Puts a script below (place 1) or above (2) the last piece of the row.
void add_script(Glyphs& row, std::size_t place, Glyphs script);

/// Adds the pieces of a row, the first of them apart.
void append(Glyphs& row, Glyphs pieces, bool is_apart);
void append_sign(Glyphs& row, std::string_view sign, bool is_apart);

/// +, -, +- and -+ between terms.
[[nodiscard]] bool is_term_sign(const Glyphs& piece);
/// 1 where a bracket opens, -1 where one closes.
[[nodiscard]] int bracket_step(const Glyphs& piece);
/// Whether a sign stands in front, or between terms outside of brackets.
[[nodiscard]] bool is_sum(const Glyphs& row);

/// A formula, or prose between formulas.
struct GlyphPiece {
  bool is_prose = false;
  std::string prose = {};
  Glyphs formula = {};
};
/// Prose outside of growing brackets; a comma in front of it is prose, too.
[[nodiscard]] std::vector<GlyphPiece> pieces(const Glyphs& row);

/// The components of a vector are not bold: \mathbf{g} -> g, \mathbf{bias} -> \mathrm{bias}.
[[nodiscard]] Glyphs without_bold(Glyphs glyphs);

[[nodiscard]] std::string without_outer_blanks(std::string text);

/// Breaks a long row before its signs, at the outermost bracket that fits; growing brackets are
/// completed on both sides. Every line is at most about `widest` letters wide, if it can be.
[[nodiscard]] GlyphRows broken_lines(const Glyphs& row, double widest,
                                     double (*measured)(const Glyphs&) = &width);

/// A name of the model language and the glyphs that stand for it.
struct Symbol {
  std::string name = {};
  Glyphs glyphs = {};
  bool is_long = false;  ///< has brackets in powers
};

/// Whether no blank stands in front of the words, as they begin with a sign of punctuation.
[[nodiscard]] bool stands_close(std::string_view words);

}  // namespace elgen
