// cpp_driver: the C++ drivers of the main header, the Eigen header, and the header in a wider
// scalar.
#include <fmt/ranges.h>

#include "elgen/artifacts.hpp"
#include "emit/interface/code_interface.hpp"
#include "toolchain/driver.hpp"

namespace elgen {
namespace {

constexpr std::string_view array_vector = R"(
template <class Scalar, std::size_t N>
std::array<Scalar, N> from_flat(const Scalar* values) {
  std::array<Scalar, N> result{};
  for (std::size_t i = 0; i < N; ++i) result[i] = values[i];
  return result;
}
)";
constexpr std::string_view eigen_vector = R"(
template <class Scalar, int N>
Eigen::Matrix<Scalar, N, 1> from_flat([[maybe_unused]] const Scalar* values) {
  Eigen::Matrix<Scalar, N, 1> result;
  for (int i = 0; i < N; ++i) result(i) = values[i];
  return result;
}
)";

constexpr std::string_view cpp_prologue = R"(#include "{header}"
#include <array>
#include <cstddef>

namespace driver_of_{name} {{

namespace {{

namespace emitted = ::{functions};

{shared}{vector})";

constexpr std::string_view helpers = R"(template <class Scalar>
void append(Scalar*& to, const Scalar* stored, std::size_t rows, std::size_t columns) {{
  for (std::size_t i = 0; i < rows; ++i) {{
    for (std::size_t j = 0; j < columns; ++j) *to++ = stored[{position}];
  }}
}}

template <class Scalar>
::{name_space}::Parameters<Scalar> parameters_from([[maybe_unused]] const Scalar* values) {{
  static const ::{name_space}::Parameters<Scalar> of_model{{}};
  ::{name_space}::Parameters<Scalar> result = of_model;
{parameters}  return result;
}}
)";

constexpr std::string_view call_template = R"(
template <class Scalar>
void call_{index}({leaves}[[maybe_unused]] Scalar* to) {{
{body}}}
)";

constexpr std::string_view cpp_wrapper = R"(
extern "C" void {symbol}({leaves}{scalar}* result);
extern "C" void {symbol}({leaves}{scalar}* result) {{
  call_{index}({names}, result);
}}
)";

/// The names and types in which the drivers of the three headers differ.
struct HeaderTypes {
  std::string_view name;  ///< of the driver
  std::string header;
  std::string functions;    ///< namespace of the emitted functions
  std::string_view vector;  ///< text of from_flat(), which converts numbers to a vector argument
  std::string (*array)(const Function& function);  ///< type of a result too large to return
  bool is_wide = false;
};

/// A driver without its text, as argument of is_wrapped() and scalars_of().
Driver driver_without_text(const HeaderTypes& types) {
  Driver driver;
  driver.is_wide = types.is_wide;
  return driver;
}

std::string array_result_type(const Function& function) {
  return fmt::format("std::array<Scalar, {}>", entry_count(function));
}

std::string eigen_result_type(const Function& function) {
  const Field& field = function.fields.front();
  return fmt::format("emitted::Matrix<Scalar, {}, {}>", field.rows, field.columns);
}

/// The arguments of a call: "parameters_from<Scalar>(parameters),\n      from_flat<Scalar, 2>(q)".
std::string cpp_arguments(const Model& model, const Function& function) {
  std::string text = "parameters_from<Scalar>(parameters)";
  for (const Opcode argument : arguments_of(model, function)) {
    const std::string_view name = leaf_row(argument).member;
    if (is_single(argument)) text += fmt::format(", {}", name);
    if (!is_vector(argument)) continue;
    text += fmt::format(",\n      from_flat<Scalar, {}>({})", leaf_count(model, argument), name);
  }
  return text;
}

std::string call_statements(const DriverInput& input, const HeaderTypes& types,
                            const Function& function) {
  const std::string given = cpp_arguments(input.model, function);
  const std::string results = append_statements(input, function, "to", ".data()");
  if (is_returned_by_value(function)) {
    return fmt::format("  const auto result = emitted::{}({});\n{}", function.name, given, results);
  }
  const std::string type = returns_struct(function)
                               ? fmt::format("emitted::{}<Scalar>", camel_case(function.name))
                               : types.array(function);
  return fmt::format("  {} result{{}};\n  emitted::{}(result, {});\n{}", type, function.name, given,
                     results);
}

std::string call_functions_text(const DriverInput& input, const HeaderTypes& types) {
  const auto& [model, scene, program] = input;
  std::string text =
      fmt::format(cpp_prologue, fmt::arg("name", types.name), fmt::arg("header", types.header),
                  fmt::arg("functions", types.functions), fmt::arg("vector", types.vector),
                  fmt::arg("shared", cpp_helpers(input)));
  for (std::size_t i = 0; i < program.functions.size(); ++i) {
    if (!is_wrapped(driver_without_text(types), program.functions[i])) continue;
    text += fmt::format(call_template, fmt::arg("index", i),
                        fmt::arg("leaves", leaf_parameter_list("Scalar", "[[maybe_unused]] ")),
                        fmt::arg("body", call_statements(input, types, program.functions[i])));
  }
  return text + "\n}  // namespace\n";
}

std::string make_driver_text(const DriverInput& input, const HeaderTypes& types) {
  std::string text = call_functions_text(input, types);
  const Program& program = input.program;
  std::vector<std::string_view> names;
  for (const LeafRow& leaf : leaf_table()) names.push_back(leaf.member);
  const Driver driver = driver_without_text(types);
  for (std::size_t i = 0; i < program.functions.size(); ++i) {
    if (!is_wrapped(driver, program.functions[i])) continue;
    for (const ScalarKind kind : scalars_of(driver, input)) {
      const std::string scalar(name_of(kind));
      text += fmt::format(cpp_wrapper, fmt::arg("symbol", driver_symbol(types.name, scalar, i)),
                          fmt::arg("scalar", scalar), fmt::arg("index", i),
                          fmt::arg("leaves", leaf_parameter_list(scalar)),
                          fmt::arg("names", fmt::join(names, ", ")));
    }
  }
  return text + fmt::format("\n}}  // namespace driver_of_{}\n", types.name);
}

}  // namespace

std::string cpp_helpers(const DriverInput& input) {
  return fmt::format(helpers, fmt::arg("position", storage_index(input.scene)),
                     fmt::arg("name_space", name_space(input.scene)),
                     fmt::arg("parameters", parameter_assignments(input)));
}

std::string cpp_driver(const DriverInput& input) {
  return make_driver_text(input, {"cpp", artifact_path(input.scene, ArtifactId::cpp),
                                  name_space(input.scene), array_vector, array_result_type});
}

std::string eigen_driver(const DriverInput& input) {
  return make_driver_text(input,
                          {"eigen", artifact_path(input.scene, ArtifactId::eigen),
                           name_space(input.scene) + "::eigen", eigen_vector, eigen_result_type});
}

std::string wide_driver(const DriverInput& input) {
  return make_driver_text(
      input, {"wide", artifact_path(input.scene, ArtifactId::wide),
              name_space(input.scene) + "::wide", array_vector, array_result_type, true});
}

}  // namespace elgen
