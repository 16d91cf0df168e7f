// A table as text, with a star at rows of the Pareto front; as JSON; and as CSV. All three formats
// mark the picked row.
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "base/json.hpp"
#include "base/text_table.hpp"
#include "elgen/tradeoff.hpp"

namespace elgen {
namespace {

using Cells = std::vector<std::string>;
Cells column_titles(const TradeoffTable& table) {
  Cells titles{"rank"};
  titles.insert(titles.end(), table.dimensions.begin(), table.dimensions.end());
  titles.push_back(table.cost);
  titles.emplace_back("noise");
  if (!table.call_cost.empty()) titles.push_back(table.call_cost);
  titles.emplace_back("worst error");
  titles.emplace_back("median error");
  return titles;
}

/// "1.0e-05", or "below 1.0e-15" if the reference does not show the error.
std::string worst_error_text(const TradeoffRow& row) {
  return fmt::format("{}{:.1e}", row.is_below_reference ? "below " : "", row.error.worst);
}

Cells cells_of(const TradeoffTable& table, const TradeoffRow& row) {
  Cells cells{row.rank > 0 ? std::to_string(row.rank) : ""};
  cells.insert(cells.end(), row.values.begin(), row.values.end());
  if (!row.failure.empty()) {
    cells.push_back(row.failure);
    return cells;
  }
  cells.push_back(fmt::format("{:.4g}", row.cost.least));
  cells.push_back(fmt::format("{:.1f} %", 100 * row.cost.noise));
  if (!table.call_cost.empty()) cells.push_back(fmt::format("{:.4g}", row.call_cost.least));
  cells.push_back(worst_error_text(row));
  if (!row.is_below_reference) cells.push_back(fmt::format("{:.1e}", row.error.median));
  return cells;
}

/// The line about the picked row; "" if no row is picked.
std::string pick_line(const TradeoffTable& table) {
  const TradeoffRow* const row = picked_row(table);
  if (row == nullptr) return "";
  std::string cost = fmt::format("{:.4g} {}", row->cost.least, table.cost);
  if (!table.call_cost.empty()) {
    cost += fmt::format(", {:.4g} {}", row->call_cost.least, table.call_cost);
  }
  return fmt::format("cheapest within {}: {}; {}, error {}\n", *table.max_error, name_of(*row),
                     cost, worst_error_text(*row));
}

Json json_of(const MeasuredCost& cost) { return {{"least", cost.least}, {"noise", cost.noise}}; }

/// null for infinity and NaN, which JSON lacks.
Json json_number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json json_of(const TradeoffTable& table, const TradeoffRow& row) {
  Json values = Json::object();
  for (std::size_t i = 0; i < row.values.size(); ++i) values[table.dimensions[i]] = row.values[i];
  Json json{{"design", std::move(values)}};
  if (!row.failure.empty()) {
    json["failure"] = row.failure;
    return json;
  }
  json["rank"] = row.rank;
  json["cost"] = json_of(row.cost);
  if (!table.call_cost.empty()) json["call_cost"] = json_of(row.call_cost);
  json["error"] = {{"worst", json_number(row.error.worst)},
                   {"median", json_number(row.error.median)},
                   {"least", json_number(row.error.least)}};
  if (row.is_below_reference) json["error"]["below_reference"] = true;
  json["front"] = row.is_on_pareto_front;
  return json;
}

/// The text, in quotes if it contains a comma, a quote or a line end.
std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

}  // namespace

std::string to_text(const TradeoffTable& table) {
  std::vector<Cells> rows{column_titles(table)};
  for (const TradeoffRow& row : table.rows) rows.push_back(cells_of(table, row));
  std::string text = fmt::format("{}, {}: {}\n\n", table.model, table.subject, table.error);
  std::vector<std::string> lines = table_lines(rows, {{}});
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    if (table.rows[i].is_on_pareto_front) lines[i + 1].front() = '*';
  }
  text += fmt::format("{}\n", fmt::join(lines, "\n"));
  text += fmt::format(
      "\na time is the least of many rounds; its noise is the relative difference of the least "
      "times "
      "of even and odd rounds\n"
      "designs of one rank cost the same: at most {0} times the cheapest of the rank, or within "
      "its noise\n"
      "*: more accurate than every * above, by a factor of {0} and beyond the noise of both\n",
      equality_factor);
  for (const std::string& sentence : table.sentences) text += sentence + '\n';
  return text +
         fmt::format("measured on {}, {}\n", table.machine.processor, table.machine.compiler) +
         pick_line(table);
}

std::string to_json(const TradeoffTable& table) {
  Json rows = Json::array();
  for (const TradeoffRow& row : table.rows) rows.push_back(json_of(table, row));
  Json json{{"model", table.model},
            {"subject", table.subject},
            {"cost", table.cost},
            {"error", table.error},
            {"compiler", table.machine.compiler},
            {"processor", table.machine.processor},
            {"c_library", table.machine.c_library},
            {"designs", std::move(rows)},
            {"sentences", table.sentences}};
  if (!table.call_cost.empty()) json["call_cost"] = table.call_cost;
  if (table.max_error) {
    const TradeoffRow* const row = picked_row(table);
    json["max_error"] = *table.max_error;
    json["pick"] = row == nullptr ? Json(nullptr) : json_of(table, *row);
  }
  return json.dump(1) + "\n";
}

std::string to_csv(const TradeoffTable& table) {
  std::string text;
  for (const std::string& dimension : table.dimensions) text += csv_cell(dimension) + ",";
  text +=
      "rank,cost,cost_noise,call_cost,worst_error,median_error,least_error,front,pick,failure\n";
  for (const TradeoffRow& row : table.rows) {
    const auto& [cost, noise] = row.cost;
    const double call = row.call_cost.least;
    for (const std::string& value : row.values) text += csv_cell(value) + ",";
    text += row.failure.empty() ? fmt::format("{},{},{},{},{},{},{},{:d},{:d},\n", row.rank, cost,
                                              noise, call > 0 ? fmt::format("{}", call) : "",
                                              row.error.worst, row.error.median, row.error.least,
                                              row.is_on_pareto_front, &row == picked_row(table))
                                : fmt::format(",,,,,,,0,0,{}\n", csv_cell(row.failure));
  }
  return text;
}

}  // namespace elgen
