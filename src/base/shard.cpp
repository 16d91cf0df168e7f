// Shards of lists: the first ones are longer by one where the length is no multiple.
#include "elgen/shard.hpp"

#include <algorithm>
#include <charconv>

namespace elgen {

std::optional<Shard> parse_shard(std::string_view text) {
  Shard shard;
  const char* const end = text.data() + text.size();
  const auto number = std::from_chars(text.data(), end, shard.number);
  if (number.ec != std::errc() || number.ptr == end || *number.ptr != '/') return std::nullopt;
  const auto count = std::from_chars(number.ptr + 1, end, shard.count);
  const bool is_read = count.ec == std::errc() && count.ptr == end;
  if (!is_read || shard.number < 1 || shard.number > shard.count) return std::nullopt;
  return shard;
}

Share share_of(const Shard& shard, std::size_t length) {
  const std::size_t each = length / shard.count;
  const std::size_t longer = length % shard.count;
  const std::size_t before = shard.number - 1;
  const std::size_t begin = each * before + std::min(before, longer);
  return {begin, begin + each + (before < longer ? 1 : 0)};
}

}  // namespace elgen
