// no_interrupts: delays signals that would end the process in the middle of an action.
#pragma once

#include <csignal>

namespace elgen {

/// The signals that ask the process to end, except signals that it was started to ignore.
[[nodiscard]] sigset_t ending_signals();

/// Blocks ending signals while it exists. Pending signals arrive when it is destroyed.
class NoInterrupts {
 public:
  NoInterrupts();
  NoInterrupts(const NoInterrupts&) = delete;
  NoInterrupts& operator=(const NoInterrupts&) = delete;
  ~NoInterrupts();

 private:
  sigset_t before_{};
};

/// True if an ending signal is pending.
[[nodiscard]] bool has_pending_interrupt();

}  // namespace elgen
