// cpp_function: a Function -> the texts of its C++ definition, in parts where it is long.
#pragma once

#include <string>
#include <vector>

#include "elgen/model.hpp"
#include "elgen/program.hpp"
#include "sections.hpp"

namespace elgen {

struct CppDefinition {
  std::string signature = {};
  std::string body = {};
};

struct CppFunction {
  CppDefinition definition = {};
  std::vector<CppDefinition> parts = {};    ///< called by the definition; none where it is short
  std::vector<std::string> workspace = {};  ///< names of the values that several parts use
};

[[nodiscard]] CppFunction cpp_function(const Model& model, const Program& program,
                                       const Function& function);

/// "DynamicsWorkspace": the struct of those values.
[[nodiscard]] std::string workspace_name(const Function& function);

}  // namespace elgen
