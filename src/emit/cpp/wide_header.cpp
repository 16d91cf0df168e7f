// wide_header: the functions of the main header in a wider scalar, from the template
// cpp/wide.hpp.mustache. Each function widens its arguments, calls its namesake in the main header,
// and rounds the results. A step whose accelerations are in float is written out instead, as a
// template for numbers and packs.
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "emit/code/function_docs.hpp"
#include "emit/code/header_data.hpp"
#include "emit/cpp/cpp_dialect.hpp"
#include "emit/interface/code_interface.hpp"
#include "emit/text/emission_checks.hpp"
#include "emit/text/emission_input.hpp"
#include "emit/text/layout.hpp"

namespace elgen {
namespace {

using Texts = std::vector<std::string>;

constexpr std::array<std::string_view, 2> names_in_wide_header{"wide", "Inner"};

/// "{widened(p.M), widened(p.m)}": all members in order, so that no default value is computed.
std::string widened_parameters(const EmissionInput& input) {
  Texts members;
  for (const ParameterArray& array : emitted_parameters(input.model, input.program)) {
    members.push_back(fmt::format("widened(p.{})", array.name));
  }
  const std::string line = fmt::format("return {{{}}};", fmt::join(members, ", "));
  const std::string margin(10, ' ');
  if (line.size() + 2 <= line_width) return line;
  return fmt::format("return {{{}}};", fmt::join(members, ",\n" + margin));
}

std::string widened_call(const EmissionInput& input, const Function& function,
                         const std::string& start, const std::string& end) {
  Texts arguments;
  for (const Opcode argument : arguments_of(input.model, function)) {
    arguments.push_back(fmt::format("detail::widened({})", leaf_row(argument).symbol));
  }
  const std::string callee =
      fmt::format("{}{}::{}<Inner>", start, name_space(input.scene), function.name);
  return signature(callee, arguments, end);
}

std::string wide_body(const EmissionInput& input, const Function& function) {
  if (!returns_struct(function)) {
    return widened_call(input, function, "  return detail::rounded(", ");\n");
  }
  Texts fields;
  for (const Field& field : function.fields) {
    fields.push_back(fmt::format("detail::rounded(values.{})", field.name));
  }
  return widened_call(input, function, "  const auto values = ", ";\n") +
         fmt::format("  return {{{}}};\n", fmt::join(fields, ",\n          "));
}

/// The template row of a step that computes only its accelerations in `Inner`.
TemplateRow mixed_step_data(const EmissionInput& input, const Function& function) {
  const auto dialect = mixed_dialect(input.model, input.program, name_space(input.scene));
  const FunctionDefinition step =
      dialect->function_definition(function, input.scene.emission.storage);
  return {
      {"parts", parts_section(function, step, "class Scalar, class Inner")},
      {"head",
       "/// Scalar: double or a pack of double, the type of the state. Inner: float or a pack of\n"
       "/// float, the type of the accelerations.\n"
       "template <class Scalar = double, class Inner = float>\n"},
      {"signature", step.whole.signature},
      {"body", step.whole.body}};
}

TemplateData wide_functions_data(const EmissionInput& input) {
  const auto dialect = wide_dialect(input.model, input.program);
  TemplateData list(TemplateData::type::list);
  for (std::size_t i = 0; i < input.program.functions.size(); ++i) {
    const Function& function = input.program.functions[i];
    if (!is_returned_by_value(function)) continue;
    UsedNames all;
    for (const Opcode argument : arguments_of(input.model, function)) {
      all.variables.insert(leaf_row(argument).symbol);
    }
    const FunctionDocsInput text{input.model, input.program,       function, input.equations[i],
                                 {},          input.scene.emission};
    const bool is_mixed = input.scene.numerics.has_mixed_precision();
    TemplateRow row = is_mixed ? mixed_step_data(input, function)
                               : TemplateRow{{"parts", optional_section(false)},
                                             {"head", std::string()},
                                             {"signature", dialect->signature(function, all)},
                                             {"body", wide_body(input, function)}};
    row["summary"] = function_heading(text);
    list << row;
  }
  return list;
}

Texts wide_notes(const EmissionInput& input) {
  Texts notes;
  for (const Function& function : input.program.functions) {
    if (!is_returned_by_value(function)) notes.push_back(omission_note(function));
  }
  return wrap_notes(notes);
}

}  // namespace

std::string wide_header(const EmissionInput& input) {
  const InnerScalarRow& inner = inner_scalar_row(input.scene.numerics.inner);
  TemplateData data = stamp_data(input);
  data.set("header", input.scene.base_name + ".hpp");
  const bool is_mixed = input.scene.numerics.has_mixed_precision();
  data.set("mixed", optional_section(is_mixed));
  data.set("inner", is_mixed ? "double, the accelerations in float" : std::string(inner.name));
  data.set("type", std::string(inner.type));
  data.set("notes", lines_section(wide_notes(input)));
  data.set("double_double", optional_section(inner.kind == InnerScalar::double_double));
  data.set("sine_cosine", optional_section(has_sine_cosine_pair(input.program)));
  data.set("widened_parameters", widened_parameters(input));
  data.set("functions", wide_functions_data(input));
  set_pivot_data(data, input);
  return fill_header_template("cpp/wide.hpp.mustache", data);
}

Diagnostics wide_check_names(const Model& /*model*/, const Scene& scene, const Program& program) {
  Diagnostics diagnostics;
  for (const Function& function : program.functions) {
    const bool is_reserved =
        std::ranges::count(names_in_wide_header, function.name) > 0 ||
        (returns_struct(function) && camel_case(function.name) == names_in_wide_header.back());
    if (is_reserved) diagnostics.push_back(reserved_name_error(scene, function));
  }
  return diagnostics;
}

}  // namespace elgen
