// player_model_json: builds each list that the page's script needs, in one function per list.
#include "run/player/player_model.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/fill_template.hpp"
#include "base/json.hpp"
#include "elgen/real.hpp"
#include "elgen/references.hpp"
#include "elgen/wording.hpp"
#include "emit/interface/code_interface.hpp"
#include "model/kinks.hpp"
#include "model/output_units.hpp"
#include "model/shown_places.hpp"
#include "program/evaluate/conservation.hpp"
#include "run/steps/methods.hpp"
#include "run/steps/system.hpp"

namespace elgen {
namespace {

Json coordinates_json(const Model& model) {
  Json list = Json::array();
  for (const Coordinate& c : model.coordinates) {
    list.push_back({{"name", c.name},
                    {"unit", c.unit_text},
                    {"start", to_double(c.start_value)},
                    {"wraps", c.wraps}});
  }
  return list;
}

Json velocities_json(const Model& model, const LeafNames& leaves) {
  Json list = Json::array();
  for (std::size_t i = 0; i < model.velocities.size(); ++i) {
    const Velocity& v = model.velocities[i];
    list.push_back({{"name", leaf_text(leaves, Opcode::velocity, static_cast<std::uint32_t>(i))},
                    {"start", to_double(v.start_rate)},
                    {"coordinate", v.coordinate}});
  }
  return list;
}

/// [index, low, high] of each input with a law. Low and high are minus and plus the largest double
/// if the input has no limits, or if the law is constant along a run and therefore not clamped.
Json laws_json(const CheckedModel& checked) {
  const Model& model = checked.model;
  constexpr double most = std::numeric_limits<double>::max();
  Json list = Json::array();
  for (std::size_t k = 0; k < model.inputs.size(); ++k) {
    const Input& input = model.inputs[k];
    const ExpressionId* const law = find_law(checked.scene, input);
    if (law == nullptr) continue;
    const bool is_cut = input.limits && !is_constant_along_run(model, *law);
    list.push_back({k, is_cut ? to_double(input.limits->low) : -most,
                    is_cut ? to_double(input.limits->high) : most});
  }
  return list;
}

Json parameters_json(const Model& model, const Program& program, LanguageId language) {
  Json list = Json::array();
  for (const ParameterArray& array : emitted_parameters(model, program)) {
    for (std::uint32_t i = 0; i < array.count; ++i) {
      list.push_back({{"name", model.parameters[array.first + i].name},
                      {"member", name_in_language(language, array.name)},
                      {"element", array.is_array ? Json(i) : Json(nullptr)}});
    }
  }
  return list;
}

Json multipliers_json(const Model& model) {
  Json list = Json::array();
  for (const Constraint& constraint : model.constraints) {
    list.push_back({{"name", constraint.name}});
  }
  return list;
}

Json integrals_json(const Model& model) {
  Json list = Json::array();
  for (const ExpressionId id : shown_integrals(model)) {
    list.push_back(to_string(model, id));
  }
  return list;
}

/// The index of each place's first row in the output that contains all places.
std::vector<std::size_t> first_rows(const Model& model, const std::vector<ShownPlace>& places) {
  std::vector<std::size_t> rows;
  std::size_t next = 0;
  for (const ShownPlace& place : places) {
    rows.push_back(next);
    next += place_coordinates(model, place).size() / 3;
  }
  return rows;
}

bool is_zero(const Model& model, ExpressionId id) {
  const Expression& e = model.expressions[id];
  return e.kind == ExpressionKind::number && cln::zerop(e.number);
}

/// True if the z component of every place is the number 0, and no place is a frame.
bool is_planar(const Model& model, const std::vector<ShownPlace>& places) {
  return std::ranges::all_of(places, [&](const ShownPlace& place) {
    return place.kind != PlaceKind::frame && is_zero(model, place_coordinates(model, place)[2]);
  });
}

/// The last axis along which gravity is not the number 0; z if there is no gravity.
std::size_t up_axis(const Model& model) {
  if (!model.gravity) return 2;
  std::size_t up = 2;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!is_zero(model, (*model.gravity)[i])) up = i;
  }
  return up;
}

void add_places(Json& json, const Model& model) {
  const std::vector<ShownPlace> places = shown_places(model);
  const std::vector<std::size_t> rows = first_rows(model, places);
  Json list = Json::array();
  std::size_t masses = 0;
  std::size_t trail = rows.empty() ? 0 : rows.back();
  for (std::size_t i = 0; i < places.size(); ++i) {
    list.push_back({{"row", rows[i]},
                    {"is_frame", places[i].kind == PlaceKind::frame},
                    {"mass", places[i].mass ? Json(masses++) : Json(nullptr)}});
    if (places[i].kind == PlaceKind::point) trail = rows[i];
  }
  Json lines = Json::array();
  for (const auto& [from, to, is_spring] : shown_lines(model)) {
    lines.push_back({rows[from], to ? Json(rows[*to]) : Json(nullptr), is_spring});
  }
  json["places"] = std::move(list);
  json["lines"] = std::move(lines);
  json["trail"] = trail;
  json["is_planar"] = is_planar(model, places);
  json["up"] = up_axis(model);
}

/// The values of the coordinates: "theta = 3.14159". Omits coordinates that are at rest at any
/// value.
std::string rest_point_label(const Model& model, const RestPoint& point) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < point.coordinates.size(); ++i) {
    const RestCoordinate& at = point.coordinates[i];
    if (at.is_arbitrary) continue;
    parts.push_back(
        fmt::format("{} = {:.6g}", model.coordinates[i].name, to_double(at.value) + 0.0));
  }
  return parts.empty() ? "anywhere" : fmt::format("{}", fmt::join(parts, ", "));
}

