// Writes calls that match the declarations in emitted headers.
#include "random/driver_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cctype>

#include "support/text.hpp"

namespace elgen::test::random {

namespace {

const char* const cpp_prelude = R"(#include <array>
#include <cstdio>
#include <type_traits>
template <class Value>
void show(const char* name, const Value& value) {
  if constexpr (std::is_arithmetic_v<Value>) {
    std::printf("%s %.17g\n", name, static_cast<double>(value));
  } else {
    for (const auto& entry : value) show(name, entry);
  }
}
)";

const char* const eigen_prelude = R"(#include <Eigen/Core>
template <class Scalar, int rows, int columns, int options, int a, int b>
void show(const char* name, const Eigen::Matrix<Scalar, rows, columns, options, a, b>& value) {
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) show(name, value(i, j));
  }
}
)";

const char* const c_prelude = R"(#include <stdio.h>
#define SHOW(name, array) \
  for (size_t i = 0; i < sizeof(array) / sizeof(SCALAR); ++i) \
    printf("%s %.17g\n", name, (double)((const SCALAR*)&(array))[i])
)";

/// The fields of an output that is a struct; empty for other outputs.
const std::vector<std::string>& fields_of(const std::string& output) {
  static const std::map<std::string, std::vector<std::string>> names{
      {"forward_dynamics", {"acceleration"}},
      {"linearization", {"A", "B"}},
      {"inverse_dynamics_derivatives", {"by_position", "by_velocity"}},
      {"forward_dynamics_derivatives", {"by_position", "by_velocity", "by_input"}}};
  static const std::vector<std::string> none;
  const auto known = names.find(output);
  return known == names.end() ? none : known->second;
}

struct Declaration {
  std::string result;
  std::string name;
  std::string parameters;
};

/// The declarations TYPE NAME(PARAMETERS) in `header`, one after each occurrence of `marker`.
std::vector<Declaration> declarations(const std::string& header, const std::string& marker) {
  std::vector<Declaration> found;
  for (std::size_t at = header.find(marker); at != std::string::npos;
       at = header.find(marker, at + 1)) {
    const std::size_t start = at + marker.size();
    const std::size_t open = header.find('(', start);
    const std::size_t close = header.find(')', open);
    const std::size_t space = header.rfind(' ', open);
    found.push_back({header.substr(start, space - start),
                     header.substr(space + 1, open - space - 1),
                     header.substr(open + 1, close - open - 1)});
  }
  return found;
}

std::string number_literal(const Jet& value) { return "(SCALAR)" + value.value().str(20); }

/// The entries of `all` that are not locked, as literals; `all` is q if `is_q`, otherwise v or a.
std::vector<std::string> free_numbers(const Vector& all, const Layout& layout, bool is_q) {
  std::vector<std::string> result;
  for (const Layout::Place& place : layout.places) {
    if (place.lock >= 0) continue;
    const std::size_t start = is_q ? place.q : place.v;
    const std::size_t count = !place.is_rotation ? 1 : is_q ? 4 : 3;
    for (std::size_t i = start; i < start + count; ++i) result.push_back(number_literal(all[i]));
  }
  return result;
}

/// The arguments q, v, a, u by name, as lists of literals.
std::vector<std::pair<std::string, std::vector<std::string>>> arguments_of(const Trial& trial) {
  std::vector<std::string> inputs;
  for (const std::size_t k : acting_inputs(trial.system)) {
    inputs.push_back(number_literal(trial.state.u[k]));
  }
  return {{"q", free_numbers(trial.state.q, trial.layout, true)},
          {"v", free_numbers(trial.state.v, trial.layout, false)},
          {"a", free_numbers(trial.state.a, trial.layout, false)},
          {"u", inputs}};
}

const char* scalar_of(const Trial& trial) {
  return trial.system.scene.is_float ? "float" : "double";
}

std::string cpp_call(const Declaration& function, const Trial& trial, const std::string& space) {
  const std::string& types = function.parameters;
  std::string arguments = "p, q";
  if (mentions(types, "Velocities<")) arguments += ", v";
  if (mentions(types, "Accelerations<")) arguments += ", a";
  if (mentions(types, "Inputs<")) arguments += ", u";
  if (mentions(types, "common_type_t<")) arguments += ", t";
  const std::string base = base_name(trial.system);
  const std::string call = fmt::format("{}::{}<SCALAR>({})", space, function.name, arguments);
  const auto& fields = fields_of(function.name);
  if (fields.empty()) return fmt::format("  show(\"{}/{}\", {});\n", base, function.name, call);
  std::string text;
  for (const std::string& field : fields) {
    const std::string output = function.name + "." + field;
    if (!trial.given.contains(output)) continue;
    text += fmt::format("  show(\"{}/{}\", {}.{});\n", base, output, call, field);
  }
  return text;
}

