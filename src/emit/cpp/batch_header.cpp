// batch_header: functions that apply functions of the main header to arrays of states (template
// cpp/batch.hpp.mustache). A pack is a SIMD vector: one number, such as q[1], of several states.
// Each function loads packs, calls its namesake in the main header, and stores the results.
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <utility>

#include "elgen/artifacts.hpp"
#include "emit/code/function_docs.hpp"
#include "emit/code/header_data.hpp"
#include "emit/code/sine_data.hpp"
#include "emit/interface/code_interface.hpp"
#include "emit/text/emission_checks.hpp"
#include "emit/text/emission_input.hpp"
#include "emit/text/layout.hpp"
#include "program/evaluate/sines.hpp"

namespace elgen {
namespace {

using Texts = std::vector<std::string>;

constexpr std::array<std::string_view, 3> names_in_batch_header{"Pack", "batch", "kernel"};

/// The name of the header that the batch header includes.
std::string included_name(const Scene& scene) {
  const ArtifactId id = scene.numerics.has_mixed_precision() ? ArtifactId::wide : ArtifactId::cpp;
  return fmt::format("{}{}", scene.base_name, artifact_table[id].path_suffix);
}

Texts note_lines(const EmissionInput& input) {
  Texts lines;
  for (const ScalarKind scalar : input.scene.numerics.computed_scalars()) {
    const double error =
        cln::double_approx(sine_error(input.scene.numerics, SineArithmetic::packs, scalar));
    lines.push_back(
        fmt::format(" In {}, sines and cosines are off by at most {:.3g} for angles up to {:g}; "
                    "for larger angles they are NaN.",
                    name_of(scalar), error, angle_reduction(scalar).domain));
  }
  for (const Function& function : input.program.functions) {
    if (!is_returned_by_value(function)) lines.push_back(omission_note(function));
  }
  if (input.scene.numerics.has_mixed_precision()) {
    lines.push_back(fmt::format(
        " batch::wide and kernel::wide have the functions of {}, which compute accelerations in "
        "float.",
        included_name(input.scene)));
  }
  return wrap_notes(lines);
}

Texts parameter_conversions(const EmissionInput& input) {
  Texts lines;
  for (const ParameterArray& array : emitted_parameters(input.model, input.program)) {
    lines.push_back(
        array.is_array
            ? fmt::format("for (std::size_t i = 0; i < {0}; ++i) result.{1}[i] = p.{1}[i];",
                          array.count, array.name)
            : fmt::format("result.{0} = p.{0};", array.name));
  }
  return lines;
}

/// "void gravity(const Parameters<T>& p, std::size_t count, const T* q, T* result, …)"
std::string batch_signature(const std::string& type, const std::string& parameters,
                            const Model& model, const Function& function) {
  Texts arguments{parameters, "std::size_t count"};
  for (const Opcode argument : arguments_of(model, function)) {
    if (argument != Opcode::parameter) {
      arguments.push_back(fmt::format("const T* {}", leaf_row(argument).symbol));
    }
  }
  arguments.insert(arguments.end(), {"T* result", "std::size_t stride = 0"});
  return signature(type + " " + function.name, arguments, "");
}

std::string load_expression(Opcode argument) {
  const LeafRow& leaf = leaf_row(argument);
  if (argument == Opcode::parameter) return "constants";
  if (is_single(argument)) {
    return fmt::format("detail::loaded<std::array<Scalar, 1>>({}, at)[0]", leaf.symbol);
  }
  return fmt::format("detail::loaded<{}>({}, at)", leaf.type, leaf.symbol);
}

/// One store statement per field.
std::string store_statements(const Function& function) {
  std::string lines;
  std::size_t before = 0;
  for (const Field& field : function.fields) {
    const std::string value = field.name.empty() ? "values" : "values." + field.name;
    const std::string to = before == 0 ? "result" : fmt::format("result + {} * at.stride", before);
    lines += fmt::format("    detail::store({}, at, {});\n", value, to);
    before += field.entries.size();
  }
  return lines;
}

/// The statements that call the function for the pack of states at `at` and store the values.
/// `callee`: "step<Scalar>", a function of the namespace of the main header.
std::string kernel_statements(const EmissionInput& input, const Function& function,
                              const std::string& callee) {
  Texts arguments;
  for (const Opcode argument : arguments_of(input.model, function)) {
    arguments.push_back(load_expression(argument));
  }
  return fmt::format("    const auto values = ::{}::{}(\n        {});\n{}", name_space(input.scene),
                     callee, fmt::join(arguments, ",\n        "), store_statements(function));
}

/// The parts of a row that depend on the types of numbers.
TemplateRow types_data(const EmissionInput& input, const Function& function) {
  return {{"number_types", "  using Scalar = T;\n"},
          {"pack_types",
           "  using Scalar = Pack<T>;\n"
           "  const auto constants = detail::repeated<Scalar>(p);\n"},
          {"statements", kernel_statements(input, function, function.name + "<Scalar>")}};
}

/// As types_data(), for a step whose accelerations are in float. A pack of the state has as many
/// elements as a pack of float.
TemplateRow mixed_types_data(const EmissionInput& input, const Function& function) {
  constexpr std::string_view check =
      "  static_assert(std::is_same_v<T, double>, \"the state is in double\");\n";
  const std::string numbers = "  using Scalar = T;\n  using Inner = float;\n";
  const std::string packs =
      "  using Inner = Pack<float>;\n"
      "  using Scalar = Pack<T, Inner::size()>;\n";
  return {{"number_types", fmt::format("{}{}", check, numbers)},
          {"pack_types", fmt::format("{}{}  const auto& constants = p;\n", check, packs)},
          {"statements", kernel_statements(input, function,
                                           fmt::format("wide::{}<Scalar, Inner>", function.name))}};
}

TemplateData functions_data(const EmissionInput& input,
                            TemplateRow (*types_data_of)(const EmissionInput& input,
                                                         const Function& function)) {
  TemplateData list(TemplateData::type::list);
  for (std::size_t i = 0; i < input.program.functions.size(); ++i) {
    const Function& function = input.program.functions[i];
    if (!is_returned_by_value(function)) continue;
    const FunctionDocsInput text{input.model, input.program,       function, input.equations[i],
                                 {},          input.scene.emission};
    TemplateRow row = types_data_of(input, function);
    row["summary"] = function_heading(text);
    row["signature"] = batch_signature("void", "const Parameters<T>& p", input.model, function);
    row["kernel"] =
        batch_signature("__global__ void", "Parameters<T> constants", input.model, function);
    list << row;
  }
  return list;
}

TemplateData library_calls_data(const Program& program, std::size_t arity) {
  return repeated_section(library_calls(program, arity), [](std::string_view name) {
    return TemplateData("call", std::string(name));
  });
}

}  // namespace

std::string batch_header(const EmissionInput& input) {
  TemplateData data = stamp_data(input);
  data.set("header", input.scene.base_name + ".hpp");
  data.set("included", included_name(input.scene));
  data.set("notes", lines_section(note_lines(input)));
  data.set("compares", optional_section(compares_numbers(input.program)));
  const Numerics& numerics = input.scene.numerics;
  const bool has_tables = has_batch_sine_tables(input.scene, input.program);
  const std::vector<ScalarKind> none;
  const auto numbers = [&numerics](ScalarKind scalar) {
    return SineNumbers{sine_constants(numerics, SineArithmetic::packs, scalar)};
  };
  data.set("tables", trigonometry_tables(has_tables ? numerics.computed_scalars() : none, numbers));
  data.set("trigonometry",
           has_tables ? "Trigonometry" : "::" + name_space(input.scene) + "::detail::Trigonometry");
  data.set("calls", library_calls_data(input.program, 1));
  data.set("calls_of_two", library_calls_data(input.program, 2));
  data.set("sine_cosine", optional_section(calls_sines(input.program)));
  data.set("parameters", lines_section(parameter_conversions(input)));
  data.set("functions", functions_data(input, types_data));
  data.set("mixed",
           optional_section(input.scene.numerics.has_mixed_precision(),
                            TemplateRow{{"functions", functions_data(input, mixed_types_data)}}));
  return fill_header_template("cpp/batch.hpp.mustache", data);
}

Diagnostics batch_check_names(const Model& /*model*/, const Scene& scene, const Program& program) {
  Diagnostics diagnostics;
  for (const Function& function : program.functions) {
    const bool is_reserved =
        std::ranges::count(names_in_batch_header, function.name) > 0 ||
        (returns_struct(function) && camel_case(function.name) == names_in_batch_header[0]);
    if (is_reserved) diagnostics.push_back(reserved_name_error(scene, function));
  }
  return diagnostics;
}

}  // namespace elgen
