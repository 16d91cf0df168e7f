// lacks: the first need of an output that a model does not meet, with one message per need.
#include "model/lacks.hpp"

#include <algorithm>

#include "base/reason.hpp"
#include "elgen/inertial_parameters.hpp"
#include "elgen/references.hpp"
#include "model/requests.hpp"

namespace elgen {
namespace {

using MaybeLack = std::optional<Lack>;

MaybeLack lack_if(bool lacks, Code code, std::string reason) {
  return lacks ? std::optional(Lack{code, std::move(reason)}) : std::nullopt;
}

Lack constrained(Code code, std::string reason, const Model& model) {
  return {code, std::move(reason), model.constraints.front().span, "constrained here"};
}

Lack taken_out(std::string reason, const Model& model) {
  return {Reason::routhian, std::move(reason), model.variant.cyclic.front().span,
          "it removes a coordinate here"};
}

MaybeLack lack_of_quadratic(const Model& model, const OutputRow& row) {
  if (model.quadratic) return std::nullopt;
  const bool is_of_momenta = row.takes.has_any(Opcode::momentum);
  return Lack{is_of_momenta ? Code::E534 : Code::E505,
              is_of_momenta ? "needs rates that p = dL/dv gives by a linear solve, and L is not "
                              "quadratic in the rates"
                            : "needs a Lagrangian at most quadratic in the rates",
              model.expressions[*model.energies.L].span, "L is given here"};
}

MaybeLack lack_of_energies(const Model& model) {
  if (model.energies.L) {
    return Lack{Reason::whole_lagrangian, "needs T and V separately, but the model gives L",
                model.expressions[*model.energies.L].span, "L is given here"};
  }
  if (!has_routhian(model)) return std::nullopt;
  return taken_out("needs T and V separately, but `[routh]` combines them", model);
}

MaybeLack lack_of_affine_forces(const Model& model) {
  if (has_routhian(model)) {
    return taken_out("needs forces that are affine in masses, but `[routh]` makes them nonlinear",
                     model);
  }
  if (!model.approximation) return std::nullopt;
  return Lack{Reason::exact_output, "is exact, but `[approximate]` expands the equations",
              model.approximation->span, "it is expanded here"};
}

std::size_t freedoms(const Model& model) {
  const std::size_t velocities = model.velocities.size();
  return velocities - std::min(model.constraints.size(), velocities);
}

MaybeLack lack_of_independent(const Model& model, const OutputRequest& request) {
  const std::size_t count = request.independent.size();
  if (count == freedoms(model)) return std::nullopt;
  if (count == 0) {
    return Lack{Reason::independent_velocities,
                "needs independent velocities: name them in `[outputs]` by `completed = { "
                "independent = [\"NAME\"] }`"};
  }
  return constrained(Reason::independent_velocities,
                     "needs as many independent velocities as the constraints leave free, " +
                         std::to_string(freedoms(model)) + ", but " + std::to_string(count) +
                         (count == 1 ? " is named" : " are named"),
                     model);
}

MaybeLack lack_of_no_constraints(const Model& model, const OutputRow& row) {
  if (model.constraints.empty()) return std::nullopt;
  const bool is_of_momenta = row.takes.has_any(Opcode::momentum);
  const std::string remedy =
      is_of_momenta ? ": choose coordinates that respect the constraint" : "";
  return constrained(Code::E539, "does not support constraints" + remedy, model);
}

MaybeLack lack_of_motors(const Model& model) {
  const auto external = std::ranges::find(model.inputs, true, &Input::is_external);
  if (external == model.inputs.end()) return std::nullopt;
  return Lack{Reason::world_input, "needs motors as inputs", external->span,
              "this input is an external force"};
}

MaybeLack lack_of_few_inputs(const Model& model) {
  if (model.inputs.size() <= freedoms(model)) return std::nullopt;
  return constrained(Reason::undetermined_inputs,
                     "needs inputs that the motion determines: the model has " +
                         counted(model.inputs.size(), "input") + " for " +
                         counted(freedoms(model), "freedom"),
                     model);
}

MaybeLack lack_of_kept_coordinates(const Model& model, const OutputRequest& request) {
  if (!has_routhian(model)) return std::nullopt;
  const Model& whole = whole_of(model);
  const std::vector<ExpressionId> roots = output_roots(whole, request.user);
  for (const Cyclic& cyclic : whole.variant.cyclic) {
    if (!is_reached(whole, roots, cyclic)) continue;
    return Lack{Reason::routhian,
                "contains " + in_backticks(whole.coordinates[cyclic.coordinate].name) +
                    ", which `[routh]` removes",
                cyclic.span, "it is removed here"};
  }
  return std::nullopt;
}

MaybeLack lack_of_few_velocities(const Model& model) {
  // Derivatives of a step are straight-line code: 12 MB for solo12 with its 18 velocities.
  constexpr std::size_t most = 10;
  const std::size_t count = model.velocities.size();
  return lack_if(count > most, Reason::too_many_velocities,
                 "supports at most " + std::to_string(most) + " velocities, but the model has " +
                     std::to_string(count) +
                     "; `linearization` at the states of a step has no limit");
}

MaybeLack lack_of_closed_functions(const Model& model) {
  if (model.functions.empty()) return std::nullopt;
  const OpenFunction& function = model.functions.front();
  return Lack{Code::E633,
              "needs an expression of `" + function.name + "` in `[functions]` of a scene",
              function.span, "left open here"};
}

/// True if a force acts on a locked coordinate and therefore occurs in no equation of motion.
bool is_held(const Model& model, const Force& force) {
  if (model.variant.whole || !force.on) return false;
  return std::ranges::any_of(model.variant.locks,
                             [&](const Lock& lock) { return lock.has_velocity(*force.on); });
}

/// The first function with a kink in the roots, directly or by reference; null if there is none.
const Expression* kink_in(const Model& model, const std::vector<ExpressionId>& roots) {
  for (const ExpressionId id : reached(model, roots)) {
    const Expression& node = model.expressions[id];
    if (node.kind == ExpressionKind::function && is_kinked(node.function)) return &node;
  }
  return nullptr;
}

/// None if there is no kink.
MaybeLack lack_of_slope(const std::string& noun, const Expression* kink) {
  if (kink == nullptr) return std::nullopt;
  return Lack{Reason::kink,
              "needs " + noun +
                  " with derivatives, but `abs`, `sign`, `min` and `max` have none; a smooth "
                  "approximation is tanh(x/width)",
              kink->span, "a kink is here"};
}

MaybeLack lack_of_smooth_values(const Model& model, const UserOutput& output) {
  MaybeLack lack = lack_of_slope("outputs", kink_in(model, output.values));
  if (lack || !output.motion) return lack;
  return lack_of_slope("forces", find_kink(model));
}

/// The unmet need that the entry of the [[output]] causes; none if it meets the need.
MaybeLack lack_of_entry(Need need, const UserOutput& output) {
  const auto lacks = [&](std::string reason) {
    return Lack{Reason::other_derivatives, std::move(reason), output.span, "declared here"};
  };
  const bool is_of_positions = output.takes == LeafSet();
  if (need == Need::jacobian && !output.jacobian) {
    return lacks("needs `jacobian = true` in the output's entry");
  }
  if (need == Need::of_positions && !is_of_positions) {
    return lacks("needs an output of positions; an output of rates, accelerations or inputs has `" +
                 output.name + "_derivatives`");
  }
  if (need == Need::of_motion && is_of_positions) {
    return lacks("needs an output of rates, accelerations or inputs; an output of positions has `" +
                 output.name + "_jacobian`");
  }
  return std::nullopt;
}

MaybeLack lack_of(Need need, const Model& model, const OutputRequest& request) {
  switch (need) {
    case Need::quadratic:
      return lack_of_quadratic(model, output_row(request.kind));
    case Need::energies:
      return lack_of_energies(model);
    case Need::rotations:
      return lack_if(model.rotations.empty(), Reason::missing_entry,
                     "needs a rotation; without one dq/dt is v");
    case Need::held:
      return lack_if(held_velocities(model).empty(), Reason::missing_entry,
                     "needs `reaction = true` in an entry of `[lock]`");
    case Need::cyclic:
      return lack_if(model.variant.cyclic.empty(), Reason::missing_entry,
                     "needs a coordinate in `[routh]`");
    case Need::affine_forces:
      return lack_of_affine_forces(model);
    case Need::inertial:
      return lack_if(inertial_places(model).empty(), Reason::missing_entry,
                     "needs a body, a point with a mass, an armature, or parameters that "
                     "`[regressor]` of a scene names");
    case Need::constraints:
      return lack_if(model.constraints.empty(), Reason::missing_entry,
                     "needs a `[[constraint]]`, but the model has none");
    case Need::independent:
      return lack_of_independent(model, request);
    case Need::no_constraints:
      return lack_of_no_constraints(model, output_row(request.kind));
    case Need::inputs:
      return lack_if(model.inputs.empty(), Reason::missing_entry,
                     "needs inputs, but the model has none");
    case Need::motors:
      return lack_of_motors(model);
    case Need::few_inputs:
      return lack_of_few_inputs(model);
    case Need::kept_coordinates:
      return lack_of_kept_coordinates(model, request);
    case Need::smooth_forces:
      return lack_of_slope("forces", find_kink(model));
    case Need::few_velocities:
      return lack_of_few_velocities(model);
    case Need::closed_functions:
      return lack_of_closed_functions(model);
    case Need::jacobian:
    case Need::of_positions:
    case Need::of_motion:
      return lack_of_entry(need, model.outputs[request.user]);
    case Need::smooth_values:
      return lack_of_smooth_values(model, model.outputs[request.user]);
  }
  return std::nullopt;
}

}  // namespace

const Expression* find_kink(const Model& model) {
  return kink_in(model, roots_if(model, [&model](const Root& root) {
                   return is_force(root) && !is_held(model, model.forces[root.entity.index]);
                 }));
}

std::optional<Lack> lack_of(const Model& model, const OutputRequest& request) {
  for (const Need need : output_row(request.kind).needs.members()) {
    if (MaybeLack lack = lack_of(need, model, request)) return lack;
  }
  return std::nullopt;
}

}  // namespace elgen
