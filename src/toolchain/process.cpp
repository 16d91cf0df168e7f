// run: posix_spawnp into a process group of its own, so that all of it can be ended. One poll waits
// for the output, the end of the child and interrupts; output beyond what is kept is read and
// dropped, so that the child never waits for us.
#include "toolchain/process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <optional>

#include "base/descriptor.hpp"
#include "base/no_interrupts.hpp"
#include "toolchain/child.hpp"

namespace elgen {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t most_output = 1U << 14U;

/// As the system wants them, with a null at the end.
std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> result;
  result.reserve(texts.size() + 1);
  for (std::string& text : texts) result.push_back(text.data());
  result.push_back(nullptr);
  return result;
}

/// Ours, with another $TMPDIR.
std::vector<std::string> variables_with(const std::string& temporary) {
  constexpr std::string_view name = "TMPDIR=";
  std::vector<std::string> variables;
  for (char** variable = environ; *variable != nullptr; ++variable) {
    const std::string_view text = *variable;
    if (temporary.empty() || !text.starts_with(name)) variables.emplace_back(text);
  }
  if (!temporary.empty()) variables.push_back(std::string(name) + temporary);
  return variables;
}

/// stdin from nowhere, stdout and stderr into one pipe; signals as in a fresh process.
class Circumstances {
 public:
  explicit Circumstances(int output) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addopen(&actions_, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions_, output, 1);
    posix_spawn_file_actions_adddup2(&actions_, output, 2);
    posix_spawnattr_init(&attributes_);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK);
    posix_spawnattr_setpgroup(&attributes_, 0);
    sigset_t none{};
    sigemptyset(&none);
    posix_spawnattr_setsigmask(&attributes_, &none);
  }
  Circumstances(const Circumstances&) = delete;
  Circumstances& operator=(const Circumstances&) = delete;
  ~Circumstances() {
    posix_spawn_file_actions_destroy(&actions_);
    posix_spawnattr_destroy(&attributes_);
  }

  [[nodiscard]] std::optional<pid_t> start(std::vector<std::string> command,
                                           std::vector<std::string> variables) const {
    const std::vector<char*> words = pointers(command);
    const std::vector<char*> environment = pointers(variables);
    pid_t child = 0;
    const int error = posix_spawnp(&child, words.front(), &actions_, &attributes_, words.data(),
                                   environment.data());
    if (error != 0) return std::nullopt;
    return child;
  }

 private:
  posix_spawn_file_actions_t actions_{};
  posix_spawnattr_t attributes_{};
};

/// Reads what is there, and keeps the first part of it.
void drain(const Descriptor& pipe, std::string& output) {
  std::array<char, 4096> part{};
  while (true) {
    const ssize_t count = ::read(pipe.number(), part.data(), part.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return;
    const std::size_t space = most_output - output.size();
    output.append(part.data(), std::min(static_cast<std::size_t>(count), space));
  }
}

int milliseconds_until(Clock::time_point deadline) {
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now());
  return static_cast<int>(std::clamp<std::int64_t>(left.count(), 0, 1'000'000));
}

/// Until the child ends, the time is over, or an interrupt comes.
Ending wait_for(Child& child, const Descriptor& pipe, const Descriptor& signals,
                Clock::time_point deadline, std::string& output) {
  std::array<pollfd, 2> events{pollfd{pipe.number(), POLLIN, 0},
                               pollfd{signals.number(), POLLIN, 0}};
  while (!child.has_ended()) {
    if (Clock::now() >= deadline) return Ending::out_of_time;
    (void)::poll(events.data(), events.size(), milliseconds_until(deadline));
    drain(pipe, output);
    if ((events[0].revents & POLLHUP) != 0) events[0].fd = -1;
    if (take_interrupt(signals)) return Ending::interrupted;
  }
  drain(pipe, output);
  return child.ending();
}

}  // namespace

ProcessResult run(const std::vector<std::string>& command, std::uint64_t seconds,
                  const std::string& temporary) {
  constexpr std::uint64_t longest = 1U << 30U;
  if (command.empty()) return {};
  const NoInterrupts taken_in_turn;
  const ChildSignal end_of_child;
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) return {};
  const Descriptor pipe(ends[0]);
  Descriptor child_output(ends[1]);
  const Descriptor signals = signals_to_wait_for();
  if (!signals.is_open() || ::fcntl(pipe.number(), F_SETFL, O_NONBLOCK) != 0) return {};
  const std::optional<pid_t> id =
      Circumstances(child_output.number()).start(command, variables_with(temporary));
  (void)child_output.close();
  if (!id) return {};
  const auto deadline = Clock::now() + std::chrono::seconds(std::min(seconds, longest));
  ProcessResult result;
  Child child(*id);
  result.ending = wait_for(child, pipe, signals, deadline, result.output);
  result.status = child.status();
  return result;
}

}  // namespace elgen
