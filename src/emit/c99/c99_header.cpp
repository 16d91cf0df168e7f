// c99_header: fills the template c99/header.h.mustache. Every name of the header begins with the
// prefix of the scene. The name of a function can collide only with a helper of another function, a
// declared array or one of `names_in_header` (E701).
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <limits>

#include "emit/c99/c99_dialect.hpp"
#include "emit/code/function_docs.hpp"
#include "emit/code/header_data.hpp"
#include "emit/code/sine_data.hpp"
#include "emit/interface/code_interface.hpp"
#include "emit/text/emission_checks.hpp"
#include "emit/text/emission_input.hpp"
#include "emit/text/layout.hpp"
#include "numbers/exact_number.hpp"

namespace elgen {
namespace {

using Texts = std::vector<std::string>;

/// The members of the struct of parameters, such as "double l[2];", with documentation.
std::vector<Member> parameter_members(const EmissionInput& input) {
  const std::string scalar(name_of(c99_scalar(input.scene)));
  std::vector<Member> members;
  for (const ParameterArray& array : emitted_parameters(input.model, input.program)) {
    const std::string extent = array.is_array ? fmt::format("[{}]", array.count) : "";
    members.push_back({fmt::format("{} {}{};", scalar, array.name, extent), parameter_doc(array)});
  }
  return members;
}

/// "{0.5, 0.5}, /* l */"
std::string initialiser(const EmissionInput& input, const ParameterArray& array) {
  Texts values;
  for (const cln::cl_R& value : element_values(input.model, array)) {
    values.push_back(c99_literal(value, c99_scalar(input.scene)));
  }
  const std::string list = fmt::format("{}", fmt::join(values, ", "));
  return fmt::format("{}, /* {} */", array.is_array ? "{" + list + "}" : list, array.name);
}

/// The lines of one macro: each line except the last ends with a backslash, all in one column.
Texts macro_lines(Texts lines) {
  std::size_t width = 0;
  for (const std::string& line : lines) width = std::max(width, line.size());
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    lines[i] = fmt::format("{:<{}} \\", lines[i], width);
  }
  return lines;
}

Texts default_parameters_macro(const EmissionInput& input) {
  Texts lines = {fmt::format("#define {}_DEFAULT_PARAMETERS", upper_case(name_space(input.scene))),
                 "  {"};
  for (const ParameterArray& array : emitted_parameters(input.model, input.program)) {
    const Wrapping wrapping{line_width - 6, "        "};
    const Texts wrapped = wrap_expression("    " + initialiser(input, array), wrapping);
    lines.insert(lines.end(), wrapped.begin(), wrapped.end());
  }
  lines.emplace_back("  }");
  return macro_lines(std::move(lines));
}

constexpr std::array<std::string_view, 17> names_in_header{
    "parameters",  "is_regular", "sign_of",      "smaller",       "larger",
    "stumpff",     "sine_of",    "cosine_of",    "sine_cosine",   "sine_cosine_beyond",
    "lone_sine",   "columns",    "load_columns", "store_columns", "interval",
    "digits_left", "at_run_time"};

/// True if `name` is the result struct, the workspace or a part of the function.
bool is_helper_name(const std::string& name, const Function& function) {
  return name == function.name + "_workspace" || name.starts_with(function.name + "_part_") ||
         (returns_struct(function) && name == function.name + "_result");
}

bool is_reserved_name(const std::string& name, const Model& model, const Program& program) {
  const auto is_table = [&name](const DeclaredArray& array) { return array.name == name; };
  if (std::ranges::any_of(declared_arrays(model, program), is_table)) return true;
  const auto takes = [&name](const Function& function) { return is_helper_name(name, function); };
  return std::find(names_in_header.begin(), names_in_header.end(), name) != names_in_header.end() ||
         std::any_of(program.functions.begin(), program.functions.end(), takes);
}

/// Tables of names, units, bounds and start values. Empty tables are skipped: C has no arrays of
/// zero elements.
TemplateData declared_arrays_data(const EmissionInput& input) {
  TemplateData list(TemplateData::type::list);
  const std::string& prefix = name_space(input.scene);
  const std::array types{std::string("char *const"), std::string("double"), prefix + "_interval"};
  for (const DeclaredArray& array : declared_arrays(input.model, input.program)) {
    if (array.size() == 0) continue;
    const Texts elements = element_literals(array, "{{{0}, {1}}}", "HUGE_VAL");
    const std::string& type = types[static_cast<std::size_t>(array.kind)];
    const std::size_t start =
        fmt::format("static const {} {}_{}[] = ", type, prefix, array.name).size() + 3;
    const Wrapping wrapping{line_width - start, "    "};
    const Texts lines = wrap_expression(fmt::format("{{{}}}", fmt::join(elements, ", ")), wrapping);
    list << TemplateRow{{"type", type},
                        {"name", array.name},
                        {"count", std::to_string(array.size())},
                        {"value", fmt::format("{}", fmt::join(lines, "\n"))}};
  }
  return list;
}

bool needs_inline_sines(const EmissionInput& input) {
  return calls_sines(input.program) && has_inline_sines(input.scene, c99_scalar(input.scene));
}

/// Section `sine_cosine`; absent unless sines are computed in line.
TemplateData c99_sines_data(const EmissionInput& input) {
  const ScalarKind scalar = c99_scalar(input.scene);
  const auto literal = [scalar](double value) { return c99_literal(exact_value(value), scalar); };
  const SineNumbers numbers{sine_constants(input.scene.numerics, SineArithmetic::numbers, scalar),
                            lone_sine_constants(input.scene, input.program, scalar)};
  return optional_section(needs_inline_sines(input),
                          sine_data(numbers, scalar, literal, SineSpelling::values));
}

}  // namespace

std::string c99_header(const EmissionInput& input) {
  TemplateData data = header_data(input, *c99_dialect(input.model, input.scene, input.program));
  data.set("scalar", std::string(name_of(c99_scalar(input.scene))));
  const bool is_float = c99_scalar(input.scene) == ScalarKind::single_precision;
  data.set("sine_function", is_float ? "sinf" : "sin");
  data.set("cosine_function", is_float ? "cosf" : "cos");
  data.set("hyperbolic_sine", is_float ? "sinhf" : "sinh");
  data.set("logarithm", is_float ? "log10f" : "log10");
  const double epsilon =
      is_float ? std::numeric_limits<float>::epsilon() : std::numeric_limits<double>::epsilon();
  data.set("epsilon", c99_literal(exact_value(epsilon), c99_scalar(input.scene)));
  data.set("sine_cosine", c99_sines_data(input));
  data.set("memory",
           optional_section(needs_inline_sines(input) || has_column_loops(input.program)));
  data.set("digits", is_float ? "1e9" : "1e17");
  data.set("guard", upper_case(input.scene.base_name));
  data.set("capitals", upper_case(name_space(input.scene)));
  data.set("has_parameters",
           optional_section(emitted_parameter_count(input.model, input.program) > 0));
  data.set("parameters", lines_section(member_doc_lines(parameter_members(input))));
  data.set("declared", declared_arrays_data(input));
  data.set("default_parameters", lines_section(default_parameters_macro(input)));
  return fill_header_template("c99/header.h.mustache", data);
}

Diagnostics c99_check_names(const Model& model, const Scene& scene, const Program& program) {
  Diagnostics diagnostics;
  for (const Function& function : program.functions) {
    if (!is_reserved_name(function.name, model, program)) continue;
    diagnostics.push_back(reserved_name_error(scene, function));
  }
  return diagnostics;
}

}  // namespace elgen
