// timing_driver: writes the timing driver. For inverse_dynamics(q, v, a), one state at a time:
//
//     template <class Scalar>
//     void one_by_one(std::size_t count, ..., const Scalar* q, ..., Scalar* result) {
//       const auto& p = model_parameters<Scalar>();
//       for (std::size_t i = 0; i < count; ++i) {
//         const auto values = emitted::inverse_dynamics<Scalar>(
//             p, gathered<emitted::Coordinates<Scalar>>(q, i, count), ...);
//         scatter(values, i, count, result);
//       }
//     }
//
// In a header in a wider scalar, the function is emitted::wide::inverse_dynamics. Steps whose
// accelerations are in float are emitted::wide::step and, in packs, emitted::batch::wide::step.
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "elgen/artifacts.hpp"
#include "emit/interface/code_interface.hpp"
#include "program/evaluate/subject.hpp"
#include "toolchain/driver.hpp"

namespace elgen {
namespace {

constexpr std::string_view timing_prologue = R"(#include "{header}"
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace {{

namespace emitted = ::{name_space};

/// The compiler must take them for arguments that it does not know.
template <class Scalar>
emitted::Parameters<Scalar>& model_parameters() {{
  static emitted::Parameters<Scalar> values{{}};
  asm volatile("" : : "r"(&values) : "memory");
  return values;
}}

template <class Array, class Scalar>
Array gathered(const Scalar* from, std::size_t i, std::size_t count) {{
  Array result;
  for (std::size_t k = 0; k < result.size(); ++k) result[k] = from[k * count + i];
  return result;
}}

template <class Scalar>
void scatter(const Scalar& value, std::size_t i, std::size_t, Scalar* to) {{
  to[i] = value;
}}
template <class Scalar, std::size_t Size>
void scatter(const std::array<Scalar, Size>& values, std::size_t i, std::size_t count, Scalar* to) {{
  for (std::size_t k = 0; k < Size; ++k) to[k * count + i] = values[k];
}}

)";

constexpr std::string_view state_loop_template = R"(template <class Scalar>
void one_by_one(std::size_t count, {leaves}Scalar* result) {{
  const auto& p = model_parameters<Scalar>();
  for (std::size_t i = 0; i < count; ++i) {{
    const auto values = emitted::{function}({arguments});
{stores}  }}
}}

)";

constexpr std::string_view pack_loop_template = R"(template <class Scalar>
void in_packs(std::size_t count, {leaves}Scalar* result) {{
  emitted::batch::{function}<Scalar>({arguments}, result);
}}

)";

/// Calls the batch function with one state at a time; gathers and scatters numbers like
/// `state_loop_template`.
constexpr std::string_view batch_call_template = R"(template <class Scalar>
void one_per_call(std::size_t count, {leaves}Scalar* result) {{
  const auto& p = model_parameters<Scalar>();
  for (std::size_t i = 0; i < count; ++i) {{
    std::array<Scalar, {entries}> values;
    emitted::batch::{function}<Scalar>({arguments},
        values.data());
    scatter(values, i, count, result);
  }}
}}

)";

constexpr std::string_view entry_point_template = R"(
extern "C" void {symbol}(std::size_t count, {leaves}{scalar}* result);
extern "C" void {symbol}(std::size_t count, {leaves}{scalar}* result) {{
{setter}  {call}<{scalar}>(count, {names}, result);
}}
)";

constexpr std::string_view setter_template = R"(  model_parameters<{0}>() =
      parameters == nullptr ? emitted::Parameters<{0}>{{}} : parameters_from(parameters);
)";

constexpr std::string_view step_loops_template = R"(}}  // namespace

extern "C" void {one}(std::size_t count, std::size_t steps, double start, double h,
                      const double* inputs, double* state, double* spare);
extern "C" void {one}(std::size_t, std::size_t steps, double start, double h,
                      const double* inputs, double* state, double*) {{
  const auto& p = model_parameters<double>();
  auto q = gathered<emitted::Coordinates<double>>(state, 0, 1);
  auto v = gathered<emitted::Velocities<double>>(state + q.size(), 0, 1);
  [[maybe_unused]] const auto u = gathered<emitted::Inputs<double>>(inputs, 0, 1);
  for (std::size_t i = 0; i < steps; ++i) {{
    [[maybe_unused]] const double t = start + static_cast<double>(i) * h;
    const auto moved = emitted::{function}<double>({arguments});
    const auto& next = {next};
    q = next.coordinates;
    v = next.rates;
  }}
  scatter(q, 0, 1, state);
  scatter(v, 0, 1, state + q.size());
}}

