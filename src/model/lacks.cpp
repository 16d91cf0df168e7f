// lacks: reasons why a model cannot give an output.
#include "model/lacks.hpp"

#include <algorithm>

#include "elgen/inertial_parameters.hpp"
#include "elgen/references.hpp"
#include "model/requests.hpp"

namespace elgen {
namespace {

Lack lacking(std::string reason) { return {Code::E603, std::move(reason)}; }

/// The coordinate of [routh] on which an [[output]] of the whole model depends; null if there is
/// none.
const Cyclic* taken_out_of(const Model& whole, std::uint32_t user) {
  const std::vector<ExpressionId> roots = output_roots(whole.outputs[user]);
  const std::vector<Cyclic>& all = whole.variant.cyclic;
  const auto found = std::ranges::find_if(
      all, [&](const Cyclic& cyclic) { return is_reached(whole, roots, cyclic); });
  return found == all.end() ? nullptr : &*found;
}

bool differentiates_step(const OutputRow& row) { return row.steps && row.differentiates; }

/// Derivatives of a step are straight code, of solo12 with 18 velocities 12 MB of it.
constexpr std::size_t most_velocities_of_derivatives = 10;

std::optional<Lack> lack_of_independent(const Model& model, std::size_t freedoms) {
  const std::size_t count = model.independent.size();
  if (count == freedoms) return std::nullopt;
  if (count == 0) {
    return lacking(
        "needs independent velocities, which a scene names: `[outputs]` `completed = { "
        "independent = [\"NAME\"] }`");
  }
  return Lack{Code::E603,
              "needs as many independent velocities as the constraints leave free, " +
                  std::to_string(freedoms) + ", and " + std::to_string(count) +
                  (count == 1 ? " is named" : " are named"),
              model.constraints.front().span, "constrained here"};
}

std::optional<Lack> lack_of_constraints(const Model& model, const OutputRequest& request) {
  const OutputRow& row = output_row(request.kind);
  const std::size_t count = model.constraints.size();
  const bool is_for_inputs = row.requirement == Requirement::constrained_inputs;
  if (count == 0) {
    const bool needs_some = is_for_inputs || row.requirement == Requirement::constraints ||
                            row.requirement == Requirement::independent;
    return needs_some ? std::optional(lacking("needs a `[[constraint]]`, and the model has none"))
                      : std::nullopt;
  }
  const Span& span = model.constraints.front().span;
  const std::size_t freedoms = model.velocities.size() - std::min(count, model.velocities.size());
  if (row.requirement == Requirement::independent) return lack_of_independent(model, freedoms);
  if (differentiates_step(row) || row.requirement == Requirement::operational) {
    return Lack{Code::E539, "does not know of constraints", span, "constrained here"};
  }
  if (row.takes.has_any(Opcode::momentum)) {
    return Lack{Code::E539,
                "does not know of constraints: choose coordinates that respect the constraint",
                span, "constrained here"};
  }
  if (!is_for_inputs) return std::nullopt;
  if (model.inputs.empty()) return lacking("needs inputs, and the model has none");
  const auto external = std::ranges::find(model.inputs, true, &Input::is_external);
  if (external != model.inputs.end()) {
    return Lack{Code::E603, "needs inputs that are motors, all of them", external->span,
                "this is a force of the world"};
  }
  if (model.inputs.size() <= freedoms) return std::nullopt;
  return Lack{Code::E603,
              "needs inputs that the motion determines: the model has " +
                  counted(model.inputs.size(), "input") + " for " + counted(freedoms, "freedom"),
              span, "constrained here"};
}

/// Whether a force acts on a locked coordinate and is thus in no equation of motion.
bool is_held(const Model& model, const Force& force) {
  if (model.variant.whole || !force.on) return false;
  return std::ranges::any_of(model.variant.locks,
                             [&](const Lock& lock) { return lock.has_velocity(*force.on); });
}

/// The first function with a kink below the roots.
const Expression* kink_in(const Model& model, const std::vector<ExpressionId>& roots) {
  for (const ExpressionId id : reached(model, roots)) {
    const Expression& node = model.expressions[id];
    if (node.kind == ExpressionKind::function && is_kinked(node.function)) return &node;
  }
  return nullptr;
}

Lack lack_of_slope(const std::string& noun, const Expression& kink) {
  return Lack{Code::E603,
              "needs " + noun +
                  " with derivatives; `abs`, `sign`, `min` and `max` have none, a smooth "
                  "stand-in is tanh(x/width)",
              kink.span, "one is here"};
}

/// The derivatives of an [[output]].
std::optional<Lack> lack_of_derivatives(const Model& model, const OutputRequest& request) {
  const Requirement requirement = output_row(request.kind).requirement;
  const bool is_jacobian =
      requirement == Requirement::jacobian || requirement == Requirement::operational;
  if (!is_jacobian && requirement != Requirement::derivatives) return std::nullopt;
  const UserOutput& output = model.outputs[request.user];
  const auto lacks = [&](std::string reason) {
    return Lack{Code::E603, std::move(reason), output.span, "declared here"};
  };
  if (!output.jacobian) return lacks("needs `jacobian = true` in the output's entry");
  const bool is_of_positions = output.takes == LeafSet();
  if (is_jacobian && !is_of_positions) {
    return lacks("needs an output of positions; one of rates, accelerations or inputs has `" +
                 output.name + "_derivatives`");
  }
  if (!is_jacobian && is_of_positions) {
    return lacks("needs an output of rates, accelerations or inputs; one of positions has `" +
                 output.name + "_jacobian`");
  }
  if (const Expression* const kink = kink_in(model, output.values)) {
    return lack_of_slope("outputs", *kink);
  }
  const Expression* const of_force = output.motion ? find_kink(model) : nullptr;
  if (of_force != nullptr) return lack_of_slope("forces", *of_force);
  return std::nullopt;
}

std::optional<Lack> lack_of_regressor(const Model& model) {
  if (has_routhian(model)) {
    return Lack{Code::E603,
                "needs forces that are affine in masses, and those of `[routh]` are not",
                model.variant.cyclic.front().span, "it takes a coordinate out here"};
  }
  if (model.approximation) {
    return Lack{Code::E603, "is exact, and `[approximate]` asks for an expansion",
                model.approximation->span, "it is expanded here"};
  }
  if (!inertial_parameters(model).empty()) return std::nullopt;
  return lacking(
      "needs a body, a point with a mass, an armature, or parameters that `[regressor]` of a scene "
      "names");
}

std::optional<Lack> lack_of_step(const Model& model, const OutputRow& row) {
  const std::size_t velocities = model.velocities.size();
  if (differentiates_step(row) && velocities > most_velocities_of_derivatives) {
    return lacking("is for at most " + std::to_string(most_velocities_of_derivatives) +
                   " velocities, and the model has " + std::to_string(velocities) +
                   "; `linearization` at the states of a step is for any");
  }
  if (!row.steps || model.functions.empty()) return std::nullopt;
  const OpenFunction& function = model.functions.front();
  return Lack{Code::E633,
              "needs an expression of `" + function.name + "` in `[functions]` of a scene",
              function.span, "left open here"};
}

}  // namespace

const Expression* find_kink(const Model& model) {
  std::vector<ExpressionId> values;
  for (const Force& force : model.forces) {
    if (!is_held(model, force)) values.insert(values.end(), force.value.begin(), force.value.end());
  }
  return kink_in(model, values);
}

std::optional<Lack> lack_of(const Model& model, const OutputRequest& request) {
  const Requirement requirement = output_row(request.kind).requirement;
  const bool needs_quadratic = requirement == Requirement::quadratic ||
                               requirement == Requirement::energies ||
                               requirement == Requirement::polarised;
  if (needs_quadratic && !model.quadratic) {
    const bool is_of_momenta = output_row(request.kind).takes.has_any(Opcode::momentum);
    return Lack{is_of_momenta ? Code::E534 : Code::E505,
                is_of_momenta ? "needs rates that p = dL/dv gives by a linear solve, and L is not "
                                "quadratic in the rates"
                              : "needs a Lagrangian at most quadratic in the rates",
                model.expressions[*model.energies.L].span, "L is given here"};
  }
  if (requirement == Requirement::energies && model.energies.L) {
    return Lack{Code::E603, "needs T and V apart, but the model gives L",
                model.expressions[*model.energies.L].span, "L is given here"};
  }
  if (requirement == Requirement::energies && has_routhian(model)) {
    return Lack{Code::E603, "needs T and V apart, but `[routh]` makes one function of them",
                model.variant.cyclic.front().span, "it takes a coordinate out here"};
  }
  if (requirement == Requirement::inputs && model.inputs.empty()) {
    return lacking("needs inputs, and the model has none");
  }
  if (requirement == Requirement::rotations && model.rotations.empty()) {
    return lacking("needs a rotation; without one dq/dt is v");
  }
  if (requirement == Requirement::held && held_velocities(model).empty()) {
    return lacking("needs `reaction = true` in an entry of `[lock]`");
  }
  if (requirement == Requirement::cyclic && model.variant.cyclic.empty()) {
    return lacking("needs a coordinate in `[routh]`");
  }
  if (requirement == Requirement::inertial || requirement == Requirement::polarised) {
    if (const std::optional<Lack> lack = lack_of_regressor(model)) return lack;
  }
  if (const std::optional<Lack> lack = lack_of_constraints(model, request)) return lack;
  if (output_row(request.kind).of_user && has_routhian(model)) {
    if (const Cyclic* const cyclic = taken_out_of(whole_of(model), request.user)) {
      return Lack{Code::E603,
                  "contains " + in_backticks(whole_of(model).coordinates[cyclic->coordinate].name) +
                      ", which `[routh]` takes out",
                  cyclic->span, "it is taken out here"};
    }
  }
  const Expression* kink = output_row(request.kind).differentiates ? find_kink(model) : nullptr;
  if (kink != nullptr) return lack_of_slope("forces", *kink);
  if (const std::optional<Lack> lack = lack_of_step(model, output_row(request.kind))) return lack;
  return lack_of_derivatives(model, request);
}

}  // namespace elgen
