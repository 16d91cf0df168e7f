// no_interrupts: delays signals that would end the process in the middle of an action.
#pragma once

#include <csignal>

namespace elgen {

/// The signals that ask the process to end, except signals that the process ignores.
[[nodiscard]] sigset_t termination_signals();

/// While an object of this class exists, termination_signals() are blocked. Signals that arrive in
/// this time are delivered when the object is destroyed.
class SignalBlocker {
 public:
  SignalBlocker();
  SignalBlocker(const SignalBlocker&) = delete;
  SignalBlocker& operator=(const SignalBlocker&) = delete;
  ~SignalBlocker();

 private:
  sigset_t before_{};
};

/// True if one of termination_signals() is blocked and has arrived.
[[nodiscard]] bool has_pending_interrupt();

}  // namespace elgen
