// definition: a Function -> the texts of its definition in a compiled language, in parts where it
// is long.
//
//     0 = coordinate x; 1 = sin 0; result = 1      ->      const Scalar sin_x = sin(q[0]);
//                                                          return {{sin_x}};
#pragma once

#include <string>

#include "elgen/scene.hpp"
#include "emit/code/compiled_dialect.hpp"

namespace elgen {

[[nodiscard]] FunctionDefinition definition(const CompiledDialect& dialect, const Program& program,
                                            const Function& function, Storage storage);

/// Every entry to its target, in the order of storage.
[[nodiscard]] std::string assignments(const CompiledDialect& dialect, const Function& function,
                                      const FieldTexts& entries);

}  // namespace elgen
