// player_model_json: builds each list that the page's script needs, in one function per list.
#include "run/player/player_model.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "analyse/formulas.hpp"
#include "base/fill_template.hpp"
#include "base/json.hpp"
#include "elgen/analysis_pages.hpp"
#include "elgen/page.hpp"
#include "elgen/real.hpp"
#include "elgen/references.hpp"
#include "elgen/wording.hpp"
#include "emit/interface/code_interface.hpp"
#include "model/kinks.hpp"
#include "model/output_units.hpp"
#include "model/shown_places.hpp"
#include "model/symbols.hpp"
#include "program/evaluate/conservation.hpp"
#include "run/player/player_places.hpp"
#include "run/steps/methods.hpp"
#include "run/steps/system.hpp"

namespace elgen {
namespace {

/// The largest magnitude in a declared range; 0 if no range is declared.
double largest_in_range(const std::optional<Interval>& range) {
  return range ? std::max(std::abs(to_double(range->low)), std::abs(to_double(range->high))) : 0;
}

Json coordinates_json(const Model& model, const LeafValues<Formula>& symbols) {
  Json list = Json::array();
  for (std::size_t i = 0; i < model.coordinates.size(); ++i) {
    const Coordinate& c = model.coordinates[i];
    list.push_back({{"name", c.name},
                    {"symbol", unicode_text(symbols.q[i])},
                    {"unit", unicode_unit(c.unit_text)},
                    {"range", largest_in_range(c.range)},
                    {"start", to_double(c.start_value)},
                    {"wraps", c.wraps}});
  }
  return list;
}

Json velocities_json(const Model& model, const LeafNames& leaves,
                     const LeafValues<Formula>& symbols) {
  Json list = Json::array();
  for (std::size_t i = 0; i < model.velocities.size(); ++i) {
    const Velocity& v = model.velocities[i];
    list.push_back({{"name", leaf_text(leaves, Opcode::velocity, static_cast<std::uint32_t>(i))},
                    {"symbol", unicode_text(symbols.v[i])},
                    {"unit", unicode_unit(velocity_unit_text(model, v))},
                    {"range", largest_in_range(v.rate_range)},
                    {"start", to_double(v.start_rate)},
                    {"coordinate", v.rotation ? Json(nullptr) : Json(v.coordinate)}});
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

/// The value of a parameter is p[array][key], or p[key] if `array` is null.
Json parameters_json(const Model& model, const Program& program, LanguageId language) {
  Json list = Json::array();
  for (const ParameterArray& array : emitted_parameters(model, program)) {
    for (std::uint32_t i = 0; i < array.count; ++i) {
      const std::string member = name_in_language(language, array.name);
      list.push_back({{"name", model.parameters[array.first + i].name},
                      {"array", array.is_array ? Json(member) : Json(nullptr)},
                      {"key", array.is_array ? Json(i) : Json(member)}});
    }
  }
  return list;
}

Json multipliers_json(const Model& model, const LeafValues<Formula>& symbols) {
  Json list = Json::array();
  for (std::size_t k = 0; k < model.constraints.size(); ++k) {
    list.push_back(
        {{"name", model.constraints[k].name}, {"symbol", unicode_text(symbols.multipliers[k])}});
  }
  return list;
}

Json integrals_json(const Model& model) {
  Json list = Json::array();
  for (const ExpressionId id : shown_integrals(model)) {
    list.push_back(unicode_text(expression_formula(model, id)));
  }
  return list;
}

/// Labels of points of rest, in the symbols of the model.
class RestLabels {
 public:
  RestLabels(const Model& model, const Equilibria& found)
      : model_(model), found_(found), symbols_(ModelSymbols(model).leaf_symbols()) {}

  /// The values of the coordinates: "θ₁ = 0, θ₂ = π". Omits coordinates that are at rest at any
  /// value, and coordinates that have this value at all points of rest.
  [[nodiscard]] std::string label(const RestPoint& point) const {
    std::vector<std::string> parts;
    for (std::size_t i = 0; i < point.coordinates.size(); ++i) {
      if (point.coordinates[i].is_arbitrary || (found_.points.size() > 1 && is_common(i))) continue;
      parts.push_back(
          fmt::format("{} = {}", unicode_text(symbols_.q[i]), value_text(point.coordinates[i])));
    }
    return parts.empty() ? "anywhere" : fmt::format("{}", fmt::join(parts, ", "));
  }

 private:
  [[nodiscard]] bool is_common(std::size_t i) const {
    const cln::cl_R& first = found_.points.front().coordinates[i].value;
    return std::ranges::all_of(found_.points, [&](const RestPoint& point) {
      return to_double(point.coordinates[i].value) == to_double(first);
    });
  }

  /// A closed form without parameters, such as π/2; otherwise six digits.
  [[nodiscard]] std::string value_text(const RestCoordinate& at) const {
    const Algebra& algebra = found_.forms.algebra;
    const bool is_number =
        at.closed_form && !at.inverse_argument && !contains_leaves(algebra, *at.closed_form);
    const std::optional<Formula> form =
        is_number ? readable_formula(model_, algebra, at.closed_form) : std::nullopt;
    return form ? unicode_text(*form) : fmt::format("{:.6g}", to_double(at.value) + 0.0);
  }

  const Model& model_;
  const Equilibria& found_;
  LeafValues<Formula> symbols_;
};

Numbers position_at(const RestPoint& point) {
  Numbers q;
  for (const cln::cl_R& value : point.state.q) q.push_back(to_double(value) + 0.0);
  return q;
}

/// "mode of 4.43 rad/s: θ = 0": the equilibrium plus 0.1 times the shape of the mode.
Json mode_start_json(const Model& model, const RestLabels& labels, const RestPoint& point,
                     const NormalMode& mode) {
  constexpr double part = 0.1;
  const double omega = std::sqrt(to_double(mode.omega_squared));
  Numbers q = position_at(point);
  for (std::size_t i = 0; i < mode.shape.size(); ++i) {
    q[model.velocities[i].coordinate] += part * mode.shape[i];
  }
  return {{"name", fmt::format("mode of {:.4g} rad/s: {}", omega, labels.label(point))}, {"q", q}};
}

/// Starts at rest. The equilibria, stable ones first: "θ = 0 (stable)". For models without
/// rotations, also each normal mode with omega^2 > 0 about each stable equilibrium.
Json starts_json(const Model& model, const Products& read) {
  Json starts = Json::array();
  if (!read.equilibria) return starts;
  const RestLabels labels(model, *read.equilibria);
  for (const bool is_wanted_stable : {true, false}) {
    for (const RestPoint& point : read.equilibria->points) {
      if (is_stable(point.stability.kind) != is_wanted_stable) continue;
      const std::string name = labels.label(point) + (is_wanted_stable ? " (stable)" : "");
      starts.push_back({{"name", name}, {"q", position_at(point)}});
    }
  }
  if (!read.modes || !model.rotations.empty()) return starts;
  for (const LinearMotions& motions : read.modes->motions) {
    for (const NormalMode& mode : motions.modes) {
      if (!cln::plusp(mode.omega_squared)) continue;
      starts.push_back(mode_start_json(model, labels, motions.point, mode));
    }
  }
  return starts;
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

/// With `step`, all steps have this length.
Json run_json(const SimulationOptions& options) {
  const MethodRow method = *find_method(options);
  const StepRule rule = *step_rule(method, options);
  Json json{{"method", method.name},          {"from", options.from},
            {"duration", options.duration},   {"projects", options.projects},
            {"pace", playback_pace(options)}, {"tolerance", rule.tolerance},
            {"shortest", rule.shortest_step}, {"too_short", step_too_short},
            {"slides", slides_along}};
  if (rule.step) json["step"] = *rule.step;
  return json;
}

}  // namespace

std::string player_model_json(const CheckedModel& checked, const Program& program,
                              const Products& read, const SimulationOptions& options) {
  const Model& model = checked.model;
  const bool is_driven = !model.inputs.empty();
  const Conservation conservation = find_conservation(model, program, is_driven, false);
  const LeafValues<Formula> symbols = ModelSymbols(model).leaf_symbols();
  Json json;
  json["coordinates"] = coordinates_json(model, symbols);
  json["velocities"] = velocities_json(model, program.leaves, symbols);
  json["inputs"] = Json::array();
  for (const Input& input : model.inputs) json["inputs"].push_back(input.name);
  json["laws"] = laws_json(checked);
  json["parameters"] = parameters_json(model, program, checked.scene.emission.language);
  json["multipliers"] = multipliers_json(model, symbols);
  json["integrals"] = integrals_json(model);
  add_places(json, checked, program);
  json["kinks"] = kinks_json(checked);
  json["starts"] = starts_json(model, read);
  json["power"] = {{"has_time", conservation.has_time},
                   {"is_forced", conservation.is_forced},
                   {"has_moving_constraints", has_moving_constraints(model)}};
  json["is_whole"] = has_combined_lagrangian(model);
  json["unit_of_energy"] = has_units(model) ? "J" : "";
  json["run"] = run_json(options);
  return escape_markup(json.dump(-1, true), {{'<', "\\u003c"}});
}

}  // namespace elgen
