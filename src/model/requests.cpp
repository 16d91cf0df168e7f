// Requests: the outputs of a model, the shapes of their fields, and the names of rows and columns.
#include "model/requests.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <string_view>

#include "elgen/inertial_parameters.hpp"
#include "model/unmet_needs.hpp"

namespace elgen {
namespace {

/// Requests for all outputs in the order of the table; user outputs of the same kind are in the
/// order of declaration.
std::vector<OutputRequest> all_requests(const Model& model) {
  std::vector<OutputRequest> result;
  for (const OutputRow& row : output_table()) {
    const std::size_t count = row.is_user_output ? model.outputs.size() : 1;
    for (std::uint32_t user = 0; user < count; ++user) {
      result.push_back(make_request(model, row.kind, user));
    }
  }
  return result;
}

/// Sets `request.independent` if the output has the option `independent`.
void set_independent_velocities(const std::vector<std::uint32_t>& velocities,
                                OutputRequest& request) {
  const EnumSet<OutputOption>& options = output_row(request.kind).options;
  if (options.has(OutputOption::independent)) request.independent = velocities;
}

/// For suggestions, the names of all outputs that the model can provide, including large outputs.
std::vector<std::string> available_names(const Model& model,
                                         const std::vector<std::uint32_t>& independent) {
  std::vector<std::string> names;
  for (OutputRequest& request : all_requests(model)) {
    set_independent_velocities(independent, request);
    if (is_available(model, request)) names.push_back(request.name);
  }
  return names;
}

/// The extent of the rows or columns of a field. `user` is the index of the [[output]].
struct LineExtent {
  Extent extent = {};
  std::uint32_t user = 0;
};

/// Returns a function that makes the FieldLine of an entry with a leaf of the kind `leaf`.
auto leaf_line_maker(Opcode leaf, bool is_rate = false) {
  return [leaf, is_rate](const auto& entry, std::uint32_t number) {
    return FieldLine{entry.name, entry.unit, leaf, number, is_rate};
  };
}

FieldLine constraint_line(const Constraint& constraint, std::uint32_t number) {
  const bool has_rate = constraint.is_position && constraint.unit;
  return {constraint.name, has_rate ? *constraint.unit / *find_unit("s") : constraint.unit,
          Opcode::multiplier, number};
}

using LineNames = std::span<const std::string_view>;

// The rows of a pose [R p] are the axes of the world; the columns are the axes and the origin of
// the frame. The rows of a twist are the angular velocity, then the velocity of the origin.
constexpr std::array<std::string_view, 3> rows_of_pose{"x", "y", "z"};
constexpr std::array<std::string_view, 4> columns_of_pose{"x", "y", "z", "p"};
constexpr std::array<std::string_view, 6> rows_of_twist{"wx", "wy", "wz", "vx", "vy", "vz"};
constexpr std::array<std::string_view, 1> no_name{""};

FieldLine line_of_word(std::string_view word, std::uint32_t number) {
  return {.name = std::string(word), .number = number, .is_numbered = true};
}

/// Calls `take` for the values of an [[output]]. If the output is a frame, calls `take` for the
/// names `of_frame` instead.
template <class Take>
void visit_value_lines(const UserOutput& output, LineNames of_frame, const Take& take) {
  if (output.frame) return take(of_frame, line_of_word);
  take(output.values, [&output](ExpressionId, std::uint32_t number) {
    if (output.values.size() == 1) return line_of_word("", number);
    return line_of_word(fmt::format("{}[{}]", output.name, number + 1), number);
  });
}

std::vector<std::uint32_t> position_constraints(const Model& model) {
  std::vector<std::uint32_t> positions;
  for (std::uint32_t i = 0; i < model.constraints.size(); ++i) {
    if (model.constraints[i].is_position) positions.push_back(i);
  }
  return positions;
}

/// Calls take(list, line_of) for each list of entries along an extent. line_of(entry, number)
/// returns the FieldLine of an entry; `take` need not call line_of().
template <class Take>
void visit_line_lists(const Model& model, const LineExtent& along, const Take& take) {
  const auto of_whole = [&model](std::uint32_t velocity, std::uint32_t) {
    const Velocity& held = unreduced_model(model).velocities[velocity];
    return FieldLine{held.name, held.unit, {}, velocity};
  };
  const auto of_position = [&model](std::uint32_t i, std::uint32_t) {
    return leaf_line_maker(Opcode::multiplier)(model.constraints[i], i);
  };
  const auto of_cyclic = [&of_whole](const CyclicCoordinate& cyclic, std::uint32_t number) {
    return of_whole(cyclic.velocity, number);
  };
  const auto of_parameter = [&model](const InertialEntry& place, std::uint32_t number) {
    InertialParameter parameter = inertial_parameter(model, place);
    return FieldLine{std::move(parameter.name), parameter.unit, {}, number};
  };
  switch (along.extent) {
    case Extent::one:
      return take(LineNames(no_name), [](auto, auto) { return FieldLine{.unit = Unit{}}; });
    case Extent::coordinates:
      return take(model.coordinates, leaf_line_maker(Opcode::coordinate));
    case Extent::velocities:
      return take(model.velocities, leaf_line_maker(Opcode::velocity));
    case Extent::accelerations:
      if (model.outputs[along.user].solves_motion) return;
      return take(model.velocities, leaf_line_maker(Opcode::acceleration));
    case Extent::states:
      take(model.velocities, leaf_line_maker(Opcode::velocity));
      return take(model.velocities, leaf_line_maker(Opcode::velocity, true));
    case Extent::inputs:
      return take(model.inputs, leaf_line_maker(Opcode::input));
    case Extent::reaction:
      return take(reaction_row_velocities(model), of_whole);
    case Extent::cyclic:
      if (!has_routhian(model)) return;
      return take(model.reduction.cyclic, of_cyclic);
    case Extent::constraints:
      return take(model.constraints, constraint_line);
    case Extent::positions:
      return take(position_constraints(model), of_position);
    case Extent::pivots:
      take(model.velocities, leaf_line_maker(Opcode::velocity));
      return take(model.constraints, leaf_line_maker(Opcode::multiplier));
    case Extent::inertial:
      return take(inertial_entries(model), of_parameter);
    case Extent::user:
      return visit_value_lines(model.outputs[along.user], rows_of_pose, take);
    case Extent::user_columns:
      return take(model.outputs[along.user].frame ? LineNames(columns_of_pose) : LineNames(no_name),
                  line_of_word);
    case Extent::task:
      return visit_value_lines(model.outputs[along.user], rows_of_twist, take);
  }
}

bool fits_full_scene(const OutputRequest& request) {
  return std::uint64_t{request.rows} * request.columns <= max_entries_in_full;
}

}  // namespace

std::string_view name_of(OmissionReason reason) {
  return reason == OmissionReason::too_many_entries ? "too many entries" : "kinked force";
}

const OutputRequest* find_request(const Scene& scene, std::string_view name) {
  const auto found = std::ranges::find(scene.outputs, name, &OutputRequest::name);
  return found == scene.outputs.end() ? nullptr : &*found;
}

std::uint32_t extent_size(const Model& model, Extent extent, std::uint32_t user) {
  std::size_t count = 0;
  visit_line_lists(model, {extent, user},
                   [&count](auto&& list, const auto&) { count += list.size(); });
  return static_cast<std::uint32_t>(count);
}

std::vector<FieldLine> extent_lines(const Model& model, Extent extent, std::uint32_t user) {
  std::vector<FieldLine> lines;
  visit_line_lists(model, {extent, user}, [&lines](auto&& list, const auto& line_of) {
    std::uint32_t number = 0;
    for (const auto& entry : list) lines.push_back(line_of(entry, number++));
  });
  return lines;
}

std::optional<FieldLine> line_at(const Model& model, Extent extent, std::size_t at,
                                 std::uint32_t user) {
  std::optional<FieldLine> line;
  visit_line_lists(model, {extent, user}, [&](auto&& list, const auto& line_of) {
    if (line) return;
    if (at < list.size()) {
      line = line_of(list[at], static_cast<std::uint32_t>(at));
    } else {
      at -= list.size();
    }
  });
  return line;
}

std::vector<std::string> names_without_leaf(const Model& model, Extent extent) {
  std::vector<std::string> names;
  for (const FieldLine& line : extent_lines(model, extent)) {
    const bool is_unlisted = !line.leaf && !line.is_numbered && !line.name.empty();
    if (is_unlisted) names.push_back(line.name);
  }
  return names;
}

std::uint32_t first_entry_index(const Model& model, const OutputRequest& output,
                                std::size_t field) {
  const auto& fields = output_row(output.kind).fields;
  std::uint32_t first = 0;
  for (const FieldRow& row : fields.first(field)) {
    first +=
        extent_size(model, row.rows, output.user) * extent_size(model, row.columns, output.user);
  }
  return first;
}

bool has_field(const OutputRequest& output, const FieldRow& field) {
  if (!field.is_residual || !output_row(output.kind).is_step) return true;
  return output.step && output.step->iterations > 0;
}

OutputRequest make_request(const Model& model, OutputKind kind, std::uint32_t user) {
  const OutputRow& row = output_row(kind);
  OutputRequest request;
  request.kind = kind;
  request.user = user;
  request.argument_kinds = row.is_user_output
                               ? row.argument_kinds | model.outputs[user].argument_kinds
                               : row.argument_kinds;
  request.omits_pivots = row.gives_pivots && model.omits_pivots;
  request.name = row.is_user_output ? model.outputs[user].name + std::string(row.suffix)
                                    : std::string(row.name);
  if (!row.fields.empty()) {
    request.rows = extent_size(model, row.fields.front().rows, user);
    request.columns = extent_size(model, row.fields.front().columns, user);
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
  return !find_unmet_need(model, request);
}

std::vector<OutputRequest> available_requests(const Model& model,
                                              std::initializer_list<OutputKind> kinds) {
  std::vector<OutputRequest> requests;
  for (const OutputKind kind : kinds) {
    OutputRequest request = make_request(model, kind, 0);
    if (is_available(model, request)) requests.push_back(std::move(request));
  }
  return requests;
}

std::optional<OutputRequest> require_request(const Model& model, std::string_view name,
                                             const Span& span, Report& report,
                                             const std::vector<std::uint32_t>& independent) {
  std::optional<OutputRequest> request = find_request(model, name);
  if (!request) {
    const std::vector<std::string> names = available_names(model, independent);
    const auto named = std::ranges::find_if(output_table(), [&](const OutputRow& row) {
      const bool is_symbol = row.symbol.text == name || row.symbol.text == std::string(name) + "0";
      return is_symbol && std::ranges::count(names, row.name) > 0;
    });
    report.add(Code::E601, span, "unknown output " + quote_text(name),
               named == output_table().end() ? suggestion(name, names)
                                             : quote_text(name) + " is " + quote_text(named->name));
    return std::nullopt;
  }
  set_independent_velocities(independent, *request);
  if (const std::optional<UnmetNeed> lack = find_unmet_need(model, *request)) {
    report.add({lack->code, span, quote_text(name) + " " + lack->reason, "", lack->related,
                lack->related_message});
    return std::nullopt;
  }
  request->span = span;
  return request;
}

std::vector<OutputRequest> full_scene_requests(const Model& model) {
  std::vector<OutputRequest> result;
  for (OutputRequest& request : all_requests(model)) {
    const bool is_given = !is_omitted_by_full(output_row(request.kind));
    if (is_given && fits_full_scene(request) && is_available(model, request)) {
      result.push_back(std::move(request));
    }
  }
  return result;
}

std::vector<OmittedOutputs> outputs_omitted_by_full(const Model& model) {
  const Expression* kink = find_kink(model);
  OmittedOutputs kinked{OmissionReason::kinked_force, {}, kink == nullptr ? Span{} : kink->span};
  OmittedOutputs large{OmissionReason::too_many_entries, {}, model.name_span};
  for (const OutputRequest& request : all_requests(model)) {
    if (is_omitted_by_full(output_row(request.kind))) continue;
    if (kink != nullptr && output_row(request.kind).differentiates) {
      kinked.outputs.push_back(request.name);
    } else if (!fits_full_scene(request) && is_available(model, request)) {
      large.outputs.push_back(request.name);
    }
  }
  std::vector<OmittedOutputs> all{std::move(large), std::move(kinked)};
  std::erase_if(all, [](const OmittedOutputs& left_out) { return left_out.outputs.empty(); });
  return all;
}

void check_output_names(const Model& model, Report& report) {
  std::map<std::string, Span> used_names;
  for (std::uint32_t user = 0; user < model.outputs.size(); ++user) {
    const Span& span = model.outputs[user].span;
    for (const OutputRow& row : output_table()) {
      const bool exists = row.is_user_output &&
                          (!row.needs.has(Need::jacobian) || model.outputs[user].has_jacobian);
      if (!exists) continue;
      const OutputRequest request = make_request(model, row.kind, user);
      const bool is_built_in = find_output(request.name) != nullptr;
      if (is_built_in || !used_names.emplace(request.name, span).second) {
        report.add(Code::E609, span,
                   "another output is already called " + quote_text(request.name));
      }
    }
  }
}

}  // namespace elgen
