// Which six numbers are the inertia of some body.
#include "elgen/inertia.hpp"

#include <catch2/catch.hpp>

namespace elgen::test {

TEST_CASE("a ball, a plate and a rod have inertias") {
  CHECK(is_of_a_body({2, 2, 2, 0, 0, 0}));
  CHECK(is_of_a_body({1, 1, 2, 0, 0, 0}));
  CHECK(is_of_a_body({0, 1, 1, 0, 0, 0}));
  CHECK(is_of_a_body({0, 0, 0, 0, 0, 0}));
}

TEST_CASE("a principal inertia is at most the sum of the other two, in any axes") {
  CHECK_FALSE(is_of_a_body({1, 1, 3, 0, 0, 0}));
  CHECK_FALSE(is_of_a_body({1, 1, 1, 2, 0, 0}));
  CHECK_FALSE(is_of_a_body({-1, 1, 1, 0, 0, 0}));
}

TEST_CASE("what rounding to three digits can do is forgiven") {
  CHECK(is_of_a_body({1, 1, cln::cl_R("2.001"), 0, 0, 0}));
  CHECK_FALSE(is_of_a_body({1, 1, cln::cl_R("2.01"), 0, 0, 0}));
}

}  // namespace elgen::test
