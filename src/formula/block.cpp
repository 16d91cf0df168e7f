// Blocks: every line is padded with blanks to the width of the widest line.
#include <algorithm>
#include <array>

#include "base/utf8.hpp"
#include "formula/drawing.hpp"

namespace elgen {
namespace {

constexpr std::size_t between_cells = 3;

/// The pieces of a bracket of any height.
struct BracketPieces {
  std::string_view single;
  std::string_view top;
  std::string_view middle;
  std::string_view bottom;
};

struct BracketRow {
  std::string_view bracket;
  BracketPieces unicode;
  BracketPieces ascii;
};

constexpr std::array bracket_rows{BracketRow{"(", {"(", "⎛", "⎜", "⎝"}, {"(", "/", "|", "\\"}},
                                  BracketRow{")", {")", "⎞", "⎟", "⎠"}, {")", "\\", "|", "/"}},
                                  BracketRow{"[", {"[", "⎡", "⎢", "⎣"}, {"[", "[", "[", "["}},
                                  BracketRow{"]", {"]", "⎤", "⎥", "⎦"}, {"]", "]", "]", "]"}},
                                  BracketRow{"|", {"|", "│", "│", "│"}, {"|", "|", "|", "|"}}};

std::string blanks(std::size_t count) { return std::string(count, ' '); }

/// Adds blank lines so that `above` lines precede the base line and `below` lines follow it.
Block pad_lines(const Block& block, std::size_t above, std::size_t below) {
  const std::string blank = blanks(block.width());
  Block result{std::vector<std::string>(above - block.base, blank), above};
  result.lines.insert(result.lines.end(), block.lines.begin(), block.lines.end());
  result.lines.insert(result.lines.end(), below - block.below(), blank);
  return result;
}

Block pad_columns(Block block, std::size_t width, Alignment alignment = Alignment::centre) {
  const std::size_t missing = width - block.width();
  const std::size_t before = alignment == Alignment::centre ? missing / 2 : 0;
  for (std::string& line : block.lines) {
    line.insert(0, before, ' ');
    line.append(missing - before, ' ');
  }
  return block;
}

}  // namespace

std::size_t columns_of(std::string_view text) {
  std::size_t columns = 0;
  for (std::size_t at = 0; at < text.size();) {
    const CodePoint point = code_point_at(text, at);
    const bool combines = point.value >= 0x300 && point.value < 0x370;
    if (!combines) ++columns;
    at += std::max<std::size_t>(1, point.bytes);
  }
  return columns;
}

Block join_blocks(const Block& left, const Block& right) {
  const std::size_t above = std::max(left.base, right.base);
  const std::size_t below = std::max(left.below(), right.below());
  Block result = pad_lines(left, above, below);
  const Block other = pad_lines(right, above, below);
  for (std::size_t i = 0; i < result.lines.size(); ++i) result.lines[i] += other.lines[i];
  return result;
}

Block stacked(const Block& above, const Block& below, const std::string& rule) {
  const std::size_t width = std::max(above.width(), below.width());
  Block result = pad_columns(above, width);
  result.base = result.lines.size();
  std::string line;
  for (std::size_t i = 0; i < width; ++i) line += rule;
  result.lines.push_back(line);
  const Block under = pad_columns(below, width);
  result.lines.insert(result.lines.end(), under.lines.begin(), under.lines.end());
  return result;
}

Block bracket_drawing(std::string_view bracket, const Block& inside, Alphabet alphabet) {
  const auto row = std::ranges::find(bracket_rows, bracket, &BracketRow::bracket);
  if (row == bracket_rows.end()) return {};
  const BracketPieces& pieces = alphabet == Alphabet::unicode ? row->unicode : row->ascii;
  const std::size_t height = inside.lines.size();
  if (height == 1) return {{std::string(pieces.single)}, 0};
  Block result{std::vector<std::string>(height, std::string(pieces.middle)), inside.base};
  result.lines.front() = pieces.top;
  result.lines.back() = pieces.bottom;
  return result;
}

Block grid(const std::vector<Block>& cells, std::size_t columns, Alignment alignment) {
  std::vector<std::size_t> widths(columns, 0);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    widths[i % columns] = std::max(widths[i % columns], cells[i].width());
  }
  const bool is_tall =
      std::ranges::any_of(cells, [](const Block& b) { return b.lines.size() > 1; });
  Block result{{}, 0};
  for (std::size_t first = 0; first < cells.size(); first += columns) {
    Block row;
    for (std::size_t j = 0; j < columns; ++j) {
      if (j > 0) row = join_blocks(row, {{blanks(between_cells)}, 0});
      row = join_blocks(row, pad_columns(cells[first + j], widths[j], alignment));
    }
    if (is_tall && first > 0) result.lines.push_back(blanks(row.width()));
    result.lines.insert(result.lines.end(), row.lines.begin(), row.lines.end());
  }
  result.base = (result.lines.size() - 1) / 2;
  return result;
}

std::string text_of(const Block& block, std::string_view indent) {
  std::string text;
  for (const std::string& line : block.lines) {
    const std::string whole = std::string(indent) + line;
    text += whole.substr(0, whole.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

Block matrix_drawing(const std::vector<Block>& entries, std::size_t columns, Alphabet alphabet) {
  const Block space{{" "}, 0};
  const Block inside = join_blocks(join_blocks(space, grid(entries, columns)), space);
  return join_blocks(join_blocks(bracket_drawing("[", inside, alphabet), inside),
                     bracket_drawing("]", inside, alphabet));
}

}  // namespace elgen
