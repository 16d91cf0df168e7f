// Runs another program without a shell, so that spaces and quotes in paths mean nothing.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace elgen {

enum class Ending : unsigned char {
  not_started,  ///< no such program, or it may not be run
  exited,
  signalled,    ///< a crash, or somebody ended it
  out_of_time,  ///< ended, with all the processes it started
  interrupted,  ///< likewise: a signal asks this process to end, and waits
};

struct ProcessResult {
  Ending ending = Ending::not_started;
  int status = -1;          ///< exit status; 128 + signal where a signal ended it
  std::string output = {};  ///< the first 16 KiB written to stdout and stderr, in order

  [[nodiscard]] bool succeeded() const { return ending == Ending::exited && status == 0; }
};

/// Runs `command` (looked up in $PATH) with no input, for `seconds` at most. `temporary` is its
/// $TMPDIR, which has what it leaves there where it is ended; empty: ours.
[[nodiscard]] ProcessResult run(const std::vector<std::string>& command, std::uint64_t seconds,
                                const std::string& temporary = {});

}  // namespace elgen
