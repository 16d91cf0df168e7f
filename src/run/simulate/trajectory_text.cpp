// A trajectory as a short text, as a CSV table, and as a JSON object that contains the table.
#include <fmt/ranges.h>

#include <algorithm>

#include "base/json.hpp"
#include "elgen/simulate.hpp"
#include "elgen/wording.hpp"

namespace elgen {
namespace {

std::string drift_line(std::string_view name, const Drift& drift) {
  return fmt::format("  {}: worst {:.3e}, secular {:+.1e}, relative to {} = {:.6g}\n", name,
                     drift.worst, drift.secular, drift.measure, drift.scale);
}

Json json_of(const Drift& drift) {
  return {{"name", drift.name},
          {"worst", drift.worst},
          {"secular", drift.secular},
          {"scale", drift.scale}};
}

/// The unit after a space, " m"; "" if there is no unit.
std::string unit_suffix(const std::string& unit) { return unit.empty() ? "" : " " + unit; }

std::string conserved_line(const ConservedDrift& quantity) {
  const std::string unit = unit_suffix(quantity.unit);
  return fmt::format("  {} = {:.10g}{} at the start, drift {:.3e}{}\n", quantity.text,
                     quantity.start, unit, quantity.drift, unit);
}

Json json_of(const ConservedDrift& quantity) {
  return {{"text", quantity.text},
          {"unit", quantity.unit},
          {"start", quantity.start},
          {"drift", quantity.drift}};
}

std::string start_corrections_line(const std::vector<StartCorrection>& moves) {
  std::vector<std::string> parts;
  for (const StartCorrection& move : moves) {
    parts.push_back(fmt::format("{} by {:+.3e}{}", move.name, move.change, unit_suffix(move.unit)));
  }
  return parts.empty()
             ? ""
             : fmt::format("  start projected onto the constraints: {}\n", fmt::join(parts, ", "));
}

std::string constraints_line(const ConstraintAccuracy& kept) {
  const std::string rate = fmt::format("{:.3e}{}", kept.largest.rate, unit_suffix(kept.rate_unit));
  if (!kept.unit) return fmt::format("  rates of the constraints: residual at most {}\n", rate);
  return fmt::format("  constraints: residual at most {:.3e}{}, of their rates {}\n",
                     kept.largest.position, unit_suffix(*kept.unit), rate);
}

Json json_of(const ConstraintAccuracy& kept) {
  Json object{
      {"rate", kept.largest.rate}, {"rate_unit", kept.rate_unit}, {"start_moved", Json::array()}};
  if (kept.unit) {
    object["position"] = kept.largest.position;
    object["unit"] = *kept.unit;
  }
  for (const auto& [name, unit, by] : kept.start) {
    object["start_moved"].push_back({{"name", name}, {"unit", unit}, {"by", by}});
  }
  return object;
}

}  // namespace

std::string to_text(const Trajectory& trajectory) {
  std::string text = fmt::format("{} by {}: {} steps to t = {:.10g}\n", trajectory.model,
                                 trajectory.method, trajectory.steps, trajectory.last.front());
  std::size_t width = 0;
  for (const auto& column : trajectory.columns) width = std::max(width, column.name.size());
  for (std::size_t i = 1; i < trajectory.columns.size(); ++i) {
    const TrajectoryColumn& column = trajectory.columns[i];
    text += fmt::format("  {:<{}} = {:.10g}{}\n", column.name, width, trajectory.last[i],
                        unit_suffix(column.unit));
  }
  text += drift_line(trajectory.energy.name, trajectory.energy);
  for (const Drift& momentum : trajectory.momenta) {
    text += drift_line(fmt::format("momentum of {}", momentum.name), momentum);
  }
  for (const ConservedDrift& quantity : trajectory.conserved) text += conserved_line(quantity);
  if (const auto& kept = trajectory.constraints) {
    text += start_corrections_line(kept->start) + constraints_line(*kept);
  }
  return text +
         fmt::format("  {:.0f} ns per step {}\n", trajectory.nanoseconds, trajectory.timed_code);
}

std::string to_csv(const Trajectory& trajectory) {
  const auto names = column_words(trajectory.columns, &TrajectoryColumn::name);
  std::string text = fmt::format("{}\n", fmt::join(names, ","));
  for (const auto& row : trajectory.rows) text += fmt::format("{}\n", fmt::join(row, ","));
  return text;
}

std::string to_json(const Trajectory& trajectory) {
  Json object{{"model", trajectory.model},
              {"method", trajectory.method},
              {"steps", trajectory.steps},
              {"nanoseconds_per_step", trajectory.nanoseconds},
              {"energy", json_of(trajectory.energy)},
              {"momenta", Json::array()},
              {"conserved", Json::array()},
              {"columns", Json::array()},
              {"rows", trajectory.rows}};
  for (const Drift& momentum : trajectory.momenta) object["momenta"].push_back(json_of(momentum));
  for (const ConservedDrift& each : trajectory.conserved)
    object["conserved"].push_back(json_of(each));
  if (trajectory.constraints) object["constraints"] = json_of(*trajectory.constraints);
  for (const TrajectoryColumn& column : trajectory.columns) {
    object["columns"].push_back({{"name", column.name}, {"unit", column.unit}});
  }
  return object.dump(1) + "\n";
}

}  // namespace elgen
