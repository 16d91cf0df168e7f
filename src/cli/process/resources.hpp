// Time and memory limits of the process, and its end by a signal.
#pragma once

#include <string>

#include "elgen/diagnostic.hpp"
#include "elgen/limits.hpp"

namespace elgen::cli {

/// Processor time ends the process with E909 and exit code 3, memory throws std::bad_alloc, an
/// interrupt (SIGINT, SIGTERM or SIGHUP, unless ignored) ends it with 130; in a scope of
/// NoInterrupts they wait.
void set_resource_limits(const Limits& limits, const DiagnosticStyle& style);

/// E909 names this stage from now on; "" for none.
void name_stage(const std::string& stage);

/// Gives the next input as much processor time as the first one had.
void renew_time_limit(const Limits& limits);

/// While this lives, `limits.seconds` by the clock end the process with E909 and exit code 3: an
/// input may never arrive.
class WaitingLimit {
 public:
  WaitingLimit(const Limits& limits, const std::string& path);
  WaitingLimit(const WaitingLimit&) = delete;
  WaitingLimit& operator=(const WaitingLimit&) = delete;
  ~WaitingLimit();
};

[[nodiscard]] Diagnostic out_of_memory(const Limits& limits);

}  // namespace elgen::cli
