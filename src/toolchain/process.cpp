// process: posix_spawnp starts a new process group, so that the whole group can be killed. One
// poll() waits for output, for the end of the child and for interrupts. Output beyond the limit is
// read and dropped, because a full pipe would block the child.
#include "toolchain/process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <sstream>
#include <utility>

#include "base/descriptor.hpp"
#include "base/no_interrupts.hpp"
#include "base/utf8.hpp"
#include "toolchain/forked.hpp"
#include "toolchain/stream.hpp"

namespace elgen {
namespace {

using Clock = std::chrono::steady_clock;

/// The pointers that exec needs, with null as last element.
std::vector<char*> exec_pointers(std::vector<std::string>& texts) {
  std::vector<char*> result;
  result.reserve(texts.size() + 1);
  for (std::string& text : texts) result.push_back(text.data());
  result.push_back(nullptr);
  return result;
}

/// The environment of this process, with $TMPDIR = `temporary` unless `temporary` is empty.
std::vector<std::string> child_environment(const std::string& temporary) {
  constexpr std::string_view name = "TMPDIR=";
  std::vector<std::string> variables;
  for (char** variable = environ; *variable != nullptr; ++variable) {
    const std::string_view text = *variable;
    if (temporary.empty() || !text.starts_with(name)) variables.emplace_back(text);
  }
  if (!temporary.empty()) variables.push_back(std::string(name) + temporary);
  return variables;
}

/// An unnamed file with this content, positioned at its beginning; not open if writing failed.
FileDescriptor make_memory_file(std::string_view text) {
  FileDescriptor file(::memfd_create("input", MFD_CLOEXEC));
  while (file.is_open() && !text.empty()) {
    const ssize_t count = ::write(file.number(), text.data(), text.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) (void)file.close();
    text.remove_prefix(count > 0 ? static_cast<std::size_t>(count) : 0);
  }
  if (file.is_open()) (void)::lseek(file.number(), 0, SEEK_SET);
  return file;
}

/// Sets up a child: stdin from a file or /dev/null, stdout and stderr into pipes, no signal
/// blocked.
class SpawnSetup {
 public:
  SpawnSetup(const FileDescriptor& input, int output, int errors) {
    posix_spawn_file_actions_init(&actions_);
    if (input.is_open()) {
      posix_spawn_file_actions_adddup2(&actions_, input.number(), 0);
    } else {
      posix_spawn_file_actions_addopen(&actions_, 0, "/dev/null", O_RDONLY, 0);
    }
    posix_spawn_file_actions_adddup2(&actions_, output, 1);
    posix_spawn_file_actions_adddup2(&actions_, errors, 2);
    posix_spawnattr_init(&attributes_);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK);
    posix_spawnattr_setpgroup(&attributes_, 0);
    sigset_t none{};
    sigemptyset(&none);
    posix_spawnattr_setsigmask(&attributes_, &none);
  }
  SpawnSetup(const SpawnSetup&) = delete;
  SpawnSetup& operator=(const SpawnSetup&) = delete;
  ~SpawnSetup() {
    posix_spawn_file_actions_destroy(&actions_);
    posix_spawnattr_destroy(&attributes_);
  }

