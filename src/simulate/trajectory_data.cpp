// A trajectory for programs: as a table, and as an object with the table in it.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "elgen/simulate.hpp"

namespace elgen {
namespace {

nlohmann::ordered_json json_of(const Drift& drift) {
  return {{"name", drift.name},
          {"worst", drift.worst},
          {"secular", drift.secular},
          {"scale", drift.scale}};
}

}  // namespace

std::string to_csv(const Trajectory& trajectory) {
  std::string text;
  for (const TrajectoryColumn& column : trajectory.columns) {
    text += (text.empty() ? "" : ",") + column.name;
  }
  text += '\n';
  for (const auto& row : trajectory.rows) text += fmt::format("{}\n", fmt::join(row, ","));
  return text;
}

std::string to_json(const Trajectory& trajectory) {
  nlohmann::ordered_json object{{"model", trajectory.model},
                                {"method", trajectory.method},
                                {"steps", trajectory.steps},
                                {"nanoseconds_per_step", trajectory.nanoseconds},
                                {"energy", json_of(trajectory.energy)},
                                {"momenta", nlohmann::ordered_json::array()},
                                {"columns", nlohmann::ordered_json::array()},
                                {"rows", trajectory.rows}};
  for (const Drift& momentum : trajectory.momenta) object["momenta"].push_back(json_of(momentum));
  for (const TrajectoryColumn& column : trajectory.columns) {
    object["columns"].push_back({{"name", column.name}, {"unit", column.unit}});
  }
  return object.dump(1) + "\n";
}

}  // namespace elgen
