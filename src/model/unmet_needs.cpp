// unmet_needs: the first need of an output that a model does not meet, with one message per need.
#include "model/unmet_needs.hpp"

#include <algorithm>

#include "base/reason.hpp"
#include "elgen/inertial_parameters.hpp"
#include "elgen/references.hpp"
#include "elgen/step_methods.hpp"
#include "model/requests.hpp"

namespace elgen {
namespace {

using MaybeUnmetNeed = std::optional<UnmetNeed>;

MaybeUnmetNeed unmet_need_if(bool lacks, Code code, std::string reason) {
  return lacks ? std::optional(UnmetNeed{code, std::move(reason)}) : std::nullopt;
}

UnmetNeed need_unmet_by_constraints(Code code, std::string reason, const Model& model) {
  return {code, std::move(reason), model.constraints.front().span, "constrained here"};
}

UnmetNeed unmet_by_routh(std::string reason, const Model& model) {
  return {Reason::routhian, std::move(reason), model.reduction.cyclic.front().span,
          "it removes a coordinate here"};
}

MaybeUnmetNeed check_quadratic(const Model& model, const OutputRow& row) {
  if (model.is_quadratic) return std::nullopt;
  const bool is_of_momenta = row.argument_kinds.has_any(Opcode::momentum);
  return UnmetNeed{is_of_momenta ? Code::E534 : Code::E505,
                   is_of_momenta
                       ? "needs rates that p = dL/dv gives by a linear solve, and L is not "
                         "quadratic in the rates"
                       : "needs a Lagrangian at most quadratic in the rates",
                   model.expressions[*model.energies.L].span, "L is given here"};
}

MaybeUnmetNeed check_energies(const Model& model) {
  if (model.energies.L) {
    return UnmetNeed{Reason::whole_lagrangian, "needs T and V separately, but the model gives L",
                     model.expressions[*model.energies.L].span, "L is given here"};
  }
  if (!has_routhian(model)) return std::nullopt;
  return unmet_by_routh("needs T and V separately, but `[routh]` combines them", model);
}

MaybeUnmetNeed check_affine_forces(const Model& model) {
  if (has_routhian(model)) {
    return unmet_by_routh(
        "needs forces that are affine in masses, but `[routh]` makes them nonlinear", model);
  }
  if (!model.approximation) return std::nullopt;
  return UnmetNeed{Reason::exact_output, "is exact, but `[approximate]` expands the equations",
                   model.approximation->span, "it is expanded here"};
}

std::size_t degrees_of_freedom(const Model& model) {
  const std::size_t velocities = model.velocities.size();
  return velocities - std::min(model.constraints.size(), velocities);
}

MaybeUnmetNeed check_independent(const Model& model, const OutputRequest& request) {
  const std::size_t count = request.independent.size();
  if (count == degrees_of_freedom(model)) return std::nullopt;
  if (count == 0) {
    return UnmetNeed{Reason::independent_velocities,
                     "needs independent velocities: name them in `[outputs]` by `completed = { "
                     "independent = [\"NAME\"] }`"};
  }
  return need_unmet_by_constraints(
      Reason::independent_velocities,
      "needs as many independent velocities as the constraints leave free, " +
          std::to_string(degrees_of_freedom(model)) + ", but " + std::to_string(count) +
          (count == 1 ? " is named" : " are named"),
      model);
}

MaybeUnmetNeed check_no_constraints(const Model& model, const OutputRow& row) {
  if (model.constraints.empty()) return std::nullopt;
  const bool is_of_momenta = row.argument_kinds.has_any(Opcode::momentum);
  const std::string remedy =
      is_of_momenta ? ": choose coordinates that respect the constraint" : "";
  return need_unmet_by_constraints(Code::E539, "does not support constraints" + remedy, model);
}

MaybeUnmetNeed check_motors(const Model& model) {
  const auto external = std::ranges::find(model.inputs, true, &Input::is_external);
  if (external == model.inputs.end()) return std::nullopt;
  return UnmetNeed{Reason::world_input, "needs motors as inputs", external->span,
                   "this input is an external force"};
}

MaybeUnmetNeed check_input_count(const Model& model) {
  if (model.inputs.size() <= degrees_of_freedom(model)) return std::nullopt;
  return need_unmet_by_constraints(Reason::undetermined_inputs,
                                   "needs inputs that the motion determines: the model has " +
                                       count_text(model.inputs.size(), "input") + " for " +
                                       count_text(degrees_of_freedom(model), "freedom"),
                                   model);
}

MaybeUnmetNeed check_no_cyclic_coordinates(const Model& model, const OutputRequest& request) {
  if (!has_routhian(model)) return std::nullopt;
  const Model& whole = unreduced_model(model);
  const std::vector<ExpressionId> roots = output_roots(whole, request.user);
  for (const CyclicCoordinate& cyclic : whole.reduction.cyclic) {
    if (!contains_variable(whole, roots, cyclic)) continue;
    return UnmetNeed{Reason::routhian,
                     "contains " + quote_text(whole.coordinates[cyclic.coordinate].name) +
                         ", which `[routh]` removes",
                     cyclic.span, "it is removed here"};
  }
  return std::nullopt;
}

MaybeUnmetNeed check_velocity_count(const Model& model) {
  const std::size_t count = model.velocities.size();
  return unmet_need_if(count > max_step_velocities, Reason::too_many_velocities,
                       "supports at most " + std::to_string(max_step_velocities) +
                           " velocities, but the model has " + std::to_string(count) +
                           "; `linearization` at the states of a step has no limit");
}

MaybeUnmetNeed check_closed_functions(const Model& model) {
  if (model.functions.empty()) return std::nullopt;
  const OpenFunction& function = model.functions.front();
  return UnmetNeed{Code::E633,
                   "needs an expression of `" + function.name + "` in `[functions]` of a scene",
                   function.span, "left open here"};
}

/// True for a generalised force on a locked coordinate: no equation of motion contains the force.
bool acts_on_locked_coordinate(const Model& model, const Force& force) {
  return !model.reduction.unreduced && force.velocity &&
         has_velocity(model.reduction.locks, *force.velocity);
}

/// The first function with a kink in the roots, also through names; null if there is none.
const Expression* find_kink_in(const Model& model, const std::vector<ExpressionId>& roots) {
  for (const ExpressionId id : reachable_expressions(model, roots)) {
    const Expression& node = model.expressions[id];
    if (node.kind == ExpressionKind::function && is_kinked(node.function)) return &node;
  }
  return nullptr;
}

/// The message that derivatives do not exist because of `kink`; none if `kink` is null.
MaybeUnmetNeed check_smoothness(const std::string& noun, const Expression* kink) {
  if (kink == nullptr) return std::nullopt;
  return UnmetNeed{Reason::kink,
                   "needs " + noun +
                       " with derivatives, but `abs`, `sign`, `min` and `max` have none; a smooth "
                       "approximation is tanh(x/width)",
                   kink->span, "a kink is here"};
}

MaybeUnmetNeed check_smooth_values(const Model& model, const UserOutput& output) {
  MaybeUnmetNeed lack = check_smoothness("outputs", find_kink_in(model, output.values));
  if (lack || !output.solves_motion) return lack;
  return check_smoothness("forces", find_kink(model));
}

/// The message if the entry of an [[output]] does not meet the need; none if it does.
MaybeUnmetNeed check_entry_of_output(Need need, const UserOutput& output) {
  const auto lacks = [&](std::string reason) {
    return UnmetNeed{Reason::other_derivatives, std::move(reason), output.span, "declared here"};
  };
  const bool is_of_positions = output.argument_kinds == LeafSet();
  if (need == Need::jacobian && !output.has_jacobian) {
    return lacks("needs `jacobian = true` in the output's entry");
  }
  if (need == Need::position_values && !is_of_positions) {
    return lacks("needs an output of positions; an output of rates, accelerations or inputs has `" +
                 output.name + "_derivatives`");
  }
  if (need == Need::motion_values && is_of_positions) {
    return lacks("needs an output of rates, accelerations or inputs; an output of positions has `" +
                 output.name + "_jacobian`");
  }
  return std::nullopt;
}

MaybeUnmetNeed find_unmet_need(Need need, const Model& model, const OutputRequest& request) {
  switch (need) {
    case Need::quadratic:
      return check_quadratic(model, output_row(request.kind));
    case Need::energies:
      return check_energies(model);
    case Need::rotations:
      return unmet_need_if(model.rotations.empty(), Reason::missing_entry,
                           "needs a rotation; without one dq/dt is v");
    case Need::reaction:
      return unmet_need_if(reaction_row_velocities(model).empty(), Reason::missing_entry,
                           "needs `reaction = true` in an entry of `[lock]`");
    case Need::cyclic:
      return unmet_need_if(model.reduction.cyclic.empty(), Reason::missing_entry,
                           "needs a coordinate in `[routh]`");
    case Need::affine_forces:
      return check_affine_forces(model);
    case Need::inertial:
      return unmet_need_if(inertial_entries(model).empty(), Reason::missing_entry,
                           "needs a body, a point with a mass, an armature, or parameters that "
                           "`[regressor]` of a scene names");
    case Need::constraints:
      return unmet_need_if(model.constraints.empty(), Reason::missing_entry,
                           "needs a `[[constraint]]`, but the model has none");
    case Need::independent:
      return check_independent(model, request);
    case Need::no_constraints:
      return check_no_constraints(model, output_row(request.kind));
    case Need::inputs:
      return unmet_need_if(model.inputs.empty(), Reason::missing_entry,
                           "needs inputs, but the model has none");
    case Need::motors:
      return check_motors(model);
    case Need::few_inputs:
      return check_input_count(model);
    case Need::no_cyclic_coordinates:
      return check_no_cyclic_coordinates(model, request);
    case Need::smooth_forces:
      return check_smoothness("forces", find_kink(model));
    case Need::few_velocities:
      return check_velocity_count(model);
    case Need::closed_functions:
      return check_closed_functions(model);
    case Need::jacobian:
    case Need::position_values:
    case Need::motion_values:
      return check_entry_of_output(need, model.outputs[request.user]);
    case Need::smooth_values:
      return check_smooth_values(model, model.outputs[request.user]);
  }
  return std::nullopt;
}

}  // namespace

const Expression* find_kink(const Model& model) {
  return find_kink_in(model, filter_roots(model, [&model](const Root& root) {
                        return is_force_value(root) &&
                               !acts_on_locked_coordinate(model, model.forces[root.entity.index]);
                      }));
}

std::optional<UnmetNeed> find_unmet_need(const Model& model, const OutputRequest& request) {
  for (const Need need : output_row(request.kind).needs.members()) {
    if (MaybeUnmetNeed lack = find_unmet_need(need, model, request)) return lack;
  }
  return std::nullopt;
}

}  // namespace elgen
