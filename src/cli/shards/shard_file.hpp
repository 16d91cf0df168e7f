// Shard files: what one of several jobs has found, with all that is needed to join it with what
// the others have. This is what they have in common, whatever is found: how each begins.
#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "elgen/pipeline.hpp"
#include "elgen/shard.hpp"

namespace elgen::cli {

using Json = nlohmann::ordered_json;

/// The commands that share out their work.
enum class ShardJob : std::uint8_t { verify, tradeoff };

/// What a job was told, or the shape of what it found, which has to be alike in all its shards.
struct ComparedValue {
  std::string name = {};  ///< "number of samples"
  std::string value = {};
  bool is_shown = true;  ///< in messages; some are long
};

struct ShardHead {
  std::string path = {};  ///< of the file itself
  ShardJob job = ShardJob::verify;
  std::string version = {};
  std::string limits = {};  ///< those that decide what is derived: "file_bytes=1048576 ..."
  Inputs inputs = {};
  Shard shard = {};
  Machine machine = {};
  std::vector<ComparedValue> compared = {};  ///< beside the above, by the rest of the file
};

/// Of what is found here and now.
[[nodiscard]] ShardHead head_here(ShardJob job, const Inputs& inputs, const Shard& shard,
                                  const Machine& machine, const Limits& limits);

/// An object, to which the job appends what it found.
[[nodiscard]] Json json_of(const ShardHead& head);

/// Gets the head of a file and all of it, and throws what is wrong with the rest.
using TakeShard = std::function<void(ShardHead head, const Json& json)>;

/// Reads each file. E111, E707: cannot be read; E712: is no such file, or one of another job.
[[nodiscard]] Diagnostics read_shards(const std::vector<std::string>& paths, ShardJob job,
                                      const Limits& limits, const TakeShard& take);

/// E711: what differs between the files, which of them are missing or there twice, and what is
/// different here, on `machine`.
[[nodiscard]] Diagnostics misfits(const std::vector<ShardHead>& heads, const Limits& limits,
                                  const Machine& machine);

}  // namespace elgen::cli
