#include "inspect/null_space.hpp"

#include <catch2/catch.hpp>

using namespace elgen;
using cln::cl_R;

TEST_CASE("a regular matrix has no null space, whatever its scales") {
  CHECK(null_space({1, 2, 3, 4}, {2, 4}).empty());
  const cl_R tiny = cln::expt(cl_R(10), -60);
  const Vector diagonal{1, 0, 0, tiny};
  CHECK(null_space(diagonal, row_scales(diagonal, 2)).empty());
}

TEST_CASE("null vectors have one entry 1 where all the others have 0") {
  const Vector ones(9, cl_R(1));
  const auto basis = null_space(ones, row_scales(ones, 3));
  REQUIRE(basis.size() == 2);
  CHECK(basis[0] == Vector{-1, 1, 0});
  CHECK(basis[1] == Vector{-1, 0, 1});
}

TEST_CASE("a zero row and its column are a free direction") {
  const Vector matrix{0, 0, 0, 5};
  const auto basis = null_space(matrix, row_scales(matrix, 2));
  REQUIRE(basis.size() == 1);
  CHECK(basis[0] == Vector{1, 0});
}

TEST_CASE("a row of rounding is a zero row") {
  const Vector matrix{3, 0, 0, cln::expt(cl_R(10), -94)};
  const auto basis = null_space(matrix, row_scales(matrix, 2));
  REQUIRE(basis.size() == 1);
  CHECK(basis[0] == Vector{0, 1});
}

TEST_CASE("pivots are sought in all rows: a matrix without a diagonal is regular") {
  CHECK(null_space({0, 1, 1, 0}, {1, 1}).empty());
}

TEST_CASE("what cancellation leaves of zero is zero, against the scale that is given") {
  const cl_R noise = cln::expt(cl_R(10), -70);
  CHECK(null_space({noise}, {1}).size() == 1);
  CHECK(null_space({noise}, {noise}).empty());
}
