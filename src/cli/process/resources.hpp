// Time and memory limits of the process, and its end by a signal.
#pragma once

#include <string>

#include "elgen/diagnostic.hpp"
#include "elgen/limits.hpp"

namespace elgen::cli {

/// Beyond the limit of processor time the process ends with E909 and exit code 3; beyond the limit
/// of memory allocations throw std::bad_alloc. SIGINT, SIGTERM and SIGHUP end it with 130, unless
/// ignored. In a scope of NoInterrupts these signals are deferred.
void set_resource_limits(const Limits& limits, const DiagnosticStyle& style);

/// Sets the stage that E909 names; "" for none.
void name_stage(const std::string& stage);

/// Restarts the limit of processor time for the next input.
void renew_time_limit(const Limits& limits);

/// While this exists, the process ends with E909 and exit code 3 after `limits.seconds` of real
/// time, because an input may never arrive.
class WaitingLimit {
 public:
  WaitingLimit(const Limits& limits, const std::string& path);
  WaitingLimit(const WaitingLimit&) = delete;
  WaitingLimit& operator=(const WaitingLimit&) = delete;
  ~WaitingLimit();
};

[[nodiscard]] Diagnostic out_of_memory(const Limits& limits);

}  // namespace elgen::cli
