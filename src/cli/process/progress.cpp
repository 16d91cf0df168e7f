// A watching thread rewrites one line of the terminal, and clears it at the end.
#include "cli/process/progress.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>

#include "base/no_interrupts.hpp"
#include "cli/process/terminal.hpp"
#include "elgen/wording.hpp"

namespace elgen::cli {

namespace {

constexpr std::chrono::milliseconds patience{500};
constexpr std::chrono::milliseconds refresh{200};

}  // namespace

Progress::Progress(const std::string& subject) : subject_(shown_path(subject)) {
  if (!is_terminal(stderr)) return;
  const NoInterrupts inherited;  // signals are the affair of the thread that works
  watcher_ = std::thread([this] { watch(); });
}

Progress::~Progress() {
  {
    const std::lock_guard lock(mutex_);
    done_ = true;
  }
  changed_.notify_all();
  if (watcher_.joinable()) watcher_.join();
}

void Progress::stage(const std::string& name) const {
  const std::lock_guard lock(mutex_);
  stage_ = name;
}

void Progress::watch() {
  std::unique_lock lock(mutex_);
  const auto is_done = [this] { return done_; };
  if (changed_.wait_for(lock, patience, is_done)) return;
  do {
    fmt::print(stderr, "\r\x1b[K{}: {} …", subject_, stage_);
    std::fflush(stderr);
  } while (!changed_.wait_for(lock, refresh, is_done));
  fmt::print(stderr, "\r\x1b[K");
  std::fflush(stderr);
}

}  // namespace elgen::cli
