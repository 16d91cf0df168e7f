// Shards of verify: what was screened, and of which states.
#pragma once

#include "cli/shards/shard_file.hpp"
#include "elgen/screening.hpp"

namespace elgen::cli {

struct ScreeningShard {
  ShardHead head = {};
  std::uint64_t samples = 0;
  std::uint64_t seed = 1;
  Screening screening = {};
};

/// As JSON, in one line.
[[nodiscard]] std::string to_json(const ScreeningShard& shard);

/// What one process would have screened. E111, E707, E711, E712 of the files, on this machine; E704
/// and E909 as of this_machine.
[[nodiscard]] Result<ScreeningShard> merged_screening(const std::vector<std::string>& paths,
                                                      const Limits& limits);

}  // namespace elgen::cli
