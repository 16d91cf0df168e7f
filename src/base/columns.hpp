// columns: rows of cells as lines.
//
//     {"a", " 1"}, {"bcd", " 2"}     ->     "a   1", "bcd 2"
#pragma once

#include <string>
#include <vector>

namespace elgen {

/// Rows of cells, each column as wide as its widest cell; the last cell of a row is as wide as it
/// is.
[[nodiscard]] std::vector<std::string> aligned(const std::vector<std::vector<std::string>>& rows);

}  // namespace elgen
