// no_interrupts: delays signals that would end the process in the middle of an action.
#pragma once

#include <csignal>

namespace elgen {

/// The signals that ask the process to end, except signals that the process ignores.
[[nodiscard]] sigset_t ending_signals();

/// While an object of this class exists, ending_signals() are blocked. Signals that arrive in this
/// time are delivered when the object is destroyed.
class NoInterrupts {
 public:
  NoInterrupts();
  NoInterrupts(const NoInterrupts&) = delete;
  NoInterrupts& operator=(const NoInterrupts&) = delete;
  ~NoInterrupts();

 private:
  sigset_t before_{};
};

/// True if one of ending_signals() is blocked and has arrived.
[[nodiscard]] bool has_pending_interrupt();

}  // namespace elgen
