// text_table: rows of cells as lines of text, in columns that are as wide as their widest cell.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace elgen {

struct TextColumn {
  bool is_right_aligned = false;  ///< right-aligned
  std::size_t min_width = 0;      ///< minimal width
  std::size_t left_padding = 2;   ///< blanks before the column
};

using TextRows = std::vector<std::vector<std::string>>;

/// A line for each row, without trailing blanks. Cells beyond the last column have the style of the
/// last column. The last cell of a row does not widen its column, unless the column is
/// right-aligned.
[[nodiscard]] std::vector<std::string> table_lines(const TextRows& rows,
                                                   const std::vector<TextColumn>& columns);

}  // namespace elgen
