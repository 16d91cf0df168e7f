// cpp_header: the C++17 header with arrays as arguments, and the header with Eigen's vectors and
// matrices, from the templates of cpp/. The elements of a declared array are written on one line if
// they fit, else one per line.
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "emit/code/cpp_constant.hpp"
#include "emit/code/function_docs.hpp"
#include "emit/code/header_data.hpp"
#include "emit/code/sine_data.hpp"
#include "emit/cpp/cpp_dialect.hpp"
#include "emit/interface/code_interface.hpp"
#include "emit/text/emission_input.hpp"
#include "emit/text/layout.hpp"
#include "numbers/exact_number.hpp"
#include "numbers/scalar_literal.hpp"
#include "program/evaluate/sine_calls.hpp"

namespace elgen {
namespace {

using Texts = std::vector<std::string>;

/// "{{1, 2}}": the inner braces initialise the array inside std::array; "{}" without elements.
std::string braced_list(const Texts& elements, std::size_t column) {
  if (elements.empty()) return "{}";
  const std::string line = fmt::format("{{{{{}}}}}", fmt::join(elements, ", "));
  if (column + line.size() < line_width) return line;
  return fmt::format("{{{{\n    {},\n}}}}", fmt::join(elements, ",\n    "));
}

/// The template data of a declared array, such as the units or ranges of the coordinates.
TemplateData declared_array_data(const DeclaredArray& array) {
  constexpr std::array types{"const char*", "double", "Interval"};
  const Texts elements = element_literals(array, "{{{0}, {1}}}", "unbounded");
  const std::string type = types[static_cast<std::size_t>(array.kind)];
  const std::string count = std::to_string(array.size());
  const std::size_t column =
      fmt::format("inline constexpr std::array<{}, {}> {};", type, count, array.name).size();
  return TemplateRow{{"type", type},
                     {"count", count},
                     {"name", array.name},
                     {"value", braced_list(elements, column)}};
}

Texts parameter_values(const Model& model, const ParameterArray& array) {
  Texts texts;
  for (const cln::cl_R& value : element_values(model, array)) texts.push_back(cpp_constant(value));
  return texts;
}

bool has_equal_elements(const Model& model, const ParameterArray& array) {
  const Texts values = parameter_values(model, array);
  const auto is_first = [&values](const std::string& value) { return value == values.front(); };
  return array.is_array && array.count > 1 && std::all_of(values.begin(), values.end(), is_first);
}

std::string member_declaration(const Model& model, const ParameterArray& array) {
  const Texts values = parameter_values(model, array);
  if (!array.is_array) return fmt::format("Scalar {} = {};", array.name, values.front());
  const std::string start = fmt::format("std::array<Scalar, {}> {} = ", array.count, array.name);
  if (has_equal_elements(model, array)) {
    return fmt::format("{}detail::filled<{}>({});", start, array.count, values.front());
  }
  return fmt::format("{}{{{{\n      {},\n  }}}};", start, fmt::join(values, ",\n      "));
}

/// Members of Parameters, with their default values.
std::vector<Member> parameter_members(const Model& model,
                                      const std::vector<ParameterArray>& arrays) {
  std::vector<Member> members;
  for (const ParameterArray& array : arrays) {
    members.push_back({member_declaration(model, array), parameter_doc(array)});
  }
  return members;
}

/// True if an array parameter has one value for all elements, so that detail::filled constructs it.
bool has_filled_array(const Model& model, const std::vector<ParameterArray>& arrays) {
  return std::any_of(arrays.begin(), arrays.end(),
                     [&](const ParameterArray& array) { return has_equal_elements(model, array); });
}

bool has_long_constants(const Program& program) {
  return std::ranges::any_of(executed_constants(program), [](const Constant& constant) {
    return !is_short_constant(constant.value);
  });
}

/// Functions that return the constants that are too long for an equation, in program order.
TemplateData long_constants_data(const Program& program) {
  TemplateData list(TemplateData::type::list);
  for (const Constant& constant : executed_constants(program)) {
    if (is_short_constant(constant.value)) continue;
    const cln::cl_R magnitude = cln::abs(constant.value);
    const Texts value = wrap_expression(cpp_magnitude(magnitude), {line_width - 10, "      "});
    list << TemplateRow{
        {"text", is_rational(constant) ? exact_text(magnitude) : text_of(constant.form)},
        {"name", constant_name(constant)},
        {"value", fmt::format("{}", fmt::join(value, "\n"))}};
  }
  return list;
}

/// A row with glibc's sincos, sincosf or sincosl for each scalar of the scene, and for float if the
/// accelerations are in float. sincosl is no device function: no GPU has long double.
TemplateData sine_cosine_calls_data(const Numerics& numerics) {
  return repeated_section(numerics.computed_scalars(), [](ScalarKind scalar) {
    const bool is_long = scalar == ScalarKind::long_double;
    const std::string ending = is_long ? "l" : (scalar == ScalarKind::single_precision ? "f" : "");
    return TemplateRow{{"scalar", std::string(name_of(scalar))},
                       {"call", "sincos" + ending},
                       {"device", std::string(is_long ? "" : "ELGEN_FUNCTION ")}};
  });
}

/// The built-in scalars for which `is_wanted` is true.
template <class Predicate>
std::vector<ScalarKind> scalars_if(const Predicate& is_wanted) {
  std::vector<ScalarKind> scalars;
  for (const ScalarRow& row : scalar_table) {
    if (is_wanted(row.kind)) scalars.push_back(row.kind);
  }
  return scalars;
}

/// The names and tables of the scalars whose sines are computed in line. If packs use the tables of
/// the main header, every scalar of the scene has a table.
TemplateData inline_sines_data(const EmissionInput& input) {
  const Scene& scene = input.scene;
  const bool has_packs =
      scene.emission.has_batch_header && !has_batch_sine_tables(input.scene, input.program);
  const auto in_line =
      scalars_if([&](ScalarKind scalar) { return has_inline_sines(scene, scalar); });
  const std::vector<ScalarKind> computed = scene.numerics.computed_scalars();
  const auto in_tables = scalars_if([&](ScalarKind scalar) {
    const bool is_named = std::ranges::count(computed, scalar) > 0;
    return has_inline_sines(scene, scalar) || (has_packs && is_named);
  });
  const auto numbers = [&input](ScalarKind scalar) {
    const Scene& of = input.scene;
    return SineNumbers{sine_constants(of.numerics, SineArithmetic::numbers, scalar),
                       lone_sine_constants(of, input.program, scalar)};
  };
  const TemplateData names = repeated_section(in_line, [&](ScalarKind scalar) {
    return TemplateRow{{"scalar", std::string(name_of(scalar))},
                       {"lone", optional_section(!numbers(scalar).lone.empty())}};
  });
  const bool has_lone = std::ranges::any_of(
      in_line, [&](ScalarKind scalar) { return !numbers(scalar).lone.empty(); });
  return TemplateRow{
      {"scalars", sine_cosine_calls_data(scene.numerics)},
      {"tables", trigonometry_tables(in_tables, numbers)},
      {"has_lone", optional_section(has_lone)},
      {"angles", optional_section(has_angle_groups(input.program))},
      {"in_line", optional_section(!in_line.empty(), TemplateRow{{"scalars", names}})}};
}

}  // namespace

std::string cpp_header(const EmissionInput& input) {
  const std::vector<ParameterArray> parameters = emitted_parameters(input.model, input.program);
  TemplateData data = header_data(input, *cpp_dialect(input.model, input.program));
  data.set("declared",
           repeated_section(declared_arrays(input.model, input.program), declared_array_data));
  data.set("filled", optional_section(has_filled_array(input.model, parameters)));
  data.set("has_numbers", optional_section(has_long_constants(input.program)));
  data.set("numbers", long_constants_data(input.program));
  data.set("sine_cosine", optional_section(calls_sines(input.program), inline_sines_data(input)));
  data.set("memory",
           optional_section(calls_sines(input.program) || has_column_loops(input.program)));
  data.set("parameters",
           lines_section(member_doc_lines(parameter_members(input.model, parameters))));
  return fill_header_template("cpp/header.hpp.mustache", data);
}

/// The Eigen header, with its own copy of each body. A call of a function of the main header would
/// copy Eigen's vectors to arrays and back (up to a quarter of the time of panda7, g++ -O2), or
/// reinterpret these vectors as arrays, which is undefined behaviour.
std::string eigen_header(const EmissionInput& input) {
  TemplateData data = header_data(input, *eigen_dialect(input.model, input.program));
  const bool is_row_major = input.scene.emission.storage == Storage::row_major;
  data.set("header", input.scene.base_name + ".hpp");
  data.set("order", is_row_major ? "RowMajor" : "ColMajor");
  return fill_header_template("cpp/eigen.hpp.mustache", data);
}

}  // namespace elgen
