// glyphs: a typeset formula: pieces side by side, above and below each other. It is read from the
// LaTeX of tables and models, and printed as LaTeX, as MathML and on screens.
//
// Only the LaTeX commands of our tables and of likely symbols of models are known.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace elgen {

enum class GlyphKind : std::uint8_t {
  row,       ///< parts side by side
  letter,    ///< x, \theta; text is the character
  word,      ///< \mathrm{cart}
  command,   ///< an unknown command; text is its name
  bold,      ///< \mathbf{q}, \boldsymbol{\tau}: a vector
  prose,     ///< \text{ is stable}: words within a formula, with their blanks
  function,  ///< \sin, \operatorname{sgn}
  number,    ///< 12, 9.81
  sign,      ///< + - = , \cdot
  bracket,   ///< ( ) [ ] |
  left,      ///< a bracket after \left, as tall as the content; text is empty for `.`
  right,     ///< the bracket after \right
  space,     ///< text is the width in em
  fraction,  ///< parts: above, below
  root,      ///< parts: radicand
  accent,    ///< parts: base; text: the dots
  scripts,   ///< parts: base, subscript, superscript; a missing script is an empty row
};

struct Glyphs {
  GlyphKind kind = GlyphKind::row;
  std::string text = {};
  std::vector<Glyphs> parts = {};
  bool has_space_before = false;  ///< a blank precedes it: M (q) and d t are products, dt is not

  friend bool operator==(const Glyphs&, const Glyphs&) = default;
};

using GlyphRows = std::vector<Glyphs>;

/// Reads a row. Brackets need not match, because a formula may be broken inside them.
[[nodiscard]] Glyphs read_latex(std::string_view latex);
/// Writes LaTeX that read_latex() converts to the same glyphs.
[[nodiscard]] std::string to_latex(const Glyphs& glyphs);

/// MathML Core: the elements of a row without the enclosing <math>.
[[nodiscard]] std::string to_mathml(const Glyphs& glyphs);

/// Escapes text for XML and HTML.
[[nodiscard]] std::string escape_xml(const std::string& text);

/// The approximate width in letters.
[[nodiscard]] double width(const Glyphs& glyphs);

/// The character for the command of a Greek letter ("theta"); empty for other words.
[[nodiscard]] std::string_view greek_letter(std::string_view command);
/// The command of a Greek letter; empty for other characters.
[[nodiscard]] std::string_view greek_command(std::string_view letter);

[[nodiscard]] Glyphs make_row(Glyphs piece);
[[nodiscard]] Glyphs fraction_row(Glyphs above, Glyphs below);
/// `content` in brackets. If `grows`, blanks separate the content from the growing brackets.
[[nodiscard]] Glyphs enclose(Glyphs content, std::string_view open, std::string_view close,
                             bool grows);

/// The base of a piece with scripts; otherwise the piece itself.
[[nodiscard]] const Glyphs& base_of(const Glyphs& piece);

/// False if the sub- or superscript is missing.
[[nodiscard]] bool is_present(const Glyphs& script);

/// Adds a subscript (place 1) or superscript (place 2) to the last piece of the row.
void add_script(Glyphs& row, std::size_t place, Glyphs script);

/// Appends the pieces of a row; the first piece gets the given `has_space_before`.
void append(Glyphs& row, Glyphs pieces, bool has_space_before);
void append_sign(Glyphs& row, std::string_view sign, bool is_apart);

/// True for the signs +, -, +- and -+ between terms.
[[nodiscard]] bool is_term_sign(const Glyphs& piece);
/// 1 for an opening bracket, -1 for a closing bracket, otherwise 0.
[[nodiscard]] int bracket_depth_change(const Glyphs& piece);
/// True if the row begins with a minus, or if a sign separates terms outside brackets.
[[nodiscard]] bool is_sum_or_signed(const Glyphs& row);

/// A formula, or prose between formulas.
struct GlyphPiece {
  bool is_prose = false;
  std::string prose = {};
  Glyphs formula = {};
};
/// Splits a row at prose outside growing brackets. A comma before prose becomes a piece of prose.
[[nodiscard]] std::vector<GlyphPiece> split_at_prose(const Glyphs& row);

/// Replaces bold symbols of vectors by the symbols of their components: \mathbf{g} -> g,
/// \mathbf{bias} -> \mathrm{bias}.
[[nodiscard]] Glyphs remove_bold(Glyphs glyphs);

[[nodiscard]] std::string trim_blanks(std::string text);

/// Breaks a long row before its signs, inside as few brackets as possible. A break closes growing
/// brackets and opens these again. Lines are at most about `widest` letters wide, if possible.
[[nodiscard]] GlyphRows break_lines(const Glyphs& row, double widest,
                                    double (*measure)(const Glyphs&) = &width);

/// A name of the model language and its glyphs.
struct Symbol {
  std::string name = {};
  Glyphs glyphs = {};
  bool is_long = false;  ///< needs brackets in powers
};

/// True if `words` begin with punctuation, which follows without a blank.
[[nodiscard]] bool follows_without_blank(std::string_view words);

}  // namespace elgen
