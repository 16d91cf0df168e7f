// The start of a run: solves the constraints in 60 digits, and checks that the start is not
// singular.
#include "run/simulate/start.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <utility>

#include "elgen/inspect.hpp"
#include "elgen/oracle.hpp"

namespace elgen {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// Smaller values count as 0: the sine of the double nearest to pi is 1e-16.
constexpr double zero_tolerance = 64 * epsilon;

constexpr const char* start_elsewhere_hint = "`--state` starts the run elsewhere";

Diagnostic singular_start_error(std::string message) {
  return {Code::E623, {}, std::move(message), start_elsewhere_hint};
}

FixedVariables stated_variables(const Model& model, const StateOverrides& stated) {
  FixedVariables kept;
  for (const Velocity& velocity : model.velocities) {
    const std::string& coordinate = model.coordinates[velocity.coordinate].name;
    kept.positions.push_back(stated.coordinates.contains(coordinate));
    kept.rates.push_back(stated.velocities.contains(velocity.name));
  }
  return kept;
}

CheckedModel with_start(CheckedModel checked, const State& state) {
  for (std::size_t i = 0; i < state.q.size(); ++i) {
    checked.model.coordinates[i].start_value = state.q[i];
  }
  for (std::size_t i = 0; i < state.v.size(); ++i) {
    checked.model.velocities[i].start_rate = state.v[i];
  }
  return checked;
}

/// True if no value in `--state` changed visibly. A printed state satisfies the constraints except
/// in its last digits, so small changes are permitted.
bool keeps_stated_values(const Model& model, const StateOverrides& stated, const Model& moved) {
  const Numbers from = stated_start(model);
  const Numbers to = stated_start(moved);
  for (std::size_t i = 0; i < from.size(); ++i) {
    const std::size_t q = model.coordinates.size();
    const bool is_named = i < q ? stated.coordinates.contains(model.coordinates[i].name)
                                : stated.velocities.contains(model.velocities[i - q].name);
    if (is_named && is_visible_change(from[i], to[i])) return false;
  }
  return true;
}

}  // namespace

Result<CheckedModel> assemble_start(const CheckedModel& checked, const cln::cl_R& t) {
  const Model& model = checked.model;
  if (model.constraints.empty()) return checked;
  State start = start_state(model, checked.scene);
  start.t = t;
  const std::optional<Assembly> at =
      oracle_assembly(model, start, stated_variables(model, checked.scene.state_overrides));
  if (at && at->has_rates) return with_start(checked, at->state);
  const std::string quotient = at ? "" : quotient_hint(model, start);
  const std::optional<State> near = oracle_assembled_state(model, std::move(start));
  if (!near) {
    return Diagnostic{Code::E538,
                      {},
                      "no pose near the start meets the constraints",
                      quotient.empty() ? start_elsewhere_hint : quotient};
  }
  CheckedModel moved = with_start(checked, *near);
  if (keeps_stated_values(model, checked.scene.state_overrides, moved.model)) return moved;
  return Diagnostic{
      Code::E538,
      {},
      fmt::format("with the values of `--state`, no {} near the start meet the constraints: the "
                  "residual is {}",
                  at && at->has_pose ? "rates" : "coordinates",
                  at ? residual_text(model, *at) : "undefined"),
      "name fewer values, since the others are solved for, or give other values"};
}

Diagnostics check_singular_start(SimulatedSystem& system, const Numbers& state, double t) {
  const double* const q = state.data();
  const double* const v = system.v_of(state);
  const Model& model = system.model();
  for (const Coordinate& coordinate : model.coordinates) {
    if (!coordinate.singular_condition) continue;
    if (std::abs(system.value(*coordinate.singular_condition, q, v, t)) > zero_tolerance) continue;
    const std::string_view factor =
        covered_text(model.expressions[*coordinate.singular_condition].span);
    return {singular_start_error(fmt::format(
        "the chart of `{}` breaks at the start, where `{}` is zero", coordinate.name, factor))};
  }
  Numbers a(system.velocity_count());
  system.find_acceleration(q, v, t, a.data());
  const std::span<const double> pivots = system.relative_pivots();
  for (std::size_t i = 0; i < pivots.size(); ++i) {
    const double pivot = pivots[i];
    if (std::abs(pivot) > static_cast<double>(pivots.size()) * epsilon) continue;
    const bool is_of_mass = i < a.size();
    const std::string name =
        is_of_mass ? leaf_text(system.leaves(), Opcode::velocity, static_cast<std::uint32_t>(i))
                   : model.constraints[i - a.size()].name;
    const std::string value = std::isfinite(pivot) ? fmt::format("{:.1e}", pivot) : "no number";
    Diagnostic refused = singular_start_error(
        fmt::format("{} is singular at the start: the relative pivot of `{}` is {}",
                    is_of_mass ? "M" : "A M^-1 A^T", name, value));
    const std::string hint = quotient_hint(model, start_state(model, {}));
    if (!hint.empty()) refused.hint = hint;
    return {std::move(refused)};
  }
  return {};
}

}  // namespace elgen
