// Interpreted: modules in languages that an interpreter runs, as compiled headers are.
#pragma once

#include "elgen/limits.hpp"
#include "elgen/toolchain.hpp"
#include "toolchain/driver.hpp"

namespace elgen {

/// The module, run by $PYTHON or python3 and the like, which each CompiledModel::call_all starts
/// once. Where there is none, or one too old, its functions are lacking. E705 where it refuses the
/// module, E706 without room for it.
[[nodiscard]] Result<CompiledHeaders> interpret(const EmittedFiles& files, const DriverInput& input,
                                                const Limits& limits);

}  // namespace elgen