extern "C" void {in_packs}(std::size_t count, std::size_t steps, double start, double length,
                           const double* u, double* state, double* spare);
extern "C" void {in_packs}(std::size_t count, std::size_t steps, double start, double length,
                           [[maybe_unused]] const double* u, double* state, double* spare) {{
  constexpr std::size_t positions = emitted::coordinate_count;
  constexpr std::size_t numbers = positions + emitted::velocity_count;
  const std::vector<double> lengths(count, length);
  std::vector<double> times(count, start);
  [[maybe_unused]] const double* const h = lengths.data();
  [[maybe_unused]] const double* const t = times.data();
  double* from = state;
  double* to = spare;
  for (std::size_t i = 0; i < steps; ++i) {{
{clock}    const double* const q = from;
    const double* const v = from + positions * count;
    emitted::batch::{function}<double>({batch_arguments}, to);
{projection}    std::swap(from, to);
  }}
  for (std::size_t k = 0; from != state && k < numbers * count; ++k) state[k] = from[k];
}}
)";

/// Sets the times of all states, if the model depends on time.
constexpr std::string_view step_clock =
    "    for (double& time : times) time = start + static_cast<double>({}) * length;\n";

/// Projects the result of a step from `to` into `from`, then swaps both.
constexpr std::string_view projection_in_packs =
    R"({clock}    emitted::batch::{function}<double>({arguments}, from);
    std::swap(from, to);
)";

/// The parameters of a timed function before its result: "const double* parameters, const double*
/// q, …, const double* t, ".
std::string timed_parameter_list(std::string_view scalar, std::string_view attribute = "") {
  std::string text;
  for (const LeafRow& leaf : leaf_table()) {
    text += fmt::format("{}const {}* {}, ", attribute, scalar, leaf.member);
  }
  return text;
}

std::string prologue_of(const Scene& scene) {
  const bool is_wide = scene.numerics.inner != InnerScalar::same;
  const ArtifactId own = is_wide ? ArtifactId::wide : ArtifactId::cpp;
  const ArtifactId header = scene.emission.has_batch_header ? ArtifactId::batch : own;
  return fmt::format(timing_prologue, fmt::arg("header", artifact_path(scene, header)),
                     fmt::arg("name_space", name_space(scene)));
}

/// The name of a function inside the namespace `emitted` or `emitted::batch`: "wide::step".
std::string name_in_namespace(const Scene& scene, const Function& function) {
  return (scene.numerics.inner != InnerScalar::same ? "wide::" : "") + function.name;
}

std::string gather_expression(Opcode argument) {
  const LeafRow& leaf = leaf_row(argument);
  if (argument == Opcode::parameter) return "p";
  if (is_single(argument)) return fmt::format("{}[i]", leaf.member);
  return fmt::format("gathered<emitted::{}>({}, i, count)", leaf.type, leaf.member);
}

std::string scatter_statements(const Function& function) {
  std::string lines;
  std::size_t before = 0;
  for (const Field& field : function.fields) {
    lines += fmt::format("    scatter(values{}{}, i, count, result + {} * count);\n",
                         field.name.empty() ? "" : ".", field.name, before);
    before += field.entries.size();
  }
  return lines;
}

std::string state_loop_text(const DriverInput& input, const Function& function) {
  std::vector<std::string> arguments;
  for (const Opcode argument : arguments_of(input.model, function)) {
    arguments.push_back(gather_expression(argument));
  }
  const bool is_wide = input.scene.numerics.inner != InnerScalar::same;
  const std::string callee = name_in_namespace(input.scene, function) + (is_wide ? "" : "<Scalar>");
  return fmt::format(
      state_loop_template, fmt::arg("leaves", timed_parameter_list("Scalar", "[[maybe_unused]] ")),
      fmt::arg("function", callee), fmt::arg("arguments", fmt::join(arguments, ",\n        ")),
      fmt::arg("stores", scatter_statements(function)));
}

std::string pack_loop_text(const DriverInput& input, const Function& function) {
  std::vector<std::string_view> arguments{"model_parameters<Scalar>()", "count"};
  for (const Opcode argument : arguments_of(input.model, function)) {
    if (argument != Opcode::parameter) arguments.push_back(leaf_row(argument).member);
  }
  return fmt::format(
      pack_loop_template, fmt::arg("leaves", timed_parameter_list("Scalar", "[[maybe_unused]] ")),
      fmt::arg("function", function.name), fmt::arg("arguments", fmt::join(arguments, ", ")));
}