  [[nodiscard]] std::optional<pid_t> start(std::vector<std::string> command,
                                           std::vector<std::string> variables) const {
    const std::vector<char*> words = exec_pointers(command);
    const std::vector<char*> environment = exec_pointers(variables);
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

int milliseconds_until(Clock::time_point deadline) {
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now());
  return static_cast<int>(std::clamp<std::int64_t>(left.count(), 0, 1'000'000));
}

/// Reads the streams until the child ends, the deadline passes, or an interrupt arrives.
ProcessEnding wait_for_child(Child& child, std::vector<OutputPipe>& streams,
                             const FileDescriptor& signals, Clock::time_point deadline) {
  std::vector<pollfd> events;
  for (const OutputPipe& stream : streams)
    events.push_back({stream.read_end().number(), POLLIN, 0});
  events.push_back({signals.number(), POLLIN, 0});
  while (!child.has_ended()) {
    if (Clock::now() >= deadline) return ProcessEnding::out_of_time;
    (void)::poll(events.data(), events.size(), milliseconds_until(deadline));
    for (std::size_t i = 0; i < streams.size(); ++i) {
      streams[i].drain();
      if ((events[i].revents & POLLHUP) != 0) events[i].fd = -1;
    }
    if (read_interrupt(signals)) return ProcessEnding::interrupted;
  }
  for (OutputPipe& stream : streams) stream.drain();
  return child.ending();
}

/// Runs a command. The first stream gets stdout, the last stream stderr. A single stream gets both.
ProcessResult run_with_streams(std::vector<OutputPipe> streams,
                               const std::vector<std::string>& command, std::uint64_t seconds,
                               const std::string& temporary, std::string_view input = {}) {
  if (command.empty()) return {};
  const SignalBlocker blocks_interrupts;
  const ChildSignalBlock end_of_child;
  const FileDescriptor signals = open_signal_descriptor();
  if (!signals.is_open() || !std::ranges::all_of(streams, &OutputPipe::is_open)) return {};
  const FileDescriptor file = input.empty() ? FileDescriptor() : make_memory_file(input);
  if (!input.empty() && !file.is_open()) return {};
  const SpawnSetup circumstances(file, streams.front().write_end().number(),
                                 streams.back().write_end().number());
  const std::optional<pid_t> id = circumstances.start(command, child_environment(temporary));
  for (OutputPipe& stream : streams) stream.close_write_end();
  if (!id) return {};
  const auto deadline = Clock::now() + std::chrono::seconds(std::min(seconds, max_run_seconds));
  Child child(*id);
  const ProcessEnding ending = wait_for_child(child, streams, signals, deadline);
  return {ending, child.status(), streams.front().take_text(), streams.back().take_text()};
}

constexpr std::size_t max_plain_bytes = 4000;
constexpr char escape = '\x1b';
constexpr char bell = '\a';

// Escape sequences of ECMA-48: ESC [ parameters letter; ESC ] text BEL; ESC and one character.

/// The position after the escape sequence that begins at `position`.
std::size_t skip_escape_sequence(std::string_view text, std::size_t position) {
  const char kind = position + 1 < text.size() ? text[position + 1] : '\0';
  if (kind != '[' && kind != ']') return position + 2;
  for (std::size_t i = position + 2; i < text.size(); ++i) {
    const bool ends = kind == '[' ? text[i] >= '@' && text[i] <= '~' : text[i] == bell;
    if (ends) return i + 1;
    if (text[i] == '\n') return i;
    if (kind == ']' && text[i] == escape) return i + 2;  // ESC \ also ends the text
  }
  return text.size();
}

}  // namespace

ProcessResult run_process(const std::vector<std::string>& command, std::uint64_t seconds,
                          const std::string& temporary) {
  std::vector<OutputPipe> both;
  both.emplace_back(max_message_bytes);
  return run_with_streams(std::move(both), command, seconds, temporary);
}

ProcessResult run_with_input(const std::vector<std::string>& command, std::uint64_t seconds,
                             std::size_t most_output, std::string_view input) {
  std::vector<OutputPipe> streams;
  streams.emplace_back(most_output);
  streams.emplace_back(max_message_bytes);
  return run_with_streams(std::move(streams), command, seconds, {}, input);
}

std::vector<std::string> words_of_command(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

std::string ending_text(ProcessEnding ending, int status, std::uint64_t seconds) {
  if (ending == ProcessEnding::not_started) return "could not be run";
  if (ending == ProcessEnding::out_of_time)
    return fmt::format("has not ended within {} s", seconds);
  if (ending != ProcessEnding::signalled) return fmt::format("exits {}", status);
  // The text of strsignal is English, because the locale is always "C". glibc's sigabbrev_np does
  // not exist elsewhere.
  return fmt::format("was ended by signal {} ({})", status - 128, ::strsignal(status - 128));
}

std::optional<std::vector<double>> parse_numbers(std::string_view line) {
  constexpr std::string_view between = "[], \t\r";
  const std::string text(line);  // ends with a null, as strtod needs
  std::vector<double> numbers;
  const char* const end = text.data() + text.size();
  for (const char* at = text.data(); at != end;) {
    if (between.find(*at) != std::string_view::npos) {
      ++at;
      continue;
    }
    // libc++ before 20 lacks from_chars for double. strtod reads "." because the locale is always
    // "C".
    char* stop = nullptr;
    numbers.push_back(std::strtod(at, &stop));
    const bool ends = stop == end || between.find(*stop) != std::string_view::npos;
    if (stop == at || !ends) return std::nullopt;
    at = stop;
  }
  return numbers;
}

std::string sanitize_output(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size();) {
    if (text[i] == escape) {
      i = skip_escape_sequence(text, i);
      continue;
    }
    const CodePoint point = code_point_at(text, i);
    if (point.bytes == 0 || plain.size() > max_plain_bytes) return plain + "…\n";
    if (text[i] == '\n' || !is_hidden(point.value)) plain += text.substr(i, point.bytes);
    i += point.bytes;
  }
  return plain;
}

std::string indent_output(std::string_view text) {
  std::istringstream lines(sanitize_output(text));
  std::string quoted;
  for (std::string line; std::getline(lines, line);) quoted += "\n    " + line;
  return quoted.empty() ? quoted : ":" + quoted;
}

}  // namespace elgen
