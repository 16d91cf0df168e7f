// Shards: what one is, and that all of them have everything once.
#include "elgen/shard.hpp"

#include <catch2/catch.hpp>
#include <cstdint>
#include <limits>

using namespace elgen;

TEST_CASE("a shard is i/N with 1 <= i <= N") {
  CHECK(parse_shard("2/8") == Shard{2, 8});
  CHECK(parse_shard("1/1") == Shard{1, 1});
  for (const char* text : {"", "/", "1", "1/", "/2", "0/2", "3/2", "-1/2", "1/2/3", " 1/2",
                           "1/99999999999999999999"}) {
    INFO(text);
    CHECK_FALSE(parse_shard(text));
  }
}

TEST_CASE("shares of a list have every place once, and differ by one at most") {
  for (std::size_t length = 0; length < 20; ++length) {
    for (std::uint64_t count = 1; count < 25; ++count) {
      std::size_t next = 0;
      for (std::uint64_t number = 1; number <= count; ++number) {
        const Share share = share_of({number, count}, length);
        CHECK(share.begin == next);
        CHECK(share.end - share.begin >= length / count);
        CHECK(share.end - share.begin <= length / count + 1);
        next = share.end;
      }
      CHECK(next == length);
    }
  }
}

TEST_CASE("of more shards than there are things the last ones are empty") {
  constexpr std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
  CHECK(share_of({3, most}, 3) == Share{2, 3});
  CHECK(share_of({most, most}, 3) == Share{3, 3});
}
