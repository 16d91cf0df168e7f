// read_state_log: the states in a log, such as the CSV table that simulate() writes.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <utility>

#include "elgen/leaf_names.hpp"
#include "elgen/syntax.hpp"
#include "elgen/tradeoff.hpp"
#include "elgen/wording.hpp"

namespace elgen {
namespace {

struct LogColumn {
  std::string name;
  Opcode kind;
  std::uint32_t number;
};

/// All leaves except parameters. Runs write E and multipliers too, which no function takes.
std::vector<LogColumn> possible_columns(const Model& model) {
  std::vector<LogColumn> columns;
  for (const LeafRow& row : leaf_table()) {
    if (row.owner == LeafOwner::parameters) continue;
    for (std::uint32_t i = 0; i < leaf_count(model, row.id); ++i) {
      columns.push_back({leaf_text(model, row.id, i), row.id, i});
    }
  }
  return columns;
}

Diagnostic log_error(const Span& span, std::string message, std::string hint = {}) {
  return {Code::E650, span, std::move(message), std::move(hint)};
}

Diagnostics read_names(const Span& line, const Model& model, StateLog& log) {
  Diagnostics errors;
  std::vector<LogColumn> unused = possible_columns(model);
  const std::vector<std::string> names = column_words(unused, &LogColumn::name);
  for (const Span& cell : split_at_commas(line)) {
    const std::string name = component_name(model, std::string(covered_text(cell)));
    const auto found = std::ranges::find(unused, name, &LogColumn::name);
    if (found == unused.end()) {
      const bool is_known = std::ranges::find(names, name) != names.end();
      errors.push_back(
          log_error(cell, (is_known ? "repeated column " : "unknown column ") + quote_text(name),
                    is_known ? "" : suggestion(name, names)));
      continue;
    }
    log.leaves.emplace_back(found->kind, found->number);
    unused.erase(found);
  }
  if (!errors.empty()) return errors;
  const LeafSet required = Opcode::coordinate | Opcode::velocity;
  for (const LogColumn& column : unused) {
    if (!required.has_any(column.kind)) continue;
    errors.push_back(log_error(line, "missing column " + quote_text(column.name)));
  }
  return errors;
}

Diagnostics read_row(const Span& line, StateLog& log) {
  const std::vector<Span> cells = split_at_commas(line);
  if (cells.size() != log.leaves.size()) {
    return {log_error(line, fmt::format("{}, but {}", count_text(cells.size(), "number"),
                                        count_text(log.leaves.size(), "column")))};
  }
  Diagnostics errors;
  std::vector<double>& row = log.rows.emplace_back();
  for (const Span& cell : cells) {
    const std::string text(covered_text(cell));
    char* stop = nullptr;
    row.push_back(std::strtod(text.c_str(), &stop));  // libc++ before 20 lacks from_chars
    const bool is_number = !text.empty() && stop == text.c_str() + text.size();
    if (is_number && std::isfinite(row.back())) continue;
    errors.push_back(log_error(cell, quote_text(text) + " is no finite number"));
  }
  return errors;
}

}  // namespace

Result<StateLog> read_state_log(const SourceText& source, const Model& model) {
  StateLog log;
  for (std::uint32_t line = 1; line <= source.line_starts.size(); ++line) {
    const std::string_view text = line_text(source, line);
    if (collapse_blanks(text).empty()) continue;
    const auto begin = static_cast<std::uint32_t>(text.data() - source.text.data());
    const Span span{&source, begin, begin + static_cast<std::uint32_t>(text.size())};
    Diagnostics errors = log.leaves.empty() ? read_names(span, model, log) : read_row(span, log);
    if (!errors.empty()) return errors;
  }
  if (log.rows.empty()) return log_error({&source, 0, 0}, "the log has no row of numbers");
  return log;
}

}  // namespace elgen
