// Of each scalar the worst states, list by list.
#include "cli/shards/screening_shard.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace elgen::cli {

namespace {

Json json_of(const ScreenedStates& screened) {
  Json lists = Json::array();
  for (const std::vector<ScreenedFigure>& worst : screened.worst) {
    Json list = Json::array();
    for (const auto& [state, figure] : worst) list.push_back({state, figure});
    lists.push_back(std::move(list));
  }
  return {{"scalar", name_of(screened.scalar)},
          {"states", screened.states},
          {"worst", std::move(lists)}};
}

ScreenedStates screened_from(const Json& json) {
  ScreenedStates screened;
  const std::string scalar = json.at("scalar");
  const auto row = std::ranges::find(scalar_table, scalar, &ScalarRow::name);
  if (row == scalar_table.end()) throw std::invalid_argument("scalar");
  screened.scalar = row->kind;
  screened.states = json.at("states");
  for (const Json& list : json.at("worst")) {
    std::vector<ScreenedFigure>& worst = screened.worst.emplace_back();
    for (const Json& pair : list) worst.push_back({pair.at(0), pair.at(1)});
  }
  return screened;
}

/// "double 62 float 62": lists of either scalar.
std::string shape(const Screening& screening) {
  std::string text;
  for (const ScreenedStates& screened : screening) {
    text += fmt::format(" {} {}", name_of(screened.scalar), screened.worst.size());
  }
  return text;
}

ScreeningShard screening_from(ShardHead head, const Json& json) {
  ScreeningShard shard{std::move(head), json.at("samples"), json.at("seed"), {}};
  for (const Json& screened : json.at("screened")) {
    shard.screening.push_back(screened_from(screened));
  }
  shard.head.compared = {{"number of samples", std::to_string(shard.samples)},
                         {"seed", std::to_string(shard.seed)},
                         {"set of outputs", shape(shard.screening), false}};
  return shard;
}

}  // namespace

std::string to_json(const ScreeningShard& shard) {
  Json json = json_of(shard.head);
  json["samples"] = shard.samples;
  json["seed"] = shard.seed;
  Json& screened = json["screened"] = Json::array();
  for (const ScreenedStates& states : shard.screening) screened.push_back(json_of(states));
  return json.dump() + "\n";
}

Result<ScreeningShard> merged_screening(const std::vector<std::string>& paths,
                                        const Limits& limits) {
  std::vector<ShardHead> heads;
  std::vector<Screening> parts;
  ScreeningShard merged;
  const Diagnostics unread =
      read_shards(paths, ShardJob::verify, limits, [&](ShardHead head, const Json& json) {
        ScreeningShard shard = screening_from(std::move(head), json);
        heads.push_back(shard.head);
        parts.push_back(shard.screening);
        if (parts.size() == 1) merged = std::move(shard);
      });
  if (!unread.empty()) return unread;
  const Result<Machine> here = this_machine(limits);
  if (!here) return here.diagnostics;
  if (Diagnostics misfit = misfits(heads, limits, *here); !misfit.empty()) return misfit;
  merged.screening = joined(parts);
  return merged;
}

}  // namespace elgen::cli
