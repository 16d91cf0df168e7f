// Momenta of `[routh]`, and E635 if the coordinate of a momentum is not cyclic. L depends on the
// coordinate if dL/dq is not 0 at a sampled state. If dL/dq is 0 at all samples, we assume that the
// coordinate is cyclic; verification compares the derived functions with the whole model anyway.
#include <utility>

#include "base/reason.hpp"
#include "check/scene/scene.hpp"
#include "elgen/inspect.hpp"
#include "elgen/wording.hpp"
#include "inspect/samples.hpp"
#include "numbers/exact_number.hpp"

namespace elgen {
namespace {

using cln::cl_R;

constexpr unsigned cyclic_samples = 8;

std::vector<cl_R> unit_direction(const Model& model, const CyclicCoordinate& cyclic) {
  std::vector<cl_R> direction(model.velocities.size(), cl_R(0));
  direction[cyclic.velocity] = 1;
  return direction;
}

std::string quoted_name(const Model& model, const CyclicCoordinate& cyclic) {
  return quote_text(model.coordinates[cyclic.coordinate].name);
}

/// True if dL/dq exceeds rounding error at a sampled state.
bool changes_lagrangian(const InspectedModel& subject, const CyclicCoordinate& cyclic) {
  const Model& model = subject.model;
  for (unsigned seed = 0; seed < cyclic_samples; ++seed) {
    const State state = sample_state(subject, seed);
    const auto slope = oracle_contraction(model, {.kind = OutputKind::position_gradient}, state,
                                          {unit_direction(model, cyclic)});
    const auto size = oracle_energy_magnitude(model, state);
    if (slope && size && cln::abs(*slope) > *size * power_of_ten(-50)) return true;
  }
  return false;
}

/// True if the block of M for the cyclic velocities is singular at every sample at which the block
/// has a value.
bool has_dependent_momenta(const InspectedModel& subject,
                           const std::vector<CyclicCoordinate>& cyclic) {
  const Model& model = subject.model;
  bool was_singular = false;
  for (unsigned seed = 0; seed < zero_sample_count; ++seed) {
    const State state = sample_state(subject, seed);
    std::vector<cl_R> mass;
    for (const CyclicCoordinate& row : cyclic) {
      for (const CyclicCoordinate& column : cyclic) {
        const auto entry =
            oracle_contraction(model, {.kind = OutputKind::mass_matrix}, state,
                               {unit_direction(model, row), unit_direction(model, column)});
        if (entry) mass.push_back(*entry);
      }
    }
    const std::size_t n = cyclic.size();
    if (mass.size() < n * n) continue;
    if (oracle_relative_pivots(std::move(mass), n)) return false;
    was_singular = true;
  }
  return was_singular;
}

Diagnostics cyclic_errors(const InspectedModel& subject, const std::vector<CyclicCoordinate>& all) {
  Diagnostics errors;
  for (const CyclicCoordinate& cyclic : all) {
    if (!changes_lagrangian(subject, cyclic)) continue;
    errors.push_back({Reason::not_cyclic, cyclic.span,
                      quoted_name(subject.model, cyclic) + " is not cyclic: L changes with it"});
  }
  if (errors.empty() && has_dependent_momenta(subject, all)) {
    errors.push_back({Reason::dependent_momenta, all.front().span,
                      "the momenta do not determine the rates of the removed coordinates: their "
                      "block of the mass matrix is singular"});
  }
  return errors;
}

/// The exact model that still contains the cyclic coordinates, and their indices in this model.
struct ModelBeforeRouth {
  Model model;
  std::vector<CyclicCoordinate> cyclic;
};

ModelBeforeRouth model_before_routh(Model whole) {
  whole.approximation.reset();
  std::vector<CyclicCoordinate> all = std::exchange(whole.reduction.cyclic, {});
  const RemainingVariables left = remaining_variables(whole);
  for (CyclicCoordinate& cyclic : all) {
    cyclic.coordinate = *left.coordinates[cyclic.coordinate];
    cyclic.velocity = *left.velocities[cyclic.velocity];
  }
  return {eliminate_held_coordinates(std::move(whole)), std::move(all)};
}

/// The state at the start of a run.
State run_start_state(const CheckedModel& checked, const Model& moving) {
  State state = start_state(moving, checked.scene);
  state.parameters = nominal_state(checked.model, checked.scene).parameters;
  return state;
}

std::optional<cl_R> momentum_value(const Model& exact, const CyclicCoordinate& cyclic,
                                   const State& start) {
  if (cyclic.exact_expression)
    return oracle_expression_value(exact, *cyclic.exact_expression, start);
  return oracle_contraction(exact, {.kind = OutputKind::momentum}, start,
                            {unit_direction(exact, cyclic)});
}

}  // namespace

Diagnostics set_routh_momenta(CheckedModel& checked) {
  if (!has_routhian(checked.model)) return {};
  const auto [exact, all] = model_before_routh(unreduced_model(checked.model));
  Diagnostics errors = cyclic_errors({exact, checked.scene}, all);
  if (!errors.empty()) return errors;
  const State start = run_start_state(checked, exact);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const CyclicCoordinate& cyclic = all[i];
    std::optional<cl_R>& known = checked.model.reduction.cyclic[i].momentum;
    if (known) continue;
    const std::optional<cl_R> momentum = momentum_value(exact, cyclic, start);
    if (!momentum) {
      errors.push_back({Reason::momentum_without_value, cyclic.span,
                        "the momentum of " + quoted_name(exact, cyclic) + " has no value" +
                            (cyclic.exact_expression ? "" : " at the start")});
      continue;
    }
    known = round_to_digits(*momentum, 16);
    checked.model.parameters[cyclic.parameter].value = *known;
    const auto fixed = checked.scene.specialisation.fixed.find(cyclic.parameter);
    if (fixed != checked.scene.specialisation.fixed.end()) fixed->second.number = *known;
  }
  return errors;
}

bool is_cyclic(const CheckedModel& checked, std::uint32_t coordinate) {
  Model exact = checked.model;
  exact.approximation.reset();
  const Coordinate& candidate = exact.coordinates[coordinate];
  if (candidate.rotation || !exact.is_quadratic) return false;
  CyclicCoordinate cyclic;
  cyclic.coordinate = coordinate;
  cyclic.velocity = candidate.velocity;
  return find_cyclic_obstacles(exact, checked.scene, cyclic).empty() &&
         cyclic_errors({exact, checked.scene}, {cyclic}).empty();
}

}  // namespace elgen
