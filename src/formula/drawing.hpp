// drawing: converts glyphs to a TextBlock in Unicode or ASCII: two-dimensional text with a base
// line, for terminals.
//
//     1            ⎡ M + m    m l ⎤
//     ─ m l²   M = ⎢              ⎥
//     2            ⎣ m l     m l² ⎦
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "elgen/formula.hpp"
#include "formula/glyphs.hpp"

namespace elgen {

/// The number of terminal columns of UTF-8 text. Combining accents take no column.
[[nodiscard]] std::size_t terminal_width(std::string_view text);

/// Lines of equal width. `base` is the index of the base line; blocks in a row have level base
/// lines.
struct TextBlock {
  std::vector<std::string> lines = {""};
  std::size_t base = 0;

  [[nodiscard]] std::size_t width() const { return terminal_width(lines.front()); }
  [[nodiscard]] std::size_t lines_below() const { return lines.size() - base - 1; }
};

/// Places two blocks side by side, with their base lines level.
[[nodiscard]] TextBlock join_blocks(const TextBlock& left, const TextBlock& right);

/// Centres two blocks above and below a rule, which is the base line.
[[nodiscard]] TextBlock stack_blocks(const TextBlock& above, const TextBlock& below,
                                     const std::string& rule);

/// Draws a bracket as high as the block.
[[nodiscard]] TextBlock draw_bracket(std::string_view bracket, const TextBlock& inside,
                                     Alphabet alphabet);

enum class Alignment : unsigned char { centre, left };

/// Draws row-major cells without brackets. The cells of a row have level base lines.
[[nodiscard]] TextBlock draw_grid(const std::vector<TextBlock>& cells, std::size_t columns,
                                  Alignment alignment = Alignment::centre);

/// The lines without trailing blanks, each after `indent`.
[[nodiscard]] std::string text_of(const TextBlock& block, std::string_view indent);

enum class FractionStyle : std::uint8_t { stacked, in_line };

[[nodiscard]] TextBlock draw_glyphs(const Glyphs& glyphs, Alphabet alphabet,
                                    FractionStyle fractions = FractionStyle::stacked);

/// "²" from "2"; "^(1/2)" from "1/2", which has no small characters.
[[nodiscard]] std::string small_exponent(const std::string& exponent);

/// Draws square brackets around a grid.
[[nodiscard]] TextBlock draw_matrix(const std::vector<TextBlock>& entries, std::size_t columns,
                                    Alphabet alphabet);

}  // namespace elgen
