// Shards of tradeoff: what was measured, and what was asked for.
#pragma once

#include <optional>

#include "cli/shards/shard_file.hpp"
#include "elgen/tradeoff.hpp"

namespace elgen::cli {

struct TradeoffShard {
  ShardHead head = {};
  std::vector<std::string> dimensions = {};  ///< --dimensions
  std::vector<std::string> ranges = {};      ///< --range
  std::optional<double> time = {};           ///< --trajectory
  TradeoffTable table = {};                  ///< of the shard, not judged
};

/// As JSON, in one line.
[[nodiscard]] std::string to_json(const TradeoffShard& shard);

/// What one process would have measured, not judged. E111, E707, E711, E712 of the files; they are
/// joined on any machine, since what they have of theirs is done.
[[nodiscard]] Result<TradeoffShard> merged_tradeoff(const std::vector<std::string>& paths,
                                                    const Limits& limits);

}  // namespace elgen::cli
