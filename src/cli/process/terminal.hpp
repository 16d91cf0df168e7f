// terminal: the capabilities of a stream, and the progress of long work on it.
#pragma once

#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <string>
#include <thread>

#include "elgen/page.hpp"

namespace elgen::cli {

[[nodiscard]] bool is_terminal(std::FILE* stream);

/// The width of a terminal, or 80 columns. Unicode if the stream is a terminal, its locale is UTF-8
/// (LC_ALL, LC_CTYPE, LANG), and it is neither `dumb` nor the Linux console.
[[nodiscard]] Screen screen_of(std::FILE* stream);

/// Shows the stage on stderr, only on a terminal and only after half a second.
class Progress {
 public:
  explicit Progress(const std::string& subject);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void stage(const std::string& name) const;

 private:
  void watch();

  std::string subject_;
  mutable std::mutex mutex_;
  mutable std::condition_variable changed_;
  mutable std::string stage_;
  bool done_ = false;
  std::thread watcher_;
};

}  // namespace elgen::cli
