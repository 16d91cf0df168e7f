// The driver of an emitted header. For a function inverse_dynamics(q, v, a) of two coordinates:
//
//     extern "C" void elgen_driver_double_0(const double* p, const double* q, const double* v,
//                                           const double* a, const double* u, double t,
//                                           double* result) {
//       call_0(p, q, v, a, u, t, result);
//     }
#include "driver.hpp"

#include <fmt/format.h>

#include <set>

#include "emit/arguments.hpp"
#include "emit/cpp_names.hpp"
#include "emit/emission_input.hpp"
#include "emit/fields.hpp"
#include "emit/parameters.hpp"
#include "evaluate/decimal.hpp"

namespace elgen {
namespace {

/// What a driver is made from.
struct Subject {
  const Model& model;
  const Scene& scene;
  const Program& program;
};

/// Results come out row by row, however the header stores them.
constexpr std::string_view append_row_major = R"(
template <class Scalar>
void append(Scalar*& to, const Scalar* stored, std::size_t rows, std::size_t columns) {
  for (std::size_t i = 0; i < rows * columns; ++i) *to++ = stored[i];
}
)";
constexpr std::string_view append_column_major = R"(
template <class Scalar>
void append(Scalar*& to, const Scalar* stored, std::size_t rows, std::size_t columns) {
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < columns; ++j) *to++ = stored[j * rows + i];
  }
}
)";

constexpr std::string_view cpp_prologue = R"(#include <array>
#include <cstddef>

