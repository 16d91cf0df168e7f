// Hashes stay what they are: files carry them.
#include <catch2/catch.hpp>

#include "emit/text/emission_input.hpp"

using namespace elgen;

TEST_CASE("a hash is that of xxh3, a short one its beginning") {
  CHECK(content_hash("") == "2d06800538d394c2");  // XXH3_64bits of nothing, seed 0
  CHECK(short_hash("") == "2d068005");
  CHECK(content_hash("a") != content_hash("b"));
}
