// A watching thread rewrites one line of the terminal, and clears it at the end.
#include "cli/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <utility>

#include "base/no_interrupts.hpp"

namespace elgen::cli {

namespace {

constexpr std::chrono::milliseconds patience{500};
constexpr std::chrono::milliseconds refresh{200};

}  // namespace

Progress::Progress(std::string subject) : subject_(std::move(subject)) {
  if (::isatty(STDERR_FILENO) == 0) return;
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

PipelineOptions pipeline_options(const GlobalOptions& global, std::vector<std::string> goals) {
  PipelineOptions pipeline;
  pipeline.limits = global.limits;
  pipeline.dump_stage = global.dump_stage;
  pipeline.goals = std::move(goals);
  if (!global.stop_after.empty()) pipeline.goals = {global.stop_after};
  return pipeline;
}

Products run_shown(const std::string& subject, const Inputs& inputs, PipelineOptions options) {
  const Progress progress(subject);
  options.on_stage = [&](const std::string& stage) { progress.stage(stage); };
  return run_pipeline(inputs, options);
}

ExitCode report_products(const GlobalOptions& global, const Products& products) {
  const ExitCode dumped = print(global, products.dump);
  return std::max(dumped, report(global, products.diagnostics));
}

}  // namespace elgen::cli
