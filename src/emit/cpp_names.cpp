// cpp_names: the one list of names of templates/cpp/ that a user's name could collide with.
#include "cpp_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "elgen/functions.hpp"
#include "layout.hpp"

namespace elgen {
namespace {

constexpr std::array<std::string_view, 24> emitted_names{
    "Accelerations",    "Coordinates",       "Forces",           "InputMatrix",
    "Inputs",           "Interval",          "Parameters",       "Scalar",
    "SquareMatrix",     "Velocities",        "constant",         "coordinate_count",
    "coordinate_names", "coordinate_ranges", "coordinate_units", "detail",
    "input_count",      "input_limits",      "input_names",      "input_units",
    "is_regular",       "parameter_count",   "rate_ranges",      "std"};
constexpr std::array<std::string_view, 5> more_names{"unbounded", "velocity_count",
                                                     "velocity_names", "velocity_units", "result"};
constexpr std::array<std::string_view, 7> arguments{"p", "q", "v", "a", "u", "t", "w"};
/// Members of Parameters hide these in the initialisers beside them.
constexpr std::array<std::string_view, 5> hidden_by_members{"Parameters", "Scalar", "constant",
                                                            "detail", "std"};
constexpr std::string_view constant_prefix = "number_";

template <class List>
bool contains(const List& list, std::string_view name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

bool is_emitted_name(std::string_view name) {
  return contains(emitted_names, name) || contains(more_names, name) ||
         name.substr(0, constant_prefix.size()) == constant_prefix;
}

Diagnostic taken(const std::string& name, const char* what, const Span& span) {
  return {Code::E701, span,
          fmt::format("`{}` cannot name a {}: the emitted code has that name", name, what)};
}

Span span_of(const Scene& scene, const Function& function) {
  for (const OutputRequest& request : scene.outputs) {
    if (request.name == function.name) return request.span;
  }
  return {};
}

}  // namespace

Diagnostics check_names(const Model& model, const Scene& scene, const Program& program) {
  Diagnostics diagnostics;
  for (const ParameterArray& array : model.parameter_arrays) {
    if (is_emitted(array, scene) && contains(hidden_by_members, array.name)) {
      diagnostics.push_back(taken(array.name, "parameter", array.span));
    }
  }
  std::map<std::string, std::string> structs;
  for (const Function& function : program.functions) {
    const std::string type = struct_name(function);
    const bool collides = returns_struct(function) &&
                          (is_emitted_name(type) || !structs.emplace(type, function.name).second);
    if (collides || is_emitted_name(function.name)) {
      diagnostics.push_back(taken(function.name, "function", span_of(scene, function)));
    }
  }
  if (cpp_namespace(scene) == "std") {
    diagnostics.push_back({Code::E701, {}, "`std` cannot name a namespace: it is the library's"});
  }
  return diagnostics;
}

std::string cpp_temporary(const std::string& name) {
  const auto is_called = [&name](const FunctionRow& row) { return row.name == name; };
  const bool is_function =
      name == "sqrt" || std::any_of(function_table.begin(), function_table.end(), is_called);
  const bool hides = is_function || is_emitted_name(name) || contains(arguments, name);
  return hides ? name + "_" : name;
}

std::string struct_name(const Function& function) { return camel_case(function.name); }

bool returns_struct(const Function& function) {
  return function.fields.size() != 1 || !function.fields.front().name.empty();
}

const std::string& cpp_namespace(const Scene& scene) {
  const std::string& name = scene.emission.cpp_namespace;
  return name.empty() ? scene.base_name : name;
}

bool is_emitted(const ParameterArray& array, const Scene& scene) {
  for (std::uint32_t i = 0; i < array.count; ++i) {
    if (scene.specialisation.fixed.count(array.first + i) == 0) return true;
  }
  return false;
}

}  // namespace elgen
