// player_controls: a slider covers the declared range; if the model declares no range, an interval
// around the value.
#include "run/player/player_controls.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "elgen/leaf_names.hpp"
#include "elgen/real.hpp"
#include "emit/interface/code_interface.hpp"
#include "formula/glyphs.hpp"
#include "model/output_units.hpp"
#include "model/symbols.hpp"

namespace elgen {
namespace {

struct Slider {
  std::string name = {};  ///< in the model language
  Formula symbol = {};
  std::string unit = {};
  double value = 0;
  double half_width = 1;  ///< half the width of the interval, if there is no range
  std::optional<Interval> range = {};
};

double default_half_width(double value) { return value == 0 ? 1 : std::abs(value); }

TemplateData slider_data(const Slider& slider) {
  const double low = slider.range ? to_double(slider.range->low) : slider.value - slider.half_width;
  const double high =
      slider.range ? to_double(slider.range->high) : slider.value + slider.half_width;
  return TemplateRow{{"name", html_attribute_text(slider.name)},
                     {"symbol", html_attribute_text(unicode_text(slider.symbol))},
                     {"unit", html_attribute_text(unicode_unit(slider.unit))},
                     {"value", fmt::format("{}", slider.value)},
                     {"low", fmt::format("{}", std::min(low, slider.value))},
                     {"high", fmt::format("{}", std::max(high, slider.value))}};
}

using Sliders = std::vector<Slider>;
using Symbols = LeafValues<Formula>;

Sliders coordinate_sliders(const Model& model, const Symbols& symbols) {
  Sliders list;
  for (std::size_t i = 0; i < model.coordinates.size(); ++i) {
    const Coordinate& c = model.coordinates[i];
    const double start = to_double(c.start_value);
    const double reach = is_angle(c) ? std::numbers::pi : default_half_width(start);
    if (c.rotation) continue;
    list.push_back({c.name, symbols.q[i], c.unit_text, start, reach, c.range});
  }
  return list;
}

Sliders velocity_sliders(const Model& model, const LeafNames& leaves, const Symbols& symbols) {
  constexpr double turns = 5;
  Sliders list;
  for (std::size_t i = 0; i < model.velocities.size(); ++i) {
    const Velocity& v = model.velocities[i];
    const double start = to_double(v.start_rate);
    list.push_back({leaf_text(leaves, Opcode::velocity, static_cast<std::uint32_t>(i)),
                    symbols.v[i], velocity_unit_text(model, v), start,
                    turns * default_half_width(start), v.rate_range});
  }
  return list;
}

/// Sliders of the inputs that have no law.
Sliders input_sliders(const CheckedModel& checked, const Symbols& symbols) {
  const Model& model = checked.model;
  constexpr double reach = 10;
  Sliders list;
  for (std::size_t k = 0; k < model.inputs.size(); ++k) {
    const Input& input = model.inputs[k];
    if (find_law(checked.scene, input) != nullptr) continue;
    list.push_back({input.name, symbols.u[k], input.unit_text, 0, reach, input.limits});
  }
  return list;
}

Sliders parameter_sliders(const Model& model, const Program& program, const Symbols& symbols) {
  Sliders list;
  for (const ParameterArray& array : emitted_parameters(model, program)) {
    for (std::uint32_t i = 0; i < array.count; ++i) {
      const Parameter& parameter = model.parameters[array.first + i];
      const double value = to_double(parameter.value);
      std::optional<Interval> range = array.range;
      const bool is_above_zero = !range && parameter.assumption != Assumption::none;
      if (is_above_zero) range = Interval{parameter.value / 4, parameter.value * 4};
      list.push_back({parameter.name, symbols.parameters[array.first + i], array.unit_text, value,
                      default_half_width(value), range});
    }
  }
  return list;
}

}  // namespace

std::string html_attribute_text(const std::string& text) {
  return escape_markup(escape_xml(text), {{'"', "&quot;"}});
}

TemplateData slider_groups(const CheckedModel& checked, const Program& program) {
  const Model& model = checked.model;
  const Symbols symbols = ModelSymbols(model).leaf_symbols();
  constexpr std::size_t most_open = 12;  // groups with more sliders are collapsed at first
  TemplateData groups(TemplateData::type::list);
  const auto add = [&groups](const char* title, const Sliders& sliders) {
    if (sliders.empty()) return;
    groups << TemplateRow{{"title", title},
                          {"open", sliders.size() > most_open ? "" : " open"},
                          {"sliders", repeated_section(sliders, slider_data)}};
  };
  add("Start", coordinate_sliders(model, symbols));
  add("Rates at the start", velocity_sliders(model, program.leaves, symbols));
  add("Inputs", input_sliders(checked, symbols));
  add("Parameters", parameter_sliders(model, program, symbols));
  return groups;
}

}  // namespace elgen
