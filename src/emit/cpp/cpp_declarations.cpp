// cpp_declarations: an array is one line where it fits, one element a line where not.
#include "emit/cpp/cpp_declarations.hpp"

#include <fmt/format.h>

#include <algorithm>

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

std::string bound(const cln::cl_R& value, const char* unbounded) {
  const bool is_finite = fit(value, ScalarKind::double_precision) != Fit::too_large;
  return is_finite ? shortest_literal(value, ScalarKind::double_precision) : unbounded;
}

std::string interval(const std::optional<Interval>& range) {
  if (!range) return "{-unbounded, unbounded}";
  return fmt::format("{{{}, {}}}", bound(range->low, "-unbounded"),
                     bound(range->high, "unbounded"));
}

TemplateData declared(const DeclaredArray& array) {
  Texts elements;
  for (const std::string& text : array.texts) elements.push_back(string_literal(text));
  for (const auto& range : array.intervals) elements.push_back(interval(range));
  const std::string type = array.has_texts ? "const char*" : "Interval";
  const std::string count = std::to_string(array.size());
  const std::size_t column =
      fmt::format("inline constexpr std::array<{}, {}> {};", type, count, array.name).size();
  TemplateData item;
  item.set("type", type);
  item.set("count", count);
  item.set("name", array.name);
  item.set("value", braced(elements, column));
  return item;
}

Texts parameter_values(const Model& model, const ParameterArray& array) {
  Texts texts;
  for (const cln::cl_R& value : values_of(model, array)) texts.push_back(cpp_constant(value));
  return texts;
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

TemplateData declarations(const Model& model) {
  TemplateData list(TemplateData::type::list);
  for (const DeclaredArray& array : declared_arrays(model)) list << declared(array);
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