/// A start at rest: the equilibrium `point` plus 0.1 times the shape of `mode`.
ShownStart mode_start(const Model& model, const RestPoint& point, const NormalMode& mode) {
  constexpr double part = 0.1;
  const double omega = std::sqrt(to_double(mode.omega_squared));
  ShownStart start{fmt::format("Mode of {:.4g} rad/s: {}", omega, rest_point_label(model, point))};
  for (const cln::cl_R& value : point.state.q) start.q.push_back(to_double(value) + 0.0);
  for (std::size_t i = 0; i < mode.shape.size(); ++i) {
    start.q[model.velocities[i].coordinate] += part * mode.shape[i];
  }
  return start;
}

/// Simulated seconds per real second: 1 if the run takes 2 to 60 s; otherwise the pace that shows
/// the whole run in 20 s.
double playback_pace(const SimulationOptions& options) {
  constexpr double shortest = 2;
  constexpr double longest = 60;
  constexpr double watched = 20;
  const bool is_watched = shortest <= options.duration && options.duration <= longest;
  return is_watched ? 1 : options.duration / watched;
}

/// For each kink: the rows of its arguments in the output `kinks`, and its text.
Json kinks_json(const CheckedModel& checked) {
  const auto& [model, scene] = checked;
  Json list = Json::array();
  const auto shown = std::ranges::find_if(
      scene.page_outputs, [](const auto& output) { return output.second == ShownValues::kinks; });
  if (shown == scene.page_outputs.end()) return list;
  const std::vector<ExpressionId>& values = model.outputs[shown->first].values;
  for (const KinkedCall& kink : kinked_calls(model, laws_of(model, scene))) {
    const Expression& call = model.expressions[kink.call];
    Json rows = Json::array();
    for (const ExpressionId argument : call.operands) {
      rows.push_back(std::ranges::find(values, argument) - values.begin());
    }
    list.push_back({{"rows", rows},
                    {"is_of_law", kink.is_of_law},
                    {"rate", kink.rate ? Json(*kink.rate) : Json(nullptr)},
                    {"text", in_backticks(call.span)}});
  }
  return list;
}

/// The script finds the method by these keys: with `pair` it is dopri5, with `step` all steps have
/// this length.
Json run_json(const SimulationOptions& options) {
  const MethodRow method = *find_method(options);
  const StepRule rule = *step_rule(method, options);
  Json json{
      {"from", options.from}, {"projects", options.projects}, {"pace", playback_pace(options)}};
  if (method.step_kind == StepKind::adaptive) {
    const EmbeddedPair pair = dopri5_pair();
    json["pair"] = {{"rows", pair.rows}, {"instants", pair.instants}, {"errors", pair.errors}};
  }
  if (rule.step) {
    json["step"] = *rule.step;
    return json;
  }
  json["tolerance"] = rule.tolerance;
  json["shortest"] = rule.shortest_step;
  json["too_short"] = step_too_short;
  json["slides"] = slides_along;
  return json;
}

}  // namespace

std::vector<ShownStart> shown_starts(const Model& model, const Products& read) {
  constexpr std::size_t most = 12;
  std::vector<ShownStart> starts;
  if (!read.equilibria) return starts;
  for (const RestPoint& point : read.equilibria->points) {
    ShownStart start{fmt::format("At rest: {}{}", rest_point_label(model, point),
                                 is_stable(point.stability.kind) ? " (stable)" : "")};
    for (const cln::cl_R& value : point.state.q) start.q.push_back(to_double(value) + 0.0);
    starts.push_back(std::move(start));
  }
  const bool has_modes = read.modes && model.rotations.empty();
  for (const LinearMotions& motions :
       has_modes ? read.modes->motions : std::vector<LinearMotions>{}) {
    for (const NormalMode& mode : motions.modes) {
      if (cln::plusp(mode.omega_squared)) starts.push_back(mode_start(model, motions.point, mode));
    }
  }
  if (starts.size() > most) starts.resize(most);
  return starts;
}

std::string player_model_json(const CheckedModel& checked, const Program& program,
                              const Products& read, const SimulationOptions& options) {
  const Model& model = checked.model;
  const bool is_driven = !model.inputs.empty();
  const Conservation conservation = find_conservation(model, program, is_driven, false);
  Json json;
  json["coordinates"] = coordinates_json(model);
  json["velocities"] = velocities_json(model, program.leaves);
  json["inputs"] = model.inputs.size();
  json["laws"] = laws_json(checked);
  json["parameters"] = parameters_json(model, program, checked.scene.emission.language);
  json["multipliers"] = multipliers_json(model);
  json["integrals"] = integrals_json(model);
  add_places(json, model);
  json["kinks"] = kinks_json(checked);
  json["starts"] = Json::array();
  for (const ShownStart& start : shown_starts(model, read)) json["starts"].push_back(start.q);
  json["power"] = {{"has_time", conservation.has_time},
                   {"is_forced", conservation.is_forced},
                   {"has_moving_constraints", has_moving_constraints(model)}};
  json["is_whole"] = has_combined_lagrangian(model);
  json["unit_of_energy"] = has_units(model) ? "J" : "";
  json["run"] = run_json(options);
  return escape_markup(json.dump(-1, true), {{'<', "\\u003c"}});
}

}  // namespace elgen
