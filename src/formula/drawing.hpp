// drawing: glyphs -> a Block, in Unicode or in ASCII: text in two dimensions, on a base line, as a
// terminal shows a formula.
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

/// Columns of a terminal that UTF-8 text takes: accents that combine take none.
[[nodiscard]] std::size_t columns_of(std::string_view text);

/// Lines of equal width, of which number `base` goes on in what stands beside them.
struct Block {
  std::vector<std::string> lines = {""};
  std::size_t base = 0;

  [[nodiscard]] std::size_t width() const { return columns_of(lines.front()); }
  [[nodiscard]] std::size_t below() const { return lines.size() - base - 1; }
};

/// Side by side, on one base line.
[[nodiscard]] Block beside(const Block& left, const Block& right);

/// Centred, with a line between them, which is the base.
[[nodiscard]] Block stacked(const Block& above, const Block& below, const std::string& rule);

/// A bracket as high as the block.
[[nodiscard]] Block bracket_drawing(std::string_view bracket, const Block& inside,
                                    Alphabet alphabet);

enum class Alignment : unsigned char { centre, left };

/// Cells, row-major: rows share base lines; without brackets.
[[nodiscard]] Block grid(const std::vector<Block>& cells, std::size_t columns,
                         Alignment alignment = Alignment::centre);

/// The lines without blanks at their ends, each after `indent`.
[[nodiscard]] std::string text_of(const Block& block, std::string_view indent);

enum class Fractions : std::uint8_t { stacked, in_line };

[[nodiscard]] Block drawing(const Glyphs& glyphs, Alphabet alphabet,
                            Fractions fractions = Fractions::stacked);

/// "2" -> "²"; "1/2", which has no small characters, "^(1/2)".
[[nodiscard]] std::string small_exponent(const std::string& exponent);

/// Square brackets around a grid.
[[nodiscard]] Block matrix_drawing(const std::vector<Block>& entries, std::size_t columns,
                                   Alphabet alphabet);

}  // namespace elgen
