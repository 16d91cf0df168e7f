// no_interrupts: what would end the process has to wait while something is half done.
#pragma once

#include <csignal>

namespace elgen {

/// The signals that ask the process to end, without those it was started to ignore.
[[nodiscard]] sigset_t ending_signals();

/// While this lives, ending signals wait. They arrive when it goes.
class NoInterrupts {
 public:
  NoInterrupts();
  NoInterrupts(const NoInterrupts&) = delete;
  NoInterrupts& operator=(const NoInterrupts&) = delete;
  ~NoInterrupts();

 private:
  sigset_t before_{};
};

/// Whether an ending signal waits.
[[nodiscard]] bool interrupt_waits();

}  // namespace elgen
