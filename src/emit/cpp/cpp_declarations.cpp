// cpp_declarations: an array is one line where it fits, one element a line where not.
#include "emit/cpp/cpp_declarations.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "check/judge/output_units.hpp"
#include "emit/code/cpp_constant.hpp"
#include "emit/text/parameters.hpp"
#include "evaluate/scalar_literal.hpp"

namespace elgen {
namespace {

using Texts = std::vector<std::string>;

/// "{{1, 2}}", or `{}` for no elements; doubled braces name the array inside std::array.
std::string braced(const Texts& elements, std::size_t column) {
  if (elements.empty()) return "{}";
  const std::string line = fmt::format("{{{{{}}}}}", fmt::join(elements, ", "));
  if (column + line.size() < line_width) return line;
  return fmt::format("{{{{\n    {},\n}}}}", fmt::join(elements, ",\n    "));
}

TemplateData declared(const char* type, const char* name, const Texts& elements) {
  const std::string count = std::to_string(elements.size());
  const std::size_t column =
      fmt::format("inline constexpr std::array<{}, {}> {};", type, count, name).size();
  TemplateData item;
  item.set("type", type);
  item.set("count", count);
  item.set("name", name);
  item.set("value", braced(elements, column));
  return item;
}

std::string bound(const cln::cl_R& value, const char* unbounded) {
  const bool is_finite = fit(value, ScalarKind::double_precision) != Fit::too_large;
  return is_finite ? shortest_literal(value, ScalarKind::double_precision) : unbounded;
}

std::string interval(const std::optional<Interval>& range) {
  if (!range) return "{-unbounded, unbounded}";
  return fmt::format("{{{}, {}}}", bound(range->low, "-unbounded"),
                     bound(range->high, "unbounded"));
}

template <class Element, class Text>
Texts each(const std::vector<Element>& elements, const Text& text) {
  Texts texts;
  std::transform(elements.begin(), elements.end(), std::back_inserter(texts), text);
  return texts;
}

Texts parameter_values(const Model& model, const ParameterArray& array) {
  Texts values;
  for (std::uint32_t i = 0; i < array.count; ++i) {
    values.push_back(cpp_constant(model.parameters[array.first + i].value));
  }
  return values;
}

bool is_filled(const Model& model, const ParameterArray& array) {
  const Texts values = parameter_values(model, array);
  const auto is_first = [&values](const std::string& value) { return value == values.front(); };
  return array.is_array && array.count > 1 && std::all_of(values.begin(), values.end(), is_first);
}

std::string member_declaration(const Model& model, const ParameterArray& array) {
  const Texts values = parameter_values(model, array);
  if (!array.is_array) return fmt::format("Scalar {} = {};", array.name, values.front());
  const std::string start = fmt::format("std::array<Scalar, {}> {} = ", array.count, array.name);
  if (is_filled(model, array)) {
    return fmt::format("{}detail::filled<{}>({});", start, array.count, values.front());
  }
  return fmt::format("{}{{{{\n      {},\n  }}}};", start, fmt::join(values, ",\n      "));
}

}  // namespace

TemplateData declared_arrays(const Model& model) {
  TemplateData list(TemplateData::type::list);
  const std::vector<Coordinate>& coordinates = model.coordinates;
  const std::vector<Velocity>& velocities = model.velocities;
  const std::vector<Input>& inputs = model.inputs;
  const auto name = [](const auto& variable) { return string_literal(variable.name); };
  const auto unit = [](const auto& variable) { return string_literal(variable.unit_text); };
  const char* const text = "const char*";
  list << declared(text, "coordinate_names", each(coordinates, name));
  list << declared(text, "coordinate_units", each(coordinates, unit));
  list << declared("Interval", "coordinate_ranges",
                   each(coordinates, [](const Coordinate& c) { return interval(c.range); }));
  // Where nothing rotates, velocities are called as their coordinates.
  if (!model.rotations.empty()) {
    list << declared(text, "velocity_names", each(velocities, name));
    list << declared(text, "velocity_units", each(velocities, [&](const Velocity& v) {
                       return string_literal(velocity_unit(model, v));
                     }));
  }
  list << declared("Interval", "rate_ranges",
                   each(velocities, [](const Velocity& v) { return interval(v.rate_range); }));
  list << declared(text, "input_names", each(inputs, name));
  list << declared(text, "input_units", each(inputs, unit));
  list << declared("Interval", "input_limits",
                   each(inputs, [](const Input& i) { return interval(i.limits); }));
  return list;
}

std::vector<Member> declared_parameters(const Model& model,
                                        const std::vector<ParameterArray>& arrays) {
  std::vector<Member> members;
  for (const ParameterArray& array : arrays) {
    members.push_back({member_declaration(model, array), parameter_doc(array)});
  }
  return members;
}

bool has_filled_array(const Model& model, const std::vector<ParameterArray>& arrays) {
  return std::any_of(arrays.begin(), arrays.end(),
                     [&](const ParameterArray& array) { return is_filled(model, array); });
}

}  // namespace elgen
