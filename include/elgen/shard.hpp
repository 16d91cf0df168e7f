// Shard: the part of a long job that one of several processes, perhaps on other machines, does.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace elgen {

/// One of `count` parts, `number` of 1 ... count.
struct Shard {
  std::uint64_t number = 1;
  std::uint64_t count = 1;
  friend bool operator==(const Shard&, const Shard&) = default;
};

/// "2/8"; none where it is no such thing.
[[nodiscard]] std::optional<Shard> parse_shard(std::string_view text);

/// Places in a list, from `begin` to before `end`.
struct Share {
  std::size_t begin = 0;
  std::size_t end = 0;
  friend bool operator==(const Share&, const Share&) = default;
};

/// The shard's part of a list of `length`, cut where it stands: as long as any other or one longer.
[[nodiscard]] Share share_of(const Shard& shard, std::size_t length);

}  // namespace elgen
