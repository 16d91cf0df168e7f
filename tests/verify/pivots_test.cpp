// Pivots of small matrices worked out by hand.
#include "verify/bounds/pivots.hpp"

#include <catch2/catch.hpp>

using namespace elgen;

namespace {

std::vector<Real> matrix(const std::vector<int>& entries) {
  std::vector<Real> result;
  for (const int entry : entries) result.emplace_back(cln::cl_R(entry));
  return result;
}

std::vector<double> pivots_of(const std::vector<int>& entries, std::size_t n) {
  std::vector<double> result;
  const auto pivots = relative_pivots(matrix(entries), n);
  REQUIRE(pivots);
  for (const Real& pivot : *pivots) {
    result.push_back(ScalarTraits<double>::from_real(pivot.value()));
  }
  return result;
}

}  // namespace

TEST_CASE("a diagonal matrix is decoupled") {
  CHECK(pivots_of({5, 0, 0, 7}, 2) == std::vector<double>{1, 1});
}

TEST_CASE("pivots are what elimination leaves of the diagonal") {
  // D = (4, 5 - 4/4, 6 - 4/4 - 4/4 = 4)
  CHECK(pivots_of({4, 2, 2, 2, 5, 3, 2, 3, 6}, 3) == std::vector<double>{1, 4.0 / 5, 4.0 / 6});
  CHECK(pivots_of({1, 2, 2, 1}, 2) == std::vector<double>{1, -3});
}

TEST_CASE("a singular or undefined matrix has none") {
  CHECK_FALSE(relative_pivots(matrix({1, 1, 1, 1}), 2));
  CHECK_FALSE(relative_pivots(matrix({0, 1, 1, 0}), 2));
  CHECK_FALSE(relative_pivots({Real::undefined()}, 1));
  CHECK_FALSE(relative_pivots({}, 1));
}
