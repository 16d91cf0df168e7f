// Rows with their numbers, to the last bit.
#include "cli/shards/tradeoff_shard.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace elgen::cli {

namespace {

/// JSON has no infinity; null is in its place.
Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

double number_from(const Json& json) {
  return json.is_null() ? std::numeric_limits<double>::infinity() : json.get<double>();
}

Json json_of(const TradeoffRow& row) {
  Json json{{"number", row.number}, {"values", row.values}};
  if (row.failure.empty()) {
    json["cost"] = {row.cost.median, row.cost.low, row.cost.high};
    json["error"] = {number(row.error.worst), number(row.error.median)};
  } else {
    json["failure"] = row.failure;
  }
  return json;
}

TradeoffRow row_from(const Json& json) {
  TradeoffRow row{.number = json.at("number"), .values = json.at("values")};
  if (json.contains("failure")) {
    row.failure = json.at("failure");
    return row;
  }
  const Json& cost = json.at("cost");
  row.cost = {cost.at(0), cost.at(1), cost.at(2)};
  const Json& error = json.at("error");
  row.error = {number_from(error.at(0)), number_from(error.at(1))};
  return row;
}

TradeoffTable table_from(const Json& json, const Machine& machine) {
  TradeoffTable table{.model = json.at("model"),
                      .subject = json.at("subject"),
                      .cost = json.at("cost"),
                      .error = json.at("error"),
                      .dimensions = json.at("dimensions"),
                      .sentences = json.at("sentences"),
                      .machine = machine};
  for (const Json& row : json.at("rows")) {
    table.rows.push_back(row_from(row));
    const bool is_row = table.rows.back().values.size() == table.dimensions.size();
    if (!is_row) throw std::invalid_argument("values");
  }
  return table;
}

TradeoffShard tradeoff_from(ShardHead head, const Json& json) {
  TradeoffShard shard{
      .head = std::move(head), .dimensions = json.at("dimensions"), .ranges = json.at("ranges")};
  if (!json.at("time").is_null()) shard.time = json.at("time").get<double>();
  shard.table = table_from(json.at("table"), shard.head.machine);
  const std::string time = shard.time ? fmt::format("{} s", *shard.time) : "";
  shard.head.compared = {
      {"subject", shard.table.subject},
      {"list of dimensions", fmt::format("{}", fmt::join(shard.dimensions, ", "))},
      {"list of ranges", fmt::format("{}", fmt::join(shard.ranges, ", "))},
      {"time of the runs", time},
      {"set of columns", fmt::format("{}", fmt::join(shard.table.dimensions, ", ")), false}};
  return shard;
}

}  // namespace

std::string to_json(const TradeoffShard& shard) {
  const TradeoffTable& table = shard.table;
  Json rows = Json::array();
  for (const TradeoffRow& row : table.rows) rows.push_back(json_of(row));
  Json json = json_of(shard.head);
  json["dimensions"] = shard.dimensions;
  json["ranges"] = shard.ranges;
  json["time"] = shard.time ? Json(*shard.time) : Json(nullptr);
  json["table"] = {
      {"model", table.model},        {"subject", table.subject},       {"cost", table.cost},
      {"error", table.error},        {"dimensions", table.dimensions}, {"rows", std::move(rows)},
      {"sentences", table.sentences}};
  return json.dump() + "\n";
}

Result<TradeoffShard> merged_tradeoff(const std::vector<std::string>& paths, const Limits& limits) {
  std::vector<ShardHead> heads;
  std::vector<TradeoffTable> parts;
  TradeoffShard merged;
  const Diagnostics unread =
      read_shards(paths, ShardJob::tradeoff, limits, [&](ShardHead head, const Json& json) {
        TradeoffShard shard = tradeoff_from(std::move(head), json);
        heads.push_back(shard.head);
        parts.push_back(shard.table);
        if (parts.size() == 1) merged = std::move(shard);
      });
  if (!unread.empty()) return unread;
  Diagnostics misfit = misfits(heads, limits, heads.front().machine);
  if (!misfit.empty()) return misfit;
  merged.table = joined(parts);
  return merged;
}

}  // namespace elgen::cli
