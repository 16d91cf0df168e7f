// batch_driver: the driver of the batch header. The driver is called with one state and makes a
// batch of two and a half packs, with the state at each place in turn, so that the state is
// computed in full packs and in the remainder. The other states of the batch have other numbers, so
// that a wrong stride reads or writes a wrong number. Every other batch has a stride that is longer
// than the default. If an entry's bits at some place differ from its bits at the first place, the
// entry is NaN. The functions of batch::wide have such a driver, too.
#include <fmt/format.h>

#include "elgen/artifacts.hpp"
#include "emit/interface/code_interface.hpp"
#include "toolchain/driver.hpp"

namespace elgen {
namespace {

constexpr std::string_view batch_prologue = R"(#include "{header}"
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <vector>

namespace driver_of_{name} {{

namespace {{

namespace emitted = ::{name_space};

template <class Scalar>
constexpr std::size_t states = 5 * sizeof(emitted::batch::Pack<{element}>) / sizeof({element}) / 2;

/// The stride of the batch with the state at `place`: the default at even places.
template <class Scalar>
constexpr std::size_t stride_of(std::size_t place) {{
  return states<Scalar> + place % 2;
}}

{shared}
template <class Scalar>
std::vector<Scalar> batch_of(const Scalar* values, std::size_t size, std::size_t place) {{
  const std::size_t stride = stride_of<Scalar>(place);
  std::vector<Scalar> result(size * stride);
  for (std::size_t k = 0; k < size; ++k) {{
    for (std::size_t i = 0; i < stride; ++i) {{
      const Scalar other = static_cast<Scalar>(i + 1) - values[k] / Scalar(2);
      result[k * stride + i] = i == place ? values[k] : other;
    }}
  }}
  return result;
}}

template <class Scalar>
bool is_same(const Scalar& x, const Scalar& y) {{
  return std::memcmp(&x, &y, sizeof(x)) == 0 || (std::isnan(x) && std::isnan(y));
}}

template <class Scalar, std::size_t Entries, class Evaluate>
std::array<Scalar, Entries> at_every_place(const Evaluate& evaluate) {{
  std::array<Scalar, Entries> values{{}};
  for (std::size_t place = 0; place < states<Scalar>; ++place) {{
    const std::size_t stride = stride_of<Scalar>(place);
    std::vector<Scalar> result(Entries * stride);
    evaluate(place, result.data());
    for (std::size_t k = 0; k < Entries; ++k) {{
      const Scalar value = result[k * stride + place];
      const bool agrees = place == 0 || is_same(value, values[k]);
      values[k] = agrees ? value : std::numeric_limits<Scalar>::quiet_NaN();
    }}
  }}
  return values;
}}

}}  // namespace
)";

constexpr std::string_view batch_wrapper = R"(
extern "C" void {symbol}({leaves}{scalar}* to);
extern "C" void {symbol}({leaves}{scalar}* to) {{
  using Scalar = {scalar};
  const auto p = parameters_from<Scalar>(parameters);
  const auto values = at_every_place<Scalar, {entries}>([&](std::size_t place, Scalar* result) {{
    const std::size_t stride = place % 2 == 0 ? 0 : stride_of<Scalar>(place);
    emitted::{functions}::{function}<Scalar>(p, states<Scalar>{arguments}, result, stride);
  }});
{appends}}}
)";

/// A separate namespace, because some builds compile the sine driver without the batch driver.
constexpr std::string_view sine_prologue = R"(#include "{header}"

namespace driver_of_sines {{
)";

constexpr std::string_view sine_wrapper = R"(
extern "C" void {symbol}({leaves}{scalar}* to);
extern "C" void {symbol}({leaves}{scalar}* to) {{
  const ::{name_space}::batch::Pack<{scalar}> angle(t);
  const auto sine = ::{name_space}::batch::sin(angle);
  const auto cosine = ::{name_space}::batch::cos(angle);
  to[0] = sine.native[0];
  to[1] = cosine.native[0];
}}
)";

/// The arguments after the parameters and the count: ", batch_of(q, 2, place).data(), batch_of(&t,
/// 1, place).data()".
std::string batch_arguments(const Model& model, const Function& function) {
  std::string text;
  for (const Opcode argument : arguments_of(model, function)) {
    const std::string_view name = leaf_row(argument).member;
    if (is_single(argument)) text += fmt::format(", batch_of(&{}, 1, place).data()", name);
    if (!is_vector(argument)) continue;
    text += fmt::format(", batch_of({}, {}, place).data()", name, leaf_count(model, argument));
  }
  return text;
}

/// One line for each field: "  append(to, values.data() + 2, 2, 1);".
std::string batch_append_statements(const Function& function) {
  std::string text;
  std::size_t before = 0;
  for (const Field& field : function.fields) {
    if (field.entries.empty()) continue;
    text += fmt::format("  append(to, values.data() + {}, {}, {});\n", before, field.rows,
                        field.columns);
    before += field.entries.size();
  }
  return text;
}

/// The driver of the functions in emitted::batch, or in emitted::batch::wide if `is_wide`.
std::string pack_driver(const DriverInput& input, bool is_wide) {
  const auto& [model, scene, program] = input;
  const std::string_view name = is_wide ? "wide_batch" : "batch";
  std::string text = fmt::format(
      batch_prologue, fmt::arg("header", artifact_path(scene, ArtifactId::batch)),
      fmt::arg("name_space", name_space(scene)), fmt::arg("name", name),
      fmt::arg("element", is_wide ? "float" : "Scalar"), fmt::arg("shared", cpp_helpers(input)));
  for (std::size_t i = 0; i < program.functions.size(); ++i) {
    const Function& function = program.functions[i];
    if (!is_returned_by_value(function)) continue;
    for (const ScalarKind kind : scene.numerics.scalars) {
      const std::string scalar(name_of(kind));
      text += fmt::format(
          batch_wrapper, fmt::arg("symbol", driver_symbol(name, scalar, i)),
          fmt::arg("functions", is_wide ? "batch::wide" : "batch"), fmt::arg("scalar", scalar),
          fmt::arg("leaves", leaf_parameter_list(scalar, "[[maybe_unused]] ")),
          fmt::arg("entries", entry_count(function)), fmt::arg("function", function.name),
          fmt::arg("arguments", batch_arguments(model, function)),
          fmt::arg("appends", batch_append_statements(function)));
    }
  }
  return text + fmt::format("\n}}  // namespace driver_of_{}\n", name);
}

}  // namespace

std::string batch_driver(const DriverInput& input) {
  return pack_driver(input, false) + sine_driver(input);
}

std::string wide_batch_driver(const DriverInput& input) { return pack_driver(input, true); }

std::string sine_driver(const DriverInput& input) {
  const auto& [model, scene, program] = input;
  std::string text =
      fmt::format(sine_prologue, fmt::arg("header", artifact_path(scene, ArtifactId::batch)));
  for (const ScalarKind kind : scene.numerics.scalars) {
    const std::string scalar(name_of(kind));
    text += fmt::format(
        sine_wrapper, fmt::arg("symbol", driver_symbol("batch", scalar, program.functions.size())),
        fmt::arg("scalar", scalar), fmt::arg("name_space", name_space(scene)),
        fmt::arg("leaves", leaf_parameter_list(scalar, "[[maybe_unused]] ")));
  }
  return text + "\n}  // namespace driver_of_sines\n";
}

}  // namespace elgen
