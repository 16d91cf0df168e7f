// Limits the time and memory of the process, and handles the signals that end the process.
#pragma once

#include <string>

#include "elgen/diagnostic.hpp"
#include "elgen/limits.hpp"

namespace elgen::cli {

/// Sets the limits. If processor time exceeds its limit, the process ends with E909 and exit code
/// 3. If memory exceeds its limit, allocations throw std::bad_alloc. SIGINT, SIGTERM and SIGHUP end
/// the process with exit code 130, unless the signal was ignored when the process started. A
/// SignalBlocker defers these three signals.
void set_resource_limits(const Limits& limits, const DiagnosticStyle& style);

/// Sets the stage that E909 names; "" for none.
void set_stage_name(const std::string& stage);

/// Restarts the limit of processor time, for the next input.
void renew_time_limit(const Limits& limits);

/// While an InputTimeout exists, the process ends with E909 and exit code 3 after `limits.seconds`
/// of real time, because an input may never arrive.
class InputTimeout {
 public:
  InputTimeout(const Limits& limits, const std::string& path);
  InputTimeout(const InputTimeout&) = delete;
  InputTimeout& operator=(const InputTimeout&) = delete;
  ~InputTimeout();
};

[[nodiscard]] Diagnostic memory_limit_error(const Limits& limits);

}  // namespace elgen::cli
