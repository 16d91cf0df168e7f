// The driver of an emitted header. For a function inverse_dynamics(q, v, a) of two coordinates:
//
//     extern "C" void elgen_driver_double_0(const double* p, const double* q, const double* v,
//     const double* a,
//                                           const double* u, double t, double* result) {
//       call_0(p, q, v, a, u, t, result);
//     }
#include "driver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "elgen/outputs.hpp"

namespace elgen {
namespace {

/// Results beyond this many entries are written by reference instead of being returned.
constexpr std::size_t largest_returned = 4096;

constexpr std::string_view prologue = R"(#include <array>
#include <cstddef>

namespace {{

namespace emitted = ::{0};

template <class Scalar, std::size_t N>
std::array<Scalar, N> from_flat(const Scalar* values) {{
  std::array<Scalar, N> result{{}};
  for (std::size_t i = 0; i < N; ++i) result[i] = values[i];
  return result;
}}

template <class Scalar>
void append(Scalar*& to, const Scalar& value) {{
  *to++ = value;
}}
template <class Scalar, std::size_t N>
void append(Scalar*& to, const std::array<Scalar, N>& values) {{
  for (const Scalar& value : values) *to++ = value;
}}

template <class Scalar>
emitted::Parameters<Scalar> parameters_from([[maybe_unused]] const Scalar* values) {{
  emitted::Parameters<Scalar> result{{}};
{1}  return result;
}}
)";

constexpr std::string_view call_template = R"(
template <class Scalar>
void call_{index}([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] const Scalar* q,
    [[maybe_unused]] const Scalar* v, [[maybe_unused]] const Scalar* a,
    [[maybe_unused]] const Scalar* u, [[maybe_unused]] Scalar t, [[maybe_unused]] Scalar* to) {{
{body}}}
)";

constexpr std::string_view wrapper_template = R"(
extern "C" void {symbol}(const {scalar}* parameters, const {scalar}* q, const {scalar}* v,
    const {scalar}* a, const {scalar}* u, {scalar} t, {scalar}* result);
extern "C" void {symbol}(const {scalar}* parameters, const {scalar}* q, const {scalar}* v,
    const {scalar}* a, const {scalar}* u, {scalar} t, {scalar}* result) {{
  call_{index}(parameters, q, v, a, u, t, result);
}}
)";

/// "  result.l[1] = values[3];" for every run-time parameter, in the order of the program's leaves.
std::string parameter_assignments(const Model& model, const Scene& scene, const Program& program) {
  std::string text;
  for (std::size_t i = 0; i < model.parameters.size(); ++i) {
    const Parameter& parameter = model.parameters[i];
    if (scene.specialisation.fixed.count(static_cast<std::uint32_t>(i)) != 0) continue;
    const std::vector<std::string>& leaves = program.leaves.parameters;
    const auto leaf = std::find(leaves.begin(), leaves.end(), parameter.name);
    if (leaf == leaves.end()) continue;
    const ParameterArray& array = model.parameter_arrays[parameter.array];
    const std::string member =
        array.is_array ? fmt::format("{}[{}]", array.name, parameter.element) : array.name;
    text += fmt::format("  result.{} = values[{}];\n", member, leaf - leaves.begin());
  }
  return text;
}

/// "parameters_from<Scalar>(parameters), from_flat<Scalar, emitted::coordinate_count>(q)"
std::string arguments(const Model& model, const Function& function) {
  const OutputRow& row = output_row(function.kind);
  const bool mass_takes_velocity = function.kind == OutputKind::mass_matrix && !model.quadratic;
  std::string text = "parameters_from<Scalar>(parameters)";
  const auto add = [&text](std::string_view count, std::string_view name) {
    text += fmt::format(",\n      from_flat<Scalar, emitted::{}>({})", count, name);
  };
  add("coordinate_count", "q");
  if (row.takes_velocity || mass_takes_velocity) add("velocity_count", "v");
  if (row.takes_acceleration) add("velocity_count", "a");
  if (row.takes_input) add("input_count", "u");
  if (model.uses_time) text += ", t";
  return text;
}

std::string call_body(const Model& model, const Function& function) {
  const std::string call_arguments = arguments(model, function);
  const std::size_t entries = entry_count(function);
  if (entries > largest_returned) {
    return fmt::format(
        "  std::array<Scalar, {0}> result{{}};\n  emitted::{1}(result, {2});\n"
        "  append(to, result);\n",
        entries, function.name, call_arguments);
  }
  std::string text =
      fmt::format("  const auto result = emitted::{}({});\n", function.name, call_arguments);
  for (const Field& field : function.fields) {
    text += field.name.empty() ? "  append(to, result);\n"
                               : fmt::format("  append(to, result.{});\n", field.name);
  }
  return text;
}

}  // namespace

std::string driver_symbol(std::string_view scalar, std::size_t function) {
  return fmt::format("elgen_driver_{}_{}", scalar, function);
}

std::string driver_source(const Model& model, const Scene& scene, const Program& program) {
  const std::string& name =
      scene.emission.cpp_namespace.empty() ? scene.base_name : scene.emission.cpp_namespace;
  std::string text = fmt::format("#include \"{0}/{0}.hpp\"\n", scene.base_name);
  text += fmt::format(prologue, name, parameter_assignments(model, scene, program));
  for (std::size_t i = 0; i < program.functions.size(); ++i) {
    text += fmt::format(call_template, fmt::arg("index", i),
                        fmt::arg("body", call_body(model, program.functions[i])));
  }
  text += "\n}  // namespace\n";
  for (std::size_t i = 0; i < program.functions.size(); ++i) {
    for (const char* scalar : {"double", "float"}) {
      text += fmt::format(wrapper_template, fmt::arg("symbol", driver_symbol(scalar, i)),
                          fmt::arg("scalar", scalar), fmt::arg("index", i));
    }
  }
  return text;
}

}  // namespace elgen
