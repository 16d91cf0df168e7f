// SPDX-License-Identifier: GPL-3.0-or-later
// The start of a run: assembled in 60 digits, and looked at once before the first step.
#include "simulate/start.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <utility>

#include "base/exact_number.hpp"
#include "elgen/oracle.hpp"

namespace elgen {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// The sine of the double nearest to pi is 1e-16.
constexpr double zero = 64 * epsilon;

constexpr const char* start_elsewhere = "`--state` starts the run elsewhere";

Diagnostic singular(std::string message) {
  return {Code::E623, {}, std::move(message), start_elsewhere};
}

}  // namespace

Result<CheckedModel> assembled_model(const CheckedModel& checked, double t) {
  CheckedModel moved = checked;
  if (moved.model.constraints.empty()) return moved;
  State start = start_state(moved.model, moved.scene);
  start.t = exact_value(t);
  const std::optional<State> state = oracle_assembled(moved.model, std::move(start));
  if (!state) {
    return Diagnostic{
        Code::E538, {}, "near the start no pose meets the constraints", start_elsewhere};
  }
  for (std::size_t i = 0; i < state->q.size(); ++i) {
    moved.model.coordinates[i].start_value = state->q[i];
  }
  for (std::size_t i = 0; i < state->v.size(); ++i) {
    moved.model.velocities[i].start_rate = state->v[i];
  }
  return moved;
}

Diagnostics refuse_start(System& system, const Numbers& state, double t) {
  const double* const q = state.data();
  const double* const v = system.v_of(state);
  const Model& model = system.model();
  for (const Coordinate& coordinate : model.coordinates) {
    if (!coordinate.singular) continue;
    if (std::abs(system.value(*coordinate.singular, q, v, t)) > zero) continue;
    const std::string_view factor = covered_text(model.expressions[*coordinate.singular].span);
    return {singular(fmt::format("the chart of `{}` breaks at the start, where `{}` is zero",
                                 coordinate.name, factor))};
  }
  Numbers a(system.velocities());
  system.acceleration(q, v, t, a.data());
  const std::span<const double> pivots = system.relative_pivots();
  for (std::size_t i = 0; i < pivots.size(); ++i) {
    const double pivot = pivots[i];
    if (std::abs(pivot) > static_cast<double>(pivots.size()) * epsilon) continue;
    const bool is_of_mass = i < a.size();
    const std::string name =
        is_of_mass ? leaf_text(system.leaves(), Opcode::velocity, static_cast<std::uint32_t>(i))
                   : model.constraints[i - a.size()].name;
    const std::string value = std::isfinite(pivot) ? fmt::format("{:.1e}", pivot) : "no number";
    return {singular(fmt::format("{} is singular at the start: the relative pivot of `{}` is {}",
                                 is_of_mass ? "M" : "A M^-1 A^T", name, value))};
  }
  return {};
}

}  // namespace elgen
