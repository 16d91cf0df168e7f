// Children are waited for by id: this process may have others.
#include "toolchain/child.hpp"

#include <sys/signalfd.h>
#include <sys/wait.h>

#include <cerrno>

#include "base/no_interrupts.hpp"

namespace elgen {

ChildSignal::ChildSignal() {
  struct sigaction standard {};
  standard.sa_handler = SIG_DFL;
  sigaction(SIGCHLD, &standard, &action_);
  sigset_t set{};
  sigemptyset(&set);
  sigaddset(&set, SIGCHLD);
  pthread_sigmask(SIG_BLOCK, &set, &mask_);
}

ChildSignal::~ChildSignal() {
  pthread_sigmask(SIG_SETMASK, &mask_, nullptr);
  sigaction(SIGCHLD, &action_, nullptr);
}

Child::~Child() {
  if (has_ended_) return;
  (void)::kill(-id_, SIGKILL);
  while (::waitpid(id_, &state_, 0) < 0 && errno == EINTR) {
  }
}

bool Child::has_ended() {
  has_ended_ = has_ended_ || ::waitpid(id_, &state_, WNOHANG) == id_;
  return has_ended_;
}

Ending Child::ending() const { return WIFEXITED(state_) ? Ending::exited : Ending::signalled; }

int Child::status() const {
  if (!has_ended_) return -1;
  return WIFEXITED(state_) ? WEXITSTATUS(state_) : 128 + WTERMSIG(state_);
}

Descriptor signals_to_wait_for() {
  sigset_t set = ending_signals();
  sigaddset(&set, SIGCHLD);
  return Descriptor(::signalfd(-1, &set, SFD_CLOEXEC | SFD_NONBLOCK));
}

bool take_interrupt(const Descriptor& signals) {
  signalfd_siginfo taken{};
  if (::read(signals.number(), &taken, sizeof taken) != sizeof taken) return false;
  const auto signal = static_cast<int>(taken.ssi_signo);
  return signal != SIGCHLD && ::raise(signal) == 0;
}

}  // namespace elgen
