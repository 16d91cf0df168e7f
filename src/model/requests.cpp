// Requests: which outputs a model has, and their shapes.
#include "model/requests.hpp"

#include <algorithm>
#include <map>

#include "elgen/inertial_parameters.hpp"
#include "model/lacks.hpp"

namespace elgen {
namespace {

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
std::vector<std::string> available_names(const Model& model,
                                         const std::vector<std::uint32_t>& independent) {
  std::vector<std::string> names;
  for (OutputRequest& request : all_requests(model)) {
    request.independent = independent;
    if (is_available(model, request)) names.push_back(request.name);
  }
  return names;
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
      return static_cast<std::uint32_t>(inertial_places(model).size());
    case Extent::user:
      return model.outputs[user].frame
                 ? 3
                 : static_cast<std::uint32_t>(model.outputs[user].values.size());
    case Extent::user_columns:
      return model.outputs[user].frame ? 4 : 1;
    case Extent::accelerations:
      return model.outputs[user].motion ? 0 : extent_of(model, Extent::velocities);
    case Extent::task:
      return model.outputs[user].frame ? 6 : extent_of(model, Extent::user, user);
    case Extent::one:
      break;
  }
  return 1;
}

std::vector<LineLabel> line_labels(const Model& model, const FieldLines& lines) {
  std::vector<LineLabel> labels;
  const auto add = [&labels](const auto& list, bool is_rate = false) {
    for (const auto& entry : list) labels.push_back({entry.name, is_rate});
  };
  const auto add_velocity = [&](std::uint32_t i) {
    labels.push_back({whole_of(model).velocities[i].name});
  };
  switch (lines.extent) {
    case Extent::one:
    case Extent::user:
    case Extent::user_columns:
    case Extent::task:
      for (std::uint32_t i = 1; i <= lines.count; ++i) labels.push_back({std::to_string(i)});
      break;
    case Extent::coordinates:
      add(model.coordinates);
      break;
    case Extent::velocities:
      add(model.velocities);
      break;
    case Extent::accelerations:
      if (!model.outputs[lines.user].motion) add(model.velocities);
      break;
    case Extent::states:
      add(model.velocities);
      add(model.velocities, true);
      break;
    case Extent::inputs:
      add(model.inputs);
      break;
    case Extent::held:
      for (const std::uint32_t velocity : held_velocities(model)) add_velocity(velocity);
      break;
    case Extent::cyclic:
      if (!has_routhian(model)) break;
      for (const Cyclic& cyclic : model.variant.cyclic) add_velocity(cyclic.velocity);
      break;
    case Extent::constraints:
      add(model.constraints);
      break;
    case Extent::positions:
      for (const Constraint& constraint : model.constraints) {
        if (constraint.is_position) labels.push_back({constraint.name});
      }
      break;
    case Extent::pivots:
      add(model.velocities);
      add(model.constraints);
      break;
    case Extent::inertial:
      add(inertial_parameters(model));
      break;
  }
  return labels;
}

std::uint32_t first_entry_of(const Model& model, const OutputRequest& output, std::size_t field) {
  const auto& fields = output_row(output.kind).fields;
  std::uint32_t first = 0;
  for (const FieldRow& row : fields.first(field)) {
    first += extent_of(model, row.rows, output.user) * extent_of(model, row.columns, output.user);
  }
  return first;
}

bool gives_field(const OutputRequest& output, const FieldRow& field) {
  if (!field.is_remainder || !output_row(output.kind).steps) return true;
  return output.step && output.step->iterations > 0;
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
  return request;
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
                                             const Span& span, Report& report,
                                             const std::vector<std::uint32_t>& independent) {
  std::optional<OutputRequest> request = find_request(model, name);
  if (!request) {
    report.add(Code::E601, span, "unknown output " + in_backticks(name),
               suggestion(name, available_names(model, independent)));
    return std::nullopt;
  }
  if (request->kind == OutputKind::completed) request->independent = independent;
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
    if (is_named_only(output_row(request.kind))) continue;
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
          row.of_user && (!row.needs.has(Need::jacobian) || model.outputs[user].jacobian);
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
