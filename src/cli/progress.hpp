// Progress on long work: on stderr, only on a terminal, only after half a second, naming the stage.
#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

#include "cli/options.hpp"

namespace elgen::cli {

class Progress {
 public:
  explicit Progress(std::string subject);
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

/// Those of every command: `goals`, unless --stop-after names another.
[[nodiscard]] PipelineOptions pipeline_options(const GlobalOptions& global,
                                               std::vector<std::string> goals);

/// run_pipeline with its stages shown. The line is gone when this returns, before anything of the
/// products is printed.
[[nodiscard]] Products run_shown(const std::string& subject, const Inputs& inputs,
                                 PipelineOptions options);

/// Prints the dump and the diagnostics.
ExitCode report_products(const GlobalOptions& global, const Products& products);

}  // namespace elgen::cli
