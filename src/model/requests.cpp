// Requests: which outputs a model has, and their shapes.
#include "model/requests.hpp"

#include <algorithm>
#include <map>

#include "elgen/inertial_parameters.hpp"
#include "elgen/references.hpp"

namespace elgen {
namespace {

/// The reason why the model cannot give an output.
struct Lack {
  Code code;
  std::string reason;
  std::optional<Span> related = {};  ///< the part of the model that prevents the output
  std::string related_message = {};
};

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

std::optional<Lack> lack_of_constraints(const Model& model, const OutputRequest& request) {
  const OutputRow& row = output_row(request.kind);
  const std::size_t count = model.constraints.size();
  const bool is_for_inputs = row.requirement == Requirement::constrained_inputs;
  if (count == 0) {
    const bool needs_some = is_for_inputs || row.requirement == Requirement::constraints;
    return needs_some ? std::optional(lacking("needs a `[[constraint]]`, and the model has none"))
                      : std::nullopt;
  }
  const Span& span = model.constraints.front().span;
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
  const std::size_t freedoms = model.velocities.size() - std::min(count, model.velocities.size());
  if (model.inputs.size() <= freedoms) return std::nullopt;
  return Lack{Code::E603,
              "needs inputs that the motion determines: the model has " +
                  counted(model.inputs.size(), "input") + " for " + counted(freedoms, "freedom"),
              span, "constrained here"};
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
  const bool is_jacobian = requirement == Requirement::jacobian;
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
  if (output_row(request.kind).steps && !model.functions.empty()) {
    const OpenFunction& function = model.functions.front();
    return Lack{Code::E633,
                "needs an expression of `" + function.name + "` in `[functions]` of a scene",
                function.span, "left open here"};
  }
  return lack_of_derivatives(model, request);
}

/// In the order of the table; user-defined outputs of a kind are in order of declaration.
std::vector<OutputRequest> all_requests(const Model& model) {
  std::vector<OutputRequest> result;
  for (const OutputRow& row : output_table()) {
    const std::size_t count = row.of_user ? model.outputs.size() : 1;
    for (std::uint32_t user = 0; user < count; ++user) {
      result.push_back(request_of(model, row.kind, user));
    }
  }
  return result;
}

/// Includes big outputs, to suggest their names for misspelt ones.
std::vector<std::string> available_names(const Model& model) {
  std::vector<std::string> names;
  for (const OutputRequest& request : all_requests(model)) {
    if (is_available(model, request)) names.push_back(request.name);
  }
  return names;
}

/// Whether a force acts on a locked coordinate and is thus in no equation of motion.
bool is_held(const Model& model, const Force& force) {
  if (model.variant.whole || !force.on) return false;
  return std::ranges::any_of(model.variant.locks,
                             [&](const Lock& lock) { return lock.has_velocity(*force.on); });
}

bool fits_in_full(const OutputRequest& request) {
  return std::uint64_t{request.rows} * request.columns <= entries_in_full;
}

}  // namespace

std::string_view name_of(LeftOutReason reason) {
  return reason == LeftOutReason::too_many_entries ? "too many entries" : "kinked force";
}

const OutputRequest* find_request(const Scene& scene, std::string_view name) {
  const auto found = std::ranges::find(scene.outputs, name, &OutputRequest::name);
  return found == scene.outputs.end() ? nullptr : &*found;
}

std::uint32_t extent_of(const Model& model, Extent kind, std::uint32_t user) {
  switch (kind) {
    case Extent::coordinates:
      return static_cast<std::uint32_t>(model.coordinates.size());
    case Extent::velocities:
      return static_cast<std::uint32_t>(model.velocities.size());
    case Extent::states:
      return static_cast<std::uint32_t>(2 * model.velocities.size());
    case Extent::inputs:
      return static_cast<std::uint32_t>(model.inputs.size());
    case Extent::held:
      return static_cast<std::uint32_t>(held_velocities(model).size());
    case Extent::cyclic:
      return has_routhian(model) ? static_cast<std::uint32_t>(model.variant.cyclic.size()) : 0;
    case Extent::constraints:
      return static_cast<std::uint32_t>(model.constraints.size());
    case Extent::positions:
      return static_cast<std::uint32_t>(
          std::ranges::count(model.constraints, true, &Constraint::is_position));
    case Extent::pivots:
      return static_cast<std::uint32_t>(model.velocities.size() + model.constraints.size());
    case Extent::inertial:
      return static_cast<std::uint32_t>(inertial_parameters(model).size());
    case Extent::user:
      return static_cast<std::uint32_t>(model.outputs[user].values.size());
    case Extent::one:
      break;
  }
  return 1;
}

std::vector<LineLabel> line_labels(const Model& model, Extent extent, std::uint32_t count) {
  std::vector<LineLabel> labels;
  const auto add = [&labels](const auto& list, bool is_rate = false) {
    for (const auto& entry : list) labels.push_back({entry.name, is_rate});
  };
  const bool has_states = extent == Extent::states;
  const bool has_pivots = extent == Extent::pivots;
  if (extent == Extent::coordinates) add(model.coordinates);
  if (extent == Extent::inputs) add(model.inputs);
  if (extent == Extent::inertial) add(inertial_parameters(model));
  if (extent == Extent::velocities || has_states || has_pivots) add(model.velocities);
  if (has_states) add(model.velocities, true);
  if (extent == Extent::constraints || has_pivots) add(model.constraints);
  for (const Constraint& constraint : model.constraints) {
    const bool is_row = extent == Extent::positions && constraint.is_position;
    if (is_row) labels.push_back({constraint.name});
  }
  while (labels.size() < count) labels.push_back({std::to_string(labels.size() + 1)});
  return labels;
}

std::uint32_t first_entry_of(const Model& model, const OutputRequest& output, std::size_t field) {
  std::uint32_t first = 0;
  for (const FieldRow& row : output_row(output.kind).fields.first(field)) {
    first += extent_of(model, row.rows, output.user) * extent_of(model, row.columns, output.user);
  }
  return first;
}

OutputRequest request_of(const Model& model, OutputKind kind, std::uint32_t user) {
  const OutputRow& row = output_row(kind);
  OutputRequest request;
  request.kind = kind;
  request.user = user;
  request.takes = row.of_user ? row.takes | model.outputs[user].takes : row.takes;
  request.without_pivots = row.gives_pivots && model.without_pivots;
  request.name =
      row.of_user ? model.outputs[user].name + std::string(row.suffix) : std::string(row.name);
  if (!row.fields.empty()) {
    request.rows = extent_of(model, row.fields.front().rows, user);
    request.columns = extent_of(model, row.fields.front().columns, user);
  }
  if (row.of_user && model.outputs[user].frame) {
    const bool is_pose = kind == OutputKind::user_value;
    request.rows = is_pose ? 3 : 6;
    request.columns = is_pose ? model.outputs[user].columns : request.columns;
  }
  return request;
}

const Expression* find_kink(const Model& model) {
  std::vector<ExpressionId> values;
  for (const Force& force : model.forces) {
    if (!is_held(model, force)) values.insert(values.end(), force.value.begin(), force.value.end());
  }
  return kink_in(model, values);
}

std::optional<OutputRequest> find_request(const Model& model, std::string_view name) {
  for (OutputRequest& request : all_requests(model)) {
    if (request.name == name) return std::move(request);
  }
  return std::nullopt;
}

bool is_available(const Model& model, const OutputRequest& request) {
  return !lack_of(model, request);
}

std::vector<OutputRequest> available_requests(const Model& model,
                                              std::initializer_list<OutputKind> kinds) {
  std::vector<OutputRequest> requests;
  for (const OutputKind kind : kinds) {
    OutputRequest request = request_of(model, kind, 0);
    if (is_available(model, request)) requests.push_back(std::move(request));
  }
  return requests;
}

std::optional<OutputRequest> require_request(const Model& model, std::string_view name,
                                             const Span& span, Report& report) {
  std::optional<OutputRequest> request = find_request(model, name);
  if (!request) {
    report.add(Code::E601, span, "unknown output " + in_backticks(name),
               suggestion(name, available_names(model)));
    return std::nullopt;
  }
  if (const std::optional<Lack> lack = lack_of(model, *request)) {
    report.add({lack->code, span, in_backticks(name) + " " + lack->reason, "", lack->related,
                lack->related_message});
    return std::nullopt;
  }
  request->span = span;
  return request;
}

std::vector<OutputRequest> full_requests(const Model& model) {
  std::vector<OutputRequest> result;
  for (OutputRequest& request : all_requests(model)) {
    const bool is_given = !is_named_only(output_row(request.kind));
    if (is_given && fits_in_full(request) && is_available(model, request)) {
      result.push_back(std::move(request));
    }
  }
  return result;
}

std::vector<LeftOut> left_out_of_full(const Model& model) {
  const Expression* kink = find_kink(model);
  LeftOut kinked{LeftOutReason::kinked_force, {}, kink == nullptr ? Span{} : kink->span};
  LeftOut large{LeftOutReason::too_many_entries, {}, model.name_span};
  for (const OutputRequest& request : all_requests(model)) {
    if (kink != nullptr && output_row(request.kind).differentiates) {
      kinked.outputs.push_back(request.name);
    } else if (!fits_in_full(request) && is_available(model, request)) {
      large.outputs.push_back(request.name);
    }
  }
  std::vector<LeftOut> all{std::move(large), std::move(kinked)};
  std::erase_if(all, [](const LeftOut& left_out) { return left_out.outputs.empty(); });
  return all;
}

void check_output_names(const Model& model, Report& report) {
  std::map<std::string, Span> taken;
  for (std::uint32_t user = 0; user < model.outputs.size(); ++user) {
    const Span& span = model.outputs[user].span;
    for (const OutputRow& row : output_table()) {
      const bool exists =
          row.of_user && (row.requirement == Requirement::nothing || model.outputs[user].jacobian);
      if (!exists) continue;
      const OutputRequest request = request_of(model, row.kind, user);
      const bool is_built_in = find_output(request.name) != nullptr;
      if (is_built_in || !taken.emplace(request.name, span).second) {
        report.add(Code::E609, span,
                   "another output is already called " + in_backticks(request.name));
      }
    }
  }
}

}  // namespace elgen
