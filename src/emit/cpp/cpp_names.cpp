// cpp_names: the one list of names of templates/cpp/ that a user's name could collide with, and
// E701 where a model wants one of them. Keywords and macros are no names of a Model or Scene in the
// first place (E204).
#include "emit/cpp/cpp_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "emit/code/cpp_constant.hpp"
#include "emit/cpp/cpp_artifacts.hpp"
#include "emit/text/emission_input.hpp"
#include "emit/text/layout.hpp"
#include "emit/text/library_names.hpp"
#include "emit/text/parameters.hpp"
#include "emit/text/taken_name.hpp"
#include "lower/code_interface.hpp"

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
constexpr std::array<std::string_view, 5> eigen_names{"eigen", "Eigen", "Argument", "Matrix",
                                                      "Vector"};
/// Members of Parameters hide these in the initialisers beside them.
constexpr std::array<std::string_view, 5> hidden_by_members{"Parameters", "Scalar", "constant",
                                                            "detail", "std"};
constexpr std::string_view constant_prefix = "number_";

template <class List>
bool contains(const List& list, std::string_view name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

/// One value per name of a constant.
Diagnostics check_constant_names(const Program& program) {
  std::map<std::string, ConstantForm> forms;
  for (const Constant& constant : executed_constants(program)) {
    if (is_short_constant(constant.value)) continue;
    const auto [known, is_new] = forms.emplace(constant_name(constant), constant.form);
    if (is_new) continue;
    return {{Code::E912,
             {},
             fmt::format("`{}` and `{}` have one name in the emitted code", text_of(known->second),
                         text_of(constant.form))}};
  }
  return {};
}

}  // namespace

Diagnostics cpp_check_names(const Model& model, const Scene& scene, const Program& program) {
  Diagnostics diagnostics = check_constant_names(program);
  for (const ParameterArray& array : emitted_parameters(model, program)) {
    if (contains(hidden_by_members, array.name)) {
      diagnostics.push_back(taken_name(array.name, "parameter", array.span));
    }
  }
  std::map<std::string, std::string> structs;
  for (const Function& function : program.functions) {
    const std::string type = cpp_struct_name(function);
    const bool collides = gives_struct(function) &&
                          (is_emitted_name(type) || !structs.emplace(type, function.name).second);
    if (collides || is_emitted_name(function.name)) {
      diagnostics.push_back(taken_name(scene, function));
    }
  }
  const std::string& outermost = name_space(scene);
  if (outermost == "std" || is_library_name(outermost)) {
    diagnostics.push_back(
        {Code::E701, scene.emission.name_space_span,
         fmt::format("`{}` cannot name a namespace: {}", outermost,
                     is_reserved_type(outermost) ? "POSIX keeps names that end in `_t` for types"
                                                 : "C or POSIX declares it"),
         "`[emit] namespace` of a scene gives it another one"});
  }
  return diagnostics;
}

bool is_emitted_name(std::string_view name) {
  return contains(emitted_names, name) || contains(more_names, name) ||
         name.substr(0, constant_prefix.size()) == constant_prefix;
}

bool is_eigen_name(const std::string& name) { return contains(eigen_names, name); }

std::string cpp_struct_name(const Function& function) { return camel_case(function.name); }

}  // namespace elgen
