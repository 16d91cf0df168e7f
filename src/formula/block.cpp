// block: joins and pads blocks of text. All lines of a block have the same width.
#include <algorithm>
#include <array>

#include "base/utf8.hpp"
#include "formula/drawing.hpp"

namespace elgen {
namespace {

constexpr std::size_t cell_gap = 3;

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
TextBlock pad_lines(const TextBlock& block, std::size_t above, std::size_t below) {
  const std::string blank = blanks(block.width());
  TextBlock result{std::vector<std::string>(above - block.base, blank), above};
  result.lines.insert(result.lines.end(), block.lines.begin(), block.lines.end());
  result.lines.insert(result.lines.end(), below - block.lines_below(), blank);
  return result;
}

TextBlock pad_columns(TextBlock block, std::size_t width, Alignment alignment = Alignment::centre) {
  const std::size_t missing = width - block.width();
  const std::size_t before = alignment == Alignment::centre ? missing / 2 : 0;
  for (std::string& line : block.lines) {
    line.insert(0, before, ' ');
    line.append(missing - before, ' ');
  }
  return block;
}

}  // namespace

std::size_t terminal_width(std::string_view text) {
  std::size_t columns = 0;
  for (std::size_t at = 0; at < text.size();) {
    const CodePoint point = code_point_at(text, at);
    const bool combines = point.value >= 0x300 && point.value < 0x370;
    if (!combines) ++columns;
    at += std::max<std::size_t>(1, point.bytes);
  }
  return columns;
}

TextBlock join_blocks(const TextBlock& left, const TextBlock& right) {
  const std::size_t above = std::max(left.base, right.base);
  const std::size_t below = std::max(left.lines_below(), right.lines_below());
  TextBlock result = pad_lines(left, above, below);
  const TextBlock other = pad_lines(right, above, below);
  for (std::size_t i = 0; i < result.lines.size(); ++i) result.lines[i] += other.lines[i];
  return result;
}

TextBlock stack_blocks(const TextBlock& above, const TextBlock& below, const std::string& rule) {
  const std::size_t width = std::max(above.width(), below.width());
  TextBlock result = pad_columns(above, width);
  result.base = result.lines.size();
  std::string line;
  for (std::size_t i = 0; i < width; ++i) line += rule;
  result.lines.push_back(line);
  const TextBlock under = pad_columns(below, width);
  result.lines.insert(result.lines.end(), under.lines.begin(), under.lines.end());
  return result;
}

TextBlock draw_bracket(std::string_view bracket, const TextBlock& inside, Alphabet alphabet) {
  const auto row = std::ranges::find(bracket_rows, bracket, &BracketRow::bracket);
  if (row == bracket_rows.end()) return {};
  const BracketPieces& pieces = alphabet == Alphabet::unicode ? row->unicode : row->ascii;
  const std::size_t height = inside.lines.size();
  if (height == 1) return {{std::string(pieces.single)}, 0};
  TextBlock result{std::vector<std::string>(height, std::string(pieces.middle)), inside.base};
  result.lines.front() = pieces.top;
  result.lines.back() = pieces.bottom;
  return result;
}

TextBlock draw_grid(const std::vector<TextBlock>& cells, std::size_t columns, Alignment alignment) {
  std::vector<std::size_t> widths(columns, 0);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    widths[i % columns] = std::max(widths[i % columns], cells[i].width());
  }
  const bool is_tall =
      std::ranges::any_of(cells, [](const TextBlock& b) { return b.lines.size() > 1; });
  TextBlock result{{}, 0};
  for (std::size_t first = 0; first < cells.size(); first += columns) {
    TextBlock row;
    for (std::size_t j = 0; j < columns; ++j) {
      if (j > 0) row = join_blocks(row, {{blanks(cell_gap)}, 0});
      row = join_blocks(row, pad_columns(cells[first + j], widths[j], alignment));
    }
    if (is_tall && first > 0) result.lines.push_back(blanks(row.width()));
    result.lines.insert(result.lines.end(), row.lines.begin(), row.lines.end());
  }
  result.base = (result.lines.size() - 1) / 2;
  return result;
}

std::string text_of(const TextBlock& block, std::string_view indent) {
  std::string text;
  for (const std::string& line : block.lines) {
    const std::string whole = std::string(indent) + line;
    text += whole.substr(0, whole.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

TextBlock draw_matrix(const std::vector<TextBlock>& entries, std::size_t columns,
                      Alphabet alphabet) {
  const TextBlock space{{" "}, 0};
  const TextBlock inside = join_blocks(join_blocks(space, draw_grid(entries, columns)), space);
  return join_blocks(join_blocks(draw_bracket("[", inside, alphabet), inside),
                     draw_bracket("]", inside, alphabet));
}

}  // namespace elgen