namespace {{

namespace emitted = ::{0};
{2}
template <class Scalar, std::size_t N>
std::array<Scalar, N> from_flat(const Scalar* values) {{
  std::array<Scalar, N> result{{}};
  for (std::size_t i = 0; i < N; ++i) result[i] = values[i];
  return result;
}}

template <class Scalar>
emitted::Parameters<Scalar> parameters_from([[maybe_unused]] const Scalar* values) {{
  emitted::Parameters<Scalar> result{{}};
{1}  return result;
}}
)";

constexpr std::string_view c99_prologue = R"(#include <cstddef>

namespace {{
{2}
template <class Scalar>
{0}_parameters parameters_from([[maybe_unused]] const Scalar* values) {{
  {0}_parameters result{{}};
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

/// The names of all elements of the arrays that are members.
std::set<std::string> emitted_names(const Subject& subject) {
  std::set<std::string> names;
  for (const ParameterArray& array : emitted_parameters(subject.model, subject.program)) {
    for (std::uint32_t i = 0; i < array.count; ++i) {
      names.insert(subject.model.parameters[array.first + i].name);
    }
  }
  return names;
}

/// "  result.l[1] = values[3];" for every run-time parameter, in the order of the program's leaves.
std::string parameter_assignments(const Subject& subject) {
  const LeafNames& leaves = subject.program.leaves;
  const std::vector<std::string> members = parameter_members(subject.model, leaves);
  const std::set<std::string> emitted = emitted_names(subject);
  std::string text;
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (emitted.count(leaves.parameters[i]) == 0) continue;
    text += fmt::format("  result.{} = values[{}];\n", members[i], i);
  }
  return text;
}

/// "  append(to, result.gravity.data(), 2, 1);" for each field; `data` gives the address of one.
std::string appended(const Subject& subject, const Function& function, std::string_view data) {
  const std::vector<bool> scalars = scalar_fields(subject.program, function);
  std::string text;
  for (std::size_t i = 0; i < function.fields.size(); ++i) {
    const Field& field = function.fields[i];
    if (field.entries.empty()) continue;
    const std::string value = field.name.empty() ? "result" : "result." + field.name;
    const std::string address = scalars[i] ? "&" + value : value + std::string(data);
    text += fmt::format("  append(to, {}, {}, {});\n", address, field.rows, field.columns);
  }
  return text;
}

/// "parameters_from<Scalar>(parameters), from_flat<Scalar, emitted::coordinate_count>(q)"
std::string cpp_arguments(const Model& model, const Function& function) {
  std::string text = "parameters_from<Scalar>(parameters)";
  for (const Argument argument : arguments_of(model, function)) {
    const std::string_view name = argument_name(argument);
    if (argument == Argument::time) text += ", t";
    if (argument == Argument::parameters || argument == Argument::time) continue;
    text += fmt::format(",\n      from_flat<Scalar, {}>({})", argument_size(model, argument), name);
  }
  return text;
}

std::string cpp_call(const Subject& subject, const Function& function) {
  const std::string arguments = cpp_arguments(subject.model, function);
  const std::string results = appended(subject, function, ".data()");
  if (is_returned(function)) {
    return fmt::format("  const auto result = emitted::{}({});\n{}", function.name, arguments,
                       results);
  }
  const std::string type = gives_struct(function)
                               ? fmt::format("emitted::{}<Scalar>", cpp_struct_name(function))
                               : fmt::format("std::array<Scalar, {}>", entry_count(function));
  return fmt::format("  {} result{{}};\n  emitted::{}(result, {});\n{}", type, function.name,
                     arguments, results);
}

std::string c99_call(const Subject& subject, const Function& function) {
  const std::string name = fmt::format("{}_{}", name_space(subject.scene), function.name);
  std::string arguments;
  for (const Argument argument : arguments_of(subject.model, function)) {
    const bool is_struct = argument == Argument::parameters;
    arguments += arguments.empty() ? "" : ", ";
    arguments += is_struct ? "&p" : argument_name(argument);
  }
  const std::string results = appended(subject, function, "");
  const std::string start = "  const auto p = parameters_from<Scalar>(parameters);\n";
  if (gives_struct(function)) {
    return fmt::format("{0}  {1}_result result{{}};\n  {1}({2}, &result);\n{3}", start, name,
                       arguments, results);
  }
  if (scalar_fields(subject.program, function).front()) {
    return fmt::format("{}  const Scalar result = {}({});\n{}", start, name, arguments, results);
  }
  return fmt::format("{}  Scalar result[{}] = {{}};\n  {}({}, result);\n{}", start,
                     entry_count(function), name, arguments, results);
}

bool is_generic(const Scene& scene) {
  return language_row(scene.emission.language).scalars == LanguageScalars::any;
}

}  // namespace

std::vector<ScalarKind> driver_scalars(const Scene& scene) {
  if (is_generic(scene)) return {ScalarKind::double_precision, ScalarKind::single_precision};
  return scene.numerics.scalars;
}

std::string driver_symbol(std::string_view scalar, std::size_t function) {
  return fmt::format("elgen_driver_{}_{}", scalar, function);
}

std::string driver_source(const Model& model, const Scene& scene, const Program& program) {
  const Subject subject{model, scene, program};
  const bool is_c = scene.emission.language == LanguageId::c99;
  const bool is_row_major = scene.emission.storage == Storage::row_major;
  std::string text = fmt::format("#include \"{}\"\n", header_path(scene));
  text += fmt::format(fmt::runtime(is_c ? c99_prologue : cpp_prologue), name_space(scene),
                      parameter_assignments(subject),
                      is_row_major ? append_row_major : append_column_major);
  for (std::size_t i = 0; i < program.functions.size(); ++i) {
    const Function& function = program.functions[i];
    text += fmt::format(
        call_template, fmt::arg("index", i),
        fmt::arg("body", is_c ? c99_call(subject, function) : cpp_call(subject, function)));
  }
  text += "\n}  // namespace\n";
  for (std::size_t i = 0; i < program.functions.size(); ++i) {
    for (const ScalarKind kind : driver_scalars(scene)) {
      const std::string scalar = scalar_name(kind);
      text += fmt::format(wrapper_template, fmt::arg("symbol", driver_symbol(scalar, i)),
                          fmt::arg("scalar", scalar), fmt::arg("index", i));
    }
  }
  return text;
}

}  // namespace elgen
