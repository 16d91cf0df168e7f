// Hashes must not change, because files contain them.
#include <catch2/catch.hpp>

#include "emit/text/emission_input.hpp"

using namespace elgen;

TEST_CASE("a hash is xxh3, and a short hash is its beginning") {
  CHECK(content_hash("") == "2d06800538d394c2");  // XXH3_64bits of the empty text, seed 0
  CHECK(short_hash("") == "2d068005");
  CHECK(content_hash("a") != content_hash("b"));
}
