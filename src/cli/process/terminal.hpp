// terminal: the capabilities of a stream, and the display of progress.
#pragma once

#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <string>
#include <thread>

#include "elgen/page.hpp"

namespace elgen::cli {

[[nodiscard]] bool is_terminal(std::FILE* stream);

/// The width of the terminal `stream`, or 80 columns if `stream` is no terminal. Unicode if
/// `stream` is a terminal with a UTF-8 locale (LC_ALL, LC_CTYPE, LANG), and TERM is neither `dumb`
/// nor `linux`.
[[nodiscard]] Screen screen_of(std::FILE* stream);

/// If stderr is a terminal, shows the current stage on stderr after the first half second.
class Progress {
 public:
  explicit Progress(const std::string& subject);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void show_stage(const std::string& name) const;

 private:
  void run_display();

  std::string subject_;
  mutable std::mutex mutex_;
  mutable std::condition_variable changed_;
  mutable std::string stage_;
  bool is_done_ = false;
  std::thread watcher_;
};

}  // namespace elgen::cli
