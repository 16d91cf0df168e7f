// Progress on long work: on stderr, only on a terminal, only after half a second, naming the stage.
#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace elgen::cli {

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
