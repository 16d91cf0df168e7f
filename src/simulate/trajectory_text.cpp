// A trajectory in a few lines, for people.
#include <fmt/format.h>

#include <algorithm>

#include "elgen/simulate.hpp"

namespace elgen {
namespace {

std::string drift_line(std::string_view name, const Drift& drift) {
  return fmt::format("  {}: worst {:.3e}, secular {:+.1e}, relative to {} = {:.6g}\n", name,
                     drift.worst, drift.secular, drift.measure, drift.scale);
}

}  // namespace

std::string to_text(const Trajectory& trajectory) {
  std::string text = fmt::format("{} by {}: {} steps to t = {:.10g}\n", trajectory.model,
                                 trajectory.method, trajectory.steps, trajectory.last.front());
  std::size_t width = 0;
  for (const auto& column : trajectory.columns) width = std::max(width, column.name.size());
  for (std::size_t i = 1; i < trajectory.columns.size(); ++i) {
    const TrajectoryColumn& column = trajectory.columns[i];
    text += fmt::format("  {:<{}} = {:.10g}{}{}\n", column.name, width, trajectory.last[i],
                        column.unit.empty() ? "" : " ", column.unit);
  }
  text += drift_line(trajectory.energy.name, trajectory.energy);
  for (const Drift& momentum : trajectory.momenta) {
    text += drift_line(fmt::format("momentum of {}", momentum.name), momentum);
  }
  return text + fmt::format("  {:.0f} ns per step\n", trajectory.nanoseconds);
}

}  // namespace elgen