std::string cpp_function(const Trial& trial, const std::string& declared, bool is_eigen) {
  const std::string base = base_name(trial.system);
  std::string text = fmt::format("  const {}::Parameters<SCALAR> p{{}};\n", base);
  for (const auto& [name, numbers] : arguments_of(trial)) {
    const std::string type =
        fmt::format("{}<SCALAR, {}{}>", is_eigen ? "Eigen::Matrix" : "std::array", numbers.size(),
                    is_eigen ? ", 1" : "");
    text += fmt::format("  [[maybe_unused]] const {} {}{{{}}};\n", type, name,
                        numbers.empty() ? "" : fmt::format("{{{}}}", fmt::join(numbers, ", ")));
  }
  text += fmt::format("  [[maybe_unused]] const SCALAR t = {};\n", number_literal(trial.state.t));
  for (const Declaration& function : declarations(declared, "[[nodiscard]] ")) {
    const bool is_output = mentions(function.parameters, "Coordinates<");
    if (!is_output || function.name == "dynamics") continue;
    text += cpp_call(function, trial, base + (is_eigen ? "::eigen" : ""));
  }
  return text;
}

/// A call in C that prints the results. The last argument of the call receives arrays and structs.
std::string c_call(const Declaration& function, const Trial& trial) {
  const std::string base = base_name(trial.system);
  const std::string output = function.name.substr(base.size() + 1);
  std::string arguments = mentions(function.parameters, "_parameters *p") ? "&p, q" : "q";
  for (const char* name : {"v", "a", "u"}) {
    if (mentions(function.parameters, fmt::format(" {}[", name)))
      arguments += fmt::format(", {}", name);
  }
  const bool takes_time =
      mentions(function.parameters, " t,") || function.parameters.ends_with(" t");
  if (takes_time) arguments += ", t";
  if (function.result != "void") {
    return fmt::format("  {{ const SCALAR result = {}({}); SHOW(\"{}/{}\", result); }}\n",
                       function.name, arguments, base, output);
  }
  const auto& fields = fields_of(output);
  if (fields.empty()) {
    const std::size_t open = function.parameters.find("result[");
    const std::size_t close = function.parameters.find(']', open);
    return fmt::format("  {{ SCALAR {}]; {}({}, result); SHOW(\"{}/{}\", result); }}\n",
                       function.parameters.substr(open, close - open), function.name, arguments,
                       base, output);
  }
  std::string text =
      fmt::format("  {{ {0}_result result; {0}({1}, &result);\n", function.name, arguments);
  for (const std::string& field : fields) {
    const std::string name = output + "." + field;
    if (trial.given.contains(name))
      text += fmt::format("    SHOW(\"{}/{}\", result.{});\n", base, name, field);
  }
  return text + "  }\n";
}

std::string c_function(const Trial& trial, const std::string& declared) {
  const std::string base = base_name(trial.system);
  std::string upper = base;
  for (char& c : upper) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  std::string text;
  if (mentions(declared, "_DEFAULT_PARAMETERS")) {
    text =
        fmt::format("  const {}_parameters p = {}_DEFAULT_PARAMETERS;\n  (void)p;\n", base, upper);
  }
  for (const auto& [name, numbers] : arguments_of(trial)) {
    text += fmt::format("  const SCALAR {}[] = {{{}}};\n", name,
                        numbers.empty() ? "0" : fmt::format("{}", fmt::join(numbers, ", ")));
  }
  text += fmt::format("  const SCALAR t = {};\n", number_literal(trial.state.t));
  text += "  (void)q, (void)v, (void)a, (void)u, (void)t;\n";
  for (const Declaration& function : declarations(declared, "static inline ")) {
    // Long functions are split into parts, which are no outputs.
    const bool is_output =
        mentions(function.parameters, " q[") && !mentions(function.parameters, "_workspace *w");
    if (is_output && function.name != base + "_dynamics") text += c_call(function, trial);
  }
  return text;
}

}  // namespace

std::string header_suffix(Language language) {
  return language == Language::cpp ? ".hpp" : language == Language::eigen ? "_eigen.hpp" : ".h";
}

std::string driver_prelude(Language language) {
  if (language == Language::c) return c_prelude;
  return std::string(cpp_prelude) + (language == Language::eigen ? eigen_prelude : "");
}

std::string driver_function(const Trial& trial, Language language, const std::string& declared) {
  const std::string body = language == Language::c
                               ? c_function(trial, declared)
                               : cpp_function(trial, declared, language == Language::eigen);
  return fmt::format("#define SCALAR {}\nstatic void run_{}(void) {{\n{}}}\n#undef SCALAR\n",
                     scalar_of(trial), base_name(trial.system), body);
}

}  // namespace elgen::test::random
