// A table in columns, for people; rows of the front have a star.
#include <fmt/format.h>

#include <algorithm>

#include "elgen/tradeoff.hpp"

namespace elgen {
namespace {

using Cells = std::vector<std::string>;

Cells cells_of(const TradeoffRow& row) {
  Cells cells = row.values;
  if (!row.failure.empty()) {
    cells.push_back(row.failure);
    return cells;
  }
  cells.push_back(fmt::format("{:.4g}", row.cost.median));
  cells.push_back(fmt::format("{:.4g} to {:.4g}", row.cost.low, row.cost.high));
  cells.push_back(fmt::format("{:.1e}", row.error.worst));
  cells.push_back(fmt::format("{:.1e}", row.error.median));
  return cells;
}

/// A reason why there are no numbers needs no room in the columns after it.
std::vector<std::size_t> widths_of(const Cells& titles, const std::vector<Cells>& lines) {
  std::vector<std::size_t> widths;
  for (std::size_t i = 0; i < titles.size(); ++i) {
    std::size_t width = titles[i].size();
    for (const Cells& line : lines) {
      const bool is_reason = line.size() < titles.size() && i + 1 >= line.size();
      if (!is_reason) width = std::max(width, line[i].size());
    }
    widths.push_back(width);
  }
  return widths;
}

std::string line_of(const Cells& cells, const std::vector<std::size_t>& widths, char mark) {
  std::string text(1, mark);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    text += (i == 0 ? " " : "  ") + fmt::format("{:<{}}", cells[i], widths[i]);
  }
  return text.substr(0, text.find_last_not_of(' ') + 1) + '\n';
}

}  // namespace

std::string to_text(const TradeoffTable& table) {
  Cells titles = table.dimensions;
  for (const char* title : {"ns", "quartiles", "worst error", "median error"})
    titles.emplace_back(title);
  std::vector<Cells> lines;
  for (const TradeoffRow& row : table.rows) lines.push_back(cells_of(row));
  const std::vector<std::size_t> widths = widths_of(titles, lines);
  std::string text =
      fmt::format("{}, {}: {}; {}\n\n", table.model, table.subject, table.cost, table.error);
  text += line_of(titles, widths, ' ');
  for (std::size_t i = 0; i < lines.size(); ++i) {
    text += line_of(lines[i], widths, table.rows[i].is_on_front ? '*' : ' ');
  }
  text += '\n';
  for (const std::string& sentence : table.sentences) text += sentence + '\n';
  return text +
         fmt::format("measured on {}, {}\n", table.machine.processor, table.machine.compiler);
}

}  // namespace elgen
