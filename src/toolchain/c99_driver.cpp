// c99_driver: the driver of a C header, in the header's only scalar type.
#include <fmt/format.h>

#include "elgen/artifacts.hpp"
#include "emit/interface/code_interface.hpp"
#include "toolchain/driver.hpp"

namespace elgen {
namespace {

/// `append` is extern with a prototype: a static function would cause a warning if a header only
/// returns numbers.
constexpr std::string_view c99_prologue = R"(#include "{header}"

#include <stddef.h>

void append({scalar} **to, const {scalar} *stored, size_t rows, size_t columns);
void append({scalar} **to, const {scalar} *stored, size_t rows, size_t columns) {{
  for (size_t i = 0; i < rows; ++i) {{
    for (size_t j = 0; j < columns; ++j) *(*to)++ = stored[{position}];
  }}
}}

)";

constexpr std::string_view c99_parameters = R"(
static {name_space}_parameters parameters_from(const {scalar} *values) {{
  {name_space}_parameters result = {{0}};
{parameters}  return result;
}}
)";

constexpr std::string_view c99_wrapper = R"(
void {symbol}({leaves}{scalar} *to);
void {symbol}({leaves}{scalar} *to) {{
  {given}
{body}}}
)";

/// The arguments of a call: "&p, q, v".
std::string c99_arguments(const DriverInput& input, const Function& function) {
  std::string text;
  for (const Opcode argument :
       arguments_of(input.model, function, input.program, LanguageId::c99)) {
    const bool is_struct = argument == Opcode::parameter;
    text += text.empty() ? "" : ", ";
    text += is_struct ? "&p" : leaf_row(argument).symbol;
  }
  return text;
}

std::string call_statements(const DriverInput& input, const Function& function,
                            const std::string& scalar) {
  const std::string name = fmt::format("{}_{}", name_space(input.scene), function.name);
  const std::string given = c99_arguments(input, function);
  const std::string results = append_statements(input, function, "&to", "");
  if (returns_struct(function)) {
    return fmt::format("  {0}_result result;\n  {0}({1}, &result);\n{2}", name, given, results);
  }
  if (is_scalar(input.program, function, function.fields.front())) {
    return fmt::format("  const {} result = {}({});\n{}", scalar, name, given, results);
  }
  return fmt::format("  {} result[{}];\n  {}({}, result);\n{}", scalar, entry_count(function), name,
                     given, results);
}

}  // namespace

std::string c99_driver(const DriverInput& input) {
  const auto& [model, scene, program] = input;
  const std::string scalar(name_of(scene.numerics.scalars.front()));
  std::string text =
      fmt::format(c99_prologue, fmt::arg("header", artifact_path(scene, ArtifactId::c99)),
                  fmt::arg("scalar", scalar), fmt::arg("position", storage_index(scene)));
  std::string given;
  for (const LeafRow& leaf : leaf_table()) given += fmt::format("(void){};", leaf.member);
  if (const std::string assignments = parameter_assignments(input); !assignments.empty()) {
    text += fmt::format(c99_parameters, fmt::arg("name_space", name_space(scene)),
                        fmt::arg("scalar", scalar), fmt::arg("parameters", assignments));
    const std::string type = name_space(scene) + "_parameters";
    given = fmt::format("const {} p = parameters_from(parameters);\n  (void)p;{}", type, given);
  }
  for (std::size_t i = 0; i < program.functions.size(); ++i) {
    text += fmt::format(c99_wrapper, fmt::arg("symbol", driver_symbol("c99", scalar, i)),
                        fmt::arg("scalar", scalar), fmt::arg("leaves", leaf_parameter_list(scalar)),
                        fmt::arg("given", given),
                        fmt::arg("body", call_statements(input, program.functions[i], scalar)));
  }
  return text;
}

}  // namespace elgen
