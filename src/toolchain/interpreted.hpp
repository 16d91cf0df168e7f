// interpreted: calls modules in interpreted languages through the interface of compiled headers.
#pragma once

#include "elgen/limits.hpp"
#include "elgen/toolchain.hpp"
#include "toolchain/driver.hpp"

namespace elgen {

/// The module, run by the interpreter of its language ($PYTHON or python3, for example). Each
/// CompiledModel::call_at_states starts the interpreter once. If the interpreter is missing or too
/// old, the header has no functions, and `failure_reason` says why. E705 if the interpreter refuses
/// the module; E706 if files cannot be written.
[[nodiscard]] Result<CompiledHeaders> load_interpreted_module(const EmittedFiles& files,
                                                              const DriverInput& input,
                                                              const Limits& limits);

}  // namespace elgen
