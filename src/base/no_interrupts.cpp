// no_interrupts: signals are blocked only in the thread that creates a SignalBlocker. Other threads
// must block them too, as the thread of Progress does.
#include "base/no_interrupts.hpp"

#include <array>

namespace elgen {

namespace {

constexpr std::array signals{SIGINT, SIGTERM, SIGHUP, SIGXCPU};

/// True if the process ignores the signal. An ignored signal must not be blocked: it would become
/// pending and look like an interrupt.
bool is_ignored(int signal) {
  struct sigaction action {};
  sigaction(signal, nullptr, &action);
  return action.sa_handler == SIG_IGN;
}

}  // namespace

sigset_t termination_signals() {
  sigset_t set{};
  sigemptyset(&set);
  for (const int signal : signals) {
    if (!is_ignored(signal)) sigaddset(&set, signal);
  }
  return set;
}

SignalBlocker::SignalBlocker() {
  const sigset_t ending = termination_signals();
  pthread_sigmask(SIG_BLOCK, &ending, &before_);
}

SignalBlocker::~SignalBlocker() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

bool has_pending_interrupt() {
  sigset_t waiting{};
  sigpending(&waiting);
  const sigset_t ending = termination_signals();
  for (const int signal : signals) {
    if (sigismember(&waiting, signal) == 1 && sigismember(&ending, signal) == 1) return true;
  }
  return false;
}

}  // namespace elgen
