// forked: work in processes of its own, so that all cores compute.
#pragma once

#include <cstddef>
#include <functional>

#include "toolchain/process.hpp"

namespace elgen {

/// What became of all of them: exited with 0, or how the first that failed has ended.
struct ForkedEnding {
  Ending ending = Ending::exited;
  int status = 0;  ///< as of a ProcessResult

  [[nodiscard]] bool succeeded() const { return ending == Ending::exited && status == 0; }
};

/// Calls work(0) ... work(count - 1), each in a fork of this process, and waits for all; where one
/// fails, or an interrupt comes, the others are ended. What they compute they leave in a
/// SharedArray, or in a file that is open before. `on_wait` is called five times a second
/// meanwhile. A process that uses up the processor time it may is out_of_time; one that throws
/// exits 70.
[[nodiscard]] ForkedEnding run_forked(std::size_t count,
                                      const std::function<void(std::size_t)>& work,
                                      const std::function<void()>& on_wait);

}  // namespace elgen
