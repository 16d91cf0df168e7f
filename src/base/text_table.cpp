// text_table: computes the widths of all columns, then writes the lines.
#include "base/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace elgen {

std::vector<std::string> table_lines(const TextRows& rows, const std::vector<TextColumn>& columns) {
  const auto style = [&columns](std::size_t i) { return columns[std::min(i, columns.size() - 1)]; };
  std::vector<std::size_t> widths;
  for (const std::vector<std::string>& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (i == widths.size()) widths.push_back(style(i).min_width);
      const bool is_free = i + 1 == row.size() && !style(i).is_right_aligned;
      if (!is_free) widths[i] = std::max(widths[i], row[i].size());
    }
  }
  std::vector<std::string> lines;
  for (const std::vector<std::string>& row : rows) {
    std::string& line = lines.emplace_back();
    for (std::size_t i = 0; i < row.size(); ++i) {
      line.append(style(i).left_padding, ' ');
      line += style(i).is_right_aligned ? fmt::format("{:>{}}", row[i], widths[i])
                                        : fmt::format("{:<{}}", row[i], widths[i]);
    }
    line.erase(line.find_last_not_of(' ') + 1);
  }
  return lines;
}

}  // namespace elgen
