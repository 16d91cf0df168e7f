// Shard files: what one of several jobs has screened, with all that is needed to join them.
#pragma once

#include <string>
#include <vector>

#include "elgen/pipeline.hpp"
#include "elgen/screening.hpp"

namespace elgen::cli {

struct ShardFile {
  std::string path = {};  ///< of the file itself
  std::string version = {};
  std::string limits = {};  ///< those that decide what is derived: "file_bytes=1048576 ..."
  Inputs inputs = {};
  std::uint64_t samples = 0;
  std::uint64_t seed = 1;
  Shard shard = {};
  Machine machine = {};
  Screening screening = {};
};

/// "2/8"; none where it is no such thing.
[[nodiscard]] std::optional<Shard> parse_shard(const std::string& text);

/// All limits but those on time and memory.
[[nodiscard]] std::string limits_text(const Limits& limits);

/// As JSON, in one line.
[[nodiscard]] std::string to_json(const ShardFile& file);

/// E111, E707: cannot be read; E712: is no such file.
[[nodiscard]] Result<ShardFile> read_shard(const std::string& path, const Limits& limits);

/// E711: what differs between the files, which parts of the states are missing or there twice, and
/// what is different here.
[[nodiscard]] Diagnostics misfits(const std::vector<ShardFile>& files, const Limits& limits,
                                  const Machine& here);

}  // namespace elgen::cli
