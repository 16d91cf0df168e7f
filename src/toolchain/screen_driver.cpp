// The text of the driver. For a model with a function of one field, mass_matrix(q):
//
//     extern "C" void elgen_screen_double(const double* parameters, const double* q, ...,
//                                         double t, double h, double* figures);
#include "toolchain/screen_driver.hpp"

#include <fmt/format.h>

#include <set>

#include "elgen/functions.hpp"
#include "elgen/templates.hpp"
#include "elgen/toolchain.hpp"
#include "toolchain/driver_parts.hpp"

namespace elgen {
namespace {

/// What functions.def says of derivatives, as text.
struct DerivativeRow {
  const char* first;
  const char* second;
};
constexpr DerivativeRow derivatives[] = {
#define ELGEN_FUNCTION(name, arity, use, parity, smoothness, first, second) {#first, #second},
#include "elgen/functions.def"
#undef ELGEN_FUNCTION
};

constexpr std::string_view of_one_argument = R"(
[[gnu::noinline]] inline Number {name}(const Number& a) {{
  const Wide& x = a.value;
  [[maybe_unused]] const Wide one = 1;
  const Wide f = {name}(x);
  return called(a, f, {first}, {curvature});
}}
)";
constexpr std::string_view of_two_arguments = R"(
[[gnu::noinline]] inline Number {name}(const Number& a, const Number& b) {{
  const Wide& x = a.value;
  const Wide& y = b.value;
  const Wide f = {name}(x, y);
  return called(a, b, f, {first}, {second});
}}
)";

constexpr std::string_view function_template = R"(  {{
    std::array<Scalar, {entries}> x{{}};
    std::array<Number, {entries}> truth{{}};
    call_{index}({leaves}, x.data());
    elgen_screen::is_known = true;
    call_{index}({wide_leaves}, truth.data());
{fields}  }}
)";

/// The functions that the program calls; those with kinks are comparisons in the emitted code.
std::string functions_of(const Program& program) {
  std::set<FunctionId> called;
  for (const Function& function : program.functions) {
    for (const Instruction& instruction : function.instructions) {
      const bool is_call = instruction.opcode == Opcode::call;
      if (is_call && !is_kinked(instruction.function)) called.insert(instruction.function);
    }
  }
  std::string text;
  for (const FunctionId id : called) {
    const FunctionRow& row = function_row(id);
    const DerivativeRow& derivative = derivatives[static_cast<std::size_t>(id)];
    text += fmt::format(fmt::runtime(row.arity == 1 ? of_one_argument : of_two_arguments),
                        fmt::arg("name", row.name), fmt::arg("first", derivative.first),
                        fmt::arg("second", derivative.second),
                        fmt::arg("curvature", is_circular(id) ? 1 : 0));
  }
  return fmt::format("\nnamespace elgen_screen {{\n{}\n}}  // namespace elgen_screen\n\n", text);
}

/// "parameters, q, ..., h", or with `pattern` "wide_{0}.data()" its like.
std::string leaf_list(const char* vector_pattern, const char* single_pattern) {
  std::string text;
  for (const LeafRow& leaf : leaf_table) {
    const char* const pattern = is_single(leaf.id) ? single_pattern : vector_pattern;
    text += (text.empty() ? "" : ", ") + fmt::format(fmt::runtime(pattern), leaf.member);
  }
  return text;
}

/// "  const auto wide_q = elgen_screen::inputs(q, 2, signs);"
std::string wide_leaves(const DriverInput& input) {
  std::string text;
  for (const LeafRow& leaf : leaf_table) {
    text +=
        fmt::format("  const auto wide_{0} = elgen_screen::inputs({1}{0}, {2}, signs);\n",
                    leaf.member, is_single(leaf.id) ? "&" : "", leaf_count(input.model, leaf.id));
  }
  return text;
}

std::string judged(const Function& function, std::size_t& figures) {
  std::string text;
  std::size_t first = 0;
  for (const Field& field : function.fields) {
    text += fmt::format(
        "    elgen_screen::judge(x.data() + {0}, truth.data() + {0}, {1}, {2}, figures + {3});\n",
        first, field.entries.size(), function.instructions.size(), figures);
    first += field.entries.size();
    figures += figures_per_field;
  }
  return text;
}

std::string screening(const DriverInput& input) {
  std::string text = fmt::format(
      "\ntemplate <class Scalar>\nvoid screen({}double* figures) {{\n"
      "  using elgen_screen::Number;\n"
      "  elgen_screen::rounding = elgen_screen::rounding_of<Scalar>();\n"
      "  std::uint64_t signs = 1;\n{}",
      declared_leaves("Scalar"), wide_leaves(input));
  std::size_t figures = 0;
  for (std::size_t i = 0; i < input.program.functions.size(); ++i) {
    const Function& function = input.program.functions[i];
    text += fmt::format(function_template, fmt::arg("entries", entry_count(function)),
                        fmt::arg("index", i), fmt::arg("leaves", leaf_list("{}", "{}")),
                        fmt::arg("wide_leaves", leaf_list("wide_{}.data()", "wide_{}.front()")),
                        fmt::arg("fields", judged(function, figures)));
  }
  return text + "}\n";
}

}  // namespace

std::string screen_symbol(std::string_view scalar) {
  return fmt::format("elgen_screen_{}", scalar);
}

Driver screen_driver(const DriverInput& input) {
  std::string text{template_at("screen/number.hpp.mustache")};
  text += functions_of(input.program) + cpp_calls(input) + screening(input);
  for (const ScalarKind kind : driver_scalars(input)) {
    const std::string scalar(name_of(kind));
    const std::string signature = fmt::format("extern \"C\" void {}({}double* figures)",
                                              screen_symbol(scalar), declared_leaves(scalar));
    text += fmt::format("\n{0};\n{0} {{\n  screen({1}, figures);\n}}\n", signature,
                        leaf_list("{}", "{}"));
  }
  return {"", "screen_driver.cpp", text, "boost/multiprecision/cpp_bin_float.hpp"};
}

}  // namespace elgen
