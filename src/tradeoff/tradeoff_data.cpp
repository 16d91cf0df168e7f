// A table for programs.
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "elgen/tradeoff.hpp"

namespace elgen {
namespace {

using Json = nlohmann::ordered_json;

/// JSON has no infinity; null says that there is no number.
Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json json_of(const TradeoffTable& table, const TradeoffRow& row) {
  Json values = Json::object();
  for (std::size_t i = 0; i < row.values.size(); ++i) values[table.dimensions[i]] = row.values[i];
  Json json{{"design", std::move(values)}};
  if (!row.failure.empty()) {
    json["failure"] = row.failure;
    return json;
  }
  json["cost"] = {{"median", row.cost.median}, {"low", row.cost.low}, {"high", row.cost.high}};
  json["error"] = {{"worst", number(row.error.worst)}, {"median", number(row.error.median)}};
  json["front"] = row.is_on_front;
  return json;
}

/// In quotes where it has a comma, a quote or a line end.
std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

}  // namespace

std::string to_json(const TradeoffTable& table) {
  Json rows = Json::array();
  for (const TradeoffRow& row : table.rows) rows.push_back(json_of(table, row));
  const Json json{{"model", table.model},
                  {"subject", table.subject},
                  {"cost", table.cost},
                  {"error", table.error},
                  {"compiler", table.machine.compiler},
                  {"processor", table.machine.processor},
                  {"c_library", table.machine.c_library},
                  {"designs", std::move(rows)},
                  {"sentences", table.sentences}};
  return json.dump(1) + "\n";
}

std::string to_csv(const TradeoffTable& table) {
  std::string text;
  for (const std::string& dimension : table.dimensions) text += csv_cell(dimension) + ",";
  text += "cost,cost_low,cost_high,worst_error,median_error,front,failure\n";
  for (const TradeoffRow& row : table.rows) {
    for (const std::string& value : row.values) text += csv_cell(value) + ",";
    text += row.failure.empty()
                ? fmt::format("{},{},{},{},{},{},\n", row.cost.median, row.cost.low, row.cost.high,
                              row.error.worst, row.error.median, row.is_on_front ? 1 : 0)
                : fmt::format(",,,,,0,{}\n", csv_cell(row.failure));
  }
  return text;
}

}  // namespace elgen