std::string batch_call_loop_text(const DriverInput& input, const Function& function) {
  std::vector<std::string> arguments{"p", "1"};
  for (const Opcode argument : arguments_of(input.model, function)) {
    if (argument == Opcode::parameter) continue;
    arguments.push_back(is_single(argument) ? fmt::format("{} + i", leaf_row(argument).member)
                                            : gather_expression(argument) + ".data()");
  }
  return fmt::format(
      batch_call_template, fmt::arg("leaves", timed_parameter_list("Scalar", "[[maybe_unused]] ")),
      fmt::arg("entries", entry_count(function)), fmt::arg("function", function.name),
      fmt::arg("arguments", fmt::join(arguments, ",\n        ")));
}

/// `first`, then the arguments of the function. `state`: the expressions for q, v and t.
std::string loop_arguments(const Model& model, const Function& function, const std::string& first,
                           const std::array<std::string_view, 3>& state) {
  std::string text = first;
  for (const Opcode argument : arguments_of(model, function)) {
    if (argument == Opcode::parameter) continue;
    text += fmt::format(", {}", argument == Opcode::coordinate ? state[0]
                                : argument == Opcode::velocity ? state[1]
                                : argument == Opcode::time     ? state[2]
                                                               : leaf_row(argument).member);
  }
  return text;
}

/// The name of the template that iterates over the states.
const char* loop_template_name(const TimedVariant& variant) {
  if (!variant.in_packs) return "one_by_one";
  return variant.is_one_per_call ? "one_per_call" : "in_packs";
}

std::string entry_point_text(const TimedVariant& variant, std::size_t number, bool varies) {
  std::vector<std::string_view> names;
  for (const LeafRow& leaf : leaf_table()) names.push_back(leaf.member);
  const std::string scalar(name_of(variant.scalar));
  return fmt::format(entry_point_template, fmt::arg("symbol", timed_symbol(number)),
                     fmt::arg("scalar", scalar), fmt::arg("leaves", timed_parameter_list(scalar)),
                     fmt::arg("call", loop_template_name(variant)),
                     fmt::arg("setter", varies ? fmt::format(setter_template, scalar) : ""),
                     fmt::arg("names", fmt::join(names, ", ")));
}

}  // namespace

SourceFile timing_driver(const DriverInput& input, const std::vector<TimedVariant>& variants) {
  const Scene& scene = input.scene;
  const Function& function = input.program.functions.front();
  const bool varies = !scene.numerics.varied_parameters.empty();
  std::string text = prologue_of(scene);
  if (varies) text += cpp_helpers(input);
  text += state_loop_text(input, function);
  if (scene.emission.has_batch_header)
    text += pack_loop_text(input, function) + batch_call_loop_text(input, function);
  text += "}  // namespace\n";
  for (std::size_t i = 0; i < variants.size(); ++i) {
    text += entry_point_text(variants[i], i, varies);
  }
  return {"timing_driver.cpp", text};
}

SourceFile step_driver(const DriverInput& input) {
  const auto& [model, scene, program] = input;
  const Function& step = *std::ranges::find(program.functions, OutputKind::step, &Function::kind);
  const Function* const projected = find_function(program, OutputKind::projected);
  const std::string in_packs = "model_parameters<double>(), count";
  const auto clock = [&, has_time = model.uses_time](const char* steps) {
    return has_time ? fmt::format(step_clock, steps) : "";
  };
  std::string next = "moved";
  std::string projection;
  if (projected != nullptr) {
    next = fmt::format(
        "emitted::{}<double>({})", projected->name,
        loop_arguments(model, *projected, "p", {"moved.coordinates", "moved.rates", "t + h"}));
    projection =
        fmt::format(projection_in_packs, fmt::arg("clock", clock("i + 1")),
                    fmt::arg("function", projected->name),
                    fmt::arg("arguments", loop_arguments(model, *projected, in_packs,
                                                         {"to", "to + positions * count", "t"})));
  }
  const std::string loops = fmt::format(
      step_loops_template, fmt::arg("one", single_step_loop_symbol),
      fmt::arg("in_packs", pack_step_loop_symbol),
      fmt::arg("function", name_in_namespace(scene, step)),
      fmt::arg("arguments", loop_arguments(model, step, "p", {"q", "v", "t"})),
      fmt::arg("batch_arguments", loop_arguments(model, step, in_packs, {"q", "v", "t"})),
      fmt::arg("clock", clock("i")), fmt::arg("next", next), fmt::arg("projection", projection));
  return {"step_driver.cpp", prologue_of(input.scene) + loops};
}

std::string timed_symbol(std::size_t variant) { return fmt::format("elgen_timed_{}", variant); }

}  // namespace elgen
