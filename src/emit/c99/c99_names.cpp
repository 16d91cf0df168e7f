// c99_names: every name of templates/c99/ begins with the prefix of the scene, so that functions
// can collide with each other's helpers only, and with the few names the header has for itself.
// E701.
#include <algorithm>
#include <array>

#include "emit/c99/c99_artifact.hpp"
#include "emit/text/taken_name.hpp"
#include "lower/code_interface.hpp"

namespace elgen {
namespace {

constexpr std::array<std::string_view, 5> header_names{"parameters", "is_regular", "sign_of",
                                                       "smaller", "larger"};

/// Whether `name` is that of the struct, the workspace or a part of the function.
bool is_helper(const std::string& name, const Function& function) {
  return name == function.name + "_workspace" || name.starts_with(function.name + "_part_") ||
         (gives_struct(function) && name == function.name + "_result");
}

bool is_taken(const std::string& name, const Program& program) {
  const auto takes = [&name](const Function& function) { return is_helper(name, function); };
  return std::find(header_names.begin(), header_names.end(), name) != header_names.end() ||
         std::any_of(program.functions.begin(), program.functions.end(), takes);
}

}  // namespace

Diagnostics c99_check_names(const Model& /*model*/, const Scene& scene, const Program& program) {
  Diagnostics diagnostics;
  for (const Function& function : program.functions) {
    if (!is_taken(function.name, program)) continue;
    diagnostics.push_back(taken_name(scene, function));
  }
  return diagnostics;
}

}  // namespace elgen
