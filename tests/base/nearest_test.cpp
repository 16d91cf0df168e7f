// Suggestions: near misses only.
#include <catch2/catch.hpp>

#include "elgen/diagnostic.hpp"

using namespace elgen;

TEST_CASE("the nearest candidate is suggested") {
  const std::vector<std::string> names{"theta", "mass_matrix", "m", "omega", "coordinate"};
  CHECK(nearest("thta", names) == "theta");
  CHECK(nearest("theat", names) == "theta");  // a transposition is one slip
  CHECK(nearest("mas_matrx", names) == "mass_matrix");
  CHECK(nearest("mq", names) == "m");
  CHECK(nearest("coordinates", names) == "coordinate");
}

TEST_CASE("nothing is suggested where nothing is near") {
  CHECK(nearest("velocity", {"theta", "m"}).empty());
  CHECK(nearest("q", {"x", "y"}).empty());
  CHECK(nearest("", {"a"}).empty());
  CHECK(nearest(std::string(100, 'a'), {std::string(99, 'a')}).empty());
}

TEST_CASE("of equally near candidates the first is taken") {
  CHECK(nearest("ac", {"ab", "ad"}) == "ab");
}
