// definition: a Function -> its definition in a compiled language, in parts if it is long.
//
//     0 = coordinate x; 1 = sin 0; result = 1      ->      const Scalar sin_x = sin(q[0]);
//                                                          return {{sin_x}};
#pragma once

#include <string>

#include "elgen/scene.hpp"
#include "emit/code/compiled_dialect.hpp"

namespace elgen {

[[nodiscard]] FunctionDefinition function_definition(const CompiledDialect& dialect,
                                                     const Program& program,
                                                     const Function& function, Storage storage);

/// The statements that assign every entry to its target, in storage order.
[[nodiscard]] std::string entry_assignments(const CompiledDialect& dialect,
                                            const Function& function, const FieldTexts& entries);

}  // namespace elgen
