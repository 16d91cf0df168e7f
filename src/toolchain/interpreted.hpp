// interpreted: modules in interpreted languages, with the interface of compiled headers.
#pragma once

#include "elgen/limits.hpp"
#include "elgen/toolchain.hpp"
#include "toolchain/driver.hpp"

namespace elgen {

/// The module, run by the interpreter of the language ($PYTHON or python3, for instance), which
/// each CompiledModel::call_all starts once. If no interpreter is found or it is too old, `lacking`
/// has the reason and the header no functions. E705 if the interpreter refuses the module, E706
/// without room for files.
[[nodiscard]] Result<CompiledHeaders> interpret(const EmittedFiles& files, const DriverInput& input,
                                                const Limits& limits);

}  // namespace elgen
