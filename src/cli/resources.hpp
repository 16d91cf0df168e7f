// Time and memory limits of the process, and its end by a signal.
#pragma once

#include "elgen/diagnostic.hpp"
#include "elgen/limits.hpp"

namespace elgen::cli {

/// Processor time ends the process with E909 and exit code 3, memory throws std::bad_alloc, an
/// interrupt ends it with 130; while files are written, both wait.
void set_resource_limits(const Limits& limits, const DiagnosticStyle& style);

/// Gives the next input as much processor time as the first one had.
void renew_time_limit(const Limits& limits);

[[nodiscard]] Diagnostic out_of_memory(const Limits& limits);

}  // namespace elgen::cli
