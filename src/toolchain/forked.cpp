// forked: waits for children by their ids, because this process may have other children.
//
// run_forked() forks without exec, so children have everything that this process has loaded and
// computed. If this process ends, for whatever reason, its children are killed.
#include "toolchain/forked.hpp"

#include <poll.h>
#include <sys/prctl.h>
#include <sys/signalfd.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <list>
#include <optional>

#include "base/no_interrupts.hpp"

namespace elgen {
namespace {

constexpr int poll_interval_ms = 200;
constexpr int status_of_exception = 70;

/// Restores the default handlers in a child, so that a signal ends the child; the parent reports
/// the signal.
void reset_handlers() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGXCPU, SIGALRM, SIGCHLD, SIGSEGV, SIGABRT,
                           SIGBUS, SIGFPE, SIGILL}) {
    (void)std::signal(signal, SIG_DFL);
  }
  sigset_t none{};
  sigemptyset(&none);
  pthread_sigmask(SIG_SETMASK, &none, nullptr);
}

[[noreturn]] void run_child(pid_t parent, std::size_t number,
                            const std::function<void(std::size_t)>& work) {
  (void)::setpgid(0, 0);
  reset_handlers();
  (void)::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(status_of_exception);
  try {
    work(number);
  } catch (...) {
    ::_exit(status_of_exception);
  }
  ::_exit(0);
}

/// The ending of the first child that failed, if any. Without a failure, sets `running` to the
/// number of running children.
std::optional<ForkResult> find_failure(std::list<Child>& children, std::size_t& running) {
  running = 0;
  for (Child& child : children) {
    if (!child.has_ended()) {
      ++running;
    } else if (child.status() != 0) {
      const bool is_late = child.status() == 128 + SIGXCPU;
      return ForkResult{is_late ? ProcessEnding::out_of_time : child.ending(), child.status()};
    }
  }
  return std::nullopt;
}

}  // namespace

ChildSignalBlock::ChildSignalBlock() {
  struct sigaction standard {};
  standard.sa_handler = SIG_DFL;
  sigaction(SIGCHLD, &standard, &action_);
  sigset_t set{};
  sigemptyset(&set);
  sigaddset(&set, SIGCHLD);
  pthread_sigmask(SIG_BLOCK, &set, &mask_);
}

ChildSignalBlock::~ChildSignalBlock() {
  pthread_sigmask(SIG_SETMASK, &mask_, nullptr);
  sigaction(SIGCHLD, &action_, nullptr);
}

Child::~Child() {
  if (!has_ended_) end_group();
}

void Child::end_group() {
  (void)::kill(-id_, SIGKILL);
  while (::waitpid(id_, &state_, 0) < 0 && errno == EINTR) {
  }
  has_ended_ = true;
}

bool Child::has_ended() {
  if (has_ended_) return true;
  siginfo_t end{};
  // WNOWAIT keeps the id reserved until the group has been killed; otherwise a new group could get
  // the id.
  const auto id = static_cast<id_t>(id_);
  if (::waitid(P_PID, id, &end, WEXITED | WNOHANG | WNOWAIT) == 0 && end.si_pid == id_) end_group();
  return has_ended_;
}

ProcessEnding Child::ending() const {
  return WIFEXITED(state_) ? ProcessEnding::exited : ProcessEnding::signalled;
}

int Child::status() const {
  if (!has_ended_) return -1;
  return WIFEXITED(state_) ? WEXITSTATUS(state_) : 128 + WTERMSIG(state_);
}

FileDescriptor open_signal_descriptor() {
  sigset_t set = termination_signals();
  sigaddset(&set, SIGCHLD);
  return FileDescriptor(::signalfd(-1, &set, SFD_CLOEXEC | SFD_NONBLOCK));
}

bool read_interrupt(const FileDescriptor& signals) {
  signalfd_siginfo info{};
  if (::read(signals.number(), &info, sizeof info) != sizeof info) return false;
  const auto signal = static_cast<int>(info.ssi_signo);
  return signal != SIGCHLD && ::raise(signal) == 0;
}

ForkResult run_forked(std::size_t count, const std::function<void(std::size_t)>& work,
                      const std::function<void()>& on_wait, std::uint64_t seconds) {
  using Clock = std::chrono::steady_clock;
  const auto deadline = Clock::now() + std::chrono::seconds(std::min(seconds, max_run_seconds));
  const SignalBlocker blocks_interrupts;
  const ChildSignalBlock end_of_child;
  const FileDescriptor signals = open_signal_descriptor();
  if (!signals.is_open()) return {ProcessEnding::not_started, -1};
  const pid_t parent = ::getpid();
  std::list<Child> children;
  for (std::size_t i = 0; i < count; ++i) {
    const pid_t id = ::fork();
    if (id == 0) run_child(parent, i, work);
    if (id < 0) return {ProcessEnding::not_started, -1};
    (void)::setpgid(id, id);  // in both processes, because either may run first
    children.emplace_back(id);
  }
  pollfd event{signals.number(), POLLIN, 0};
  for (std::size_t running = count; running > 0;) {
    (void)::poll(&event, 1, poll_interval_ms);
    if (read_interrupt(signals)) return {ProcessEnding::interrupted, -1};
    if (const auto failed = find_failure(children, running)) return *failed;
    if (running > 0 && Clock::now() >= deadline) return {ProcessEnding::out_of_time, -1};
    on_wait();
  }
  return {};
}

}  // namespace elgen
