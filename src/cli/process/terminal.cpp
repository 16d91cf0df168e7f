// terminal: the width comes from the system, the alphabet from environment variables. A thread
// shows the progress on one line, and clears the line at the end.
#include "cli/process/terminal.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "base/ascii.hpp"
#include "cli/process/resources.hpp"
#include "elgen/wording.hpp"

namespace elgen::cli {
namespace {

constexpr std::size_t usual_columns = 80;
constexpr std::size_t least_columns = 40;  ///< narrower terminals wrap lines

std::string environment_variable(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

/// True if the locale is UTF-8. The first variable that is set decides, as in setlocale(3).
bool has_utf8_locale() {
  for (const char* const name : {"LC_ALL", "LC_CTYPE", "LANG"}) {
    std::string value = environment_variable(name);
    if (value.empty()) continue;
    std::ranges::transform(value, value.begin(), to_lower_case);
    return value.find("utf-8") != std::string::npos || value.find("utf8") != std::string::npos;
  }
  return false;
}

constexpr std::chrono::milliseconds display_delay{500};
constexpr std::chrono::milliseconds refresh{200};

}  // namespace

bool is_terminal(std::FILE* stream) { return ::isatty(::fileno(stream)) != 0; }

Screen screen_of(std::FILE* stream) {
  Screen screen{usual_columns, Alphabet::ascii};
  if (!is_terminal(stream)) return screen;
  winsize size{};
  const bool is_known = ::ioctl(::fileno(stream), TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  if (is_known) screen.columns = std::max<std::size_t>(size.ws_col, least_columns);
  const std::string kind = environment_variable("TERM");
  if (has_utf8_locale() && kind != "dumb" && kind != "linux") screen.alphabet = Alphabet::unicode;
  return screen;
}

Progress::Progress(const std::string& subject) : subject_(printable_path(subject)) {
  if (!is_terminal(stderr)) return;
  // The new thread inherits the blocked signals. If it left SIGCHLD open, it would take the signal
  // from the first thread, which would then wait for a compiler that has ended.
  sigset_t all{};
  sigset_t before{};
  sigfillset(&all);
  pthread_sigmask(SIG_BLOCK, &all, &before);
  watcher_ = std::thread([this] { run_display(); });
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

Progress::~Progress() {
  set_stage_name("");
  {
    const std::lock_guard lock(mutex_);
    is_done_ = true;
  }
  changed_.notify_all();
  if (watcher_.joinable()) watcher_.join();
}

void Progress::show_stage(const std::string& name) const {
  set_stage_name(name);
  const std::lock_guard lock(mutex_);
  stage_ = name;
}

void Progress::run_display() {
  std::unique_lock lock(mutex_);
  const auto is_done = [this] { return is_done_; };
  if (changed_.wait_for(lock, display_delay, is_done)) return;
  do {
    fmt::print(stderr, "\r\x1b[K{}: {} …", subject_, stage_);
    std::fflush(stderr);
  } while (!changed_.wait_for(lock, refresh, is_done));
  fmt::print(stderr, "\r\x1b[K");
  std::fflush(stderr);
}

}  // namespace elgen::cli
