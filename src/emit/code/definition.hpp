// definition: a Function -> the texts of its definition in a C-like language, in parts where it is
// long.
//
//     0 = coordinate x; 1 = sin 0; result = 1      ->      const Scalar sin_x = sin(q[0]);
//                                                          return {{sin_x}};
#pragma once

#include <string>
#include <vector>

#include "elgen/scene.hpp"
#include "emit/code/dialect.hpp"

namespace elgen {

/// The text before the braces and between them: lines with indentation and line ends.
struct DefinitionText {
  std::string signature = {};
  std::string body = {};
};

struct FunctionDefinition {
  DefinitionText whole = {};
  std::vector<DefinitionText> parts = {};   ///< called by the whole; none where it is short
  std::vector<std::string> workspace = {};  ///< names of the values that several parts use
};

[[nodiscard]] FunctionDefinition definition(const Dialect& dialect, const Program& program,
                                            const Function& function, Storage storage);

/// Every entry to its target, in the order of storage.
[[nodiscard]] std::string assignments(const Dialect& dialect, const Function& function,
                                      const FieldTexts& entries);

}  // namespace elgen
