// Process: a command under limits of processor time and memory, by words, without a shell between.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace elgen::fuzz {

struct Ended {
  int status = 0;           ///< the exit code, where it ended by itself
  int signal = 0;           ///< that ended it, or 0
  std::string output = {};  ///< standard output
  std::string errors = {};  ///< standard error
};

struct ProcessLimits {
  unsigned seconds = 60;  ///< of processor time
  unsigned long memory_mib = 4096;
};

/// Runs words[0] in `folder`, without standard input. Throws where it cannot be started.
[[nodiscard]] Ended run(const std::vector<std::string>& words, const std::filesystem::path& folder,
                        const ProcessLimits& limits);

}  // namespace elgen::fuzz
