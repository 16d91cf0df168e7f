// Runs another program without a shell, so that spaces and quotes in paths mean nothing.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace elgen {

struct ProcessResult {
  bool started = false;     ///< false: no such program, or it may not be run
  int status = -1;          ///< exit status; 128 + signal where a signal ended it
  std::string output = {};  ///< what it wrote to stdout and stderr, in order
};

/// Runs `command` (looked up in $PATH) with no input; `log` is a file its output may pass through.
[[nodiscard]] ProcessResult run(const std::vector<std::string>& command,
                                const std::filesystem::path& log);

}  // namespace elgen
