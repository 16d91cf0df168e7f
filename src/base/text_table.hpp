// text_table: rows of cells as lines of text, in columns that are as wide as their widest cell.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace elgen {

struct TextColumn {
  bool is_right = false;   ///< cells end in one place
  std::size_t least = 0;   ///< width
  std::size_t before = 2;  ///< blanks in front of it
};

using TextRows = std::vector<std::vector<std::string>>;

/// A line for each row, without blanks at its end. Cells behind the last column have its style.
/// The last cell of a row needs no room in its column, unless that is right-aligned.
[[nodiscard]] std::vector<std::string> table_lines(const TextRows& rows,
                                                   const std::vector<TextColumn>& columns);

}  // namespace elgen
