#include "oracle/linear_solve.hpp"

#include <catch2/catch.hpp>

#include "elgen/oracle.hpp"
#include "oracle/real_functions.hpp"
#include "oracle/samples.hpp"

using namespace elgen::oracle;
using namespace elgen::test;
using Values = std::vector<cln::cl_R>;

TEST_CASE("the solution and the relative pivots are exact on exact matrices") {
  const Solution s = solve_symmetric({4, 2, 2, 3}, {2, 5});
  CHECK(s.x == Values{exact("-1/2"), 2});
  CHECK(s.relative_pivots == Values{1, exact("2/3")});
}

TEST_CASE("a Hilbert matrix of order 6 is solved exactly") {
  const int n = 6;
  Values hilbert;
  Values row_sums;
  for (int i = 0; i < n; ++i) {
    cln::cl_R sum = 0;
    for (int j = 0; j < n; ++j) {
      hilbert.push_back(cln::cl_RA(1) / (i + j + 1));
      sum = sum + hilbert.back();
    }
    row_sums.push_back(sum);
  }
  CHECK(solve_symmetric(hilbert, row_sums).x == Values(n, 1));
}

TEST_CASE("a singular matrix has no solution, exactly or up to rounding") {
  CHECK_THROWS_AS(solve_symmetric({1, 1, 1, 1}, {1, 1}), OutsideDomain);
  CHECK_THROWS_AS(solve_symmetric({0}, {1}), OutsideDomain);
  const cln::cl_R third = as_float(exact("1/3"));
  CHECK_THROWS_AS(solve_symmetric({third, 1, 1, 3}, {1, 1}), OutsideDomain);
}

TEST_CASE("pivots are what elimination leaves of the diagonal, or none of a singular matrix") {
  using elgen::oracle_relative_pivots;
  CHECK(oracle_relative_pivots({5, 0, 0, 7}, 2) == Values{1, 1});
  // D = (4, 5 - 4/4, 6 - 4/4 - 4/4 = 4)
  CHECK(oracle_relative_pivots({4, 2, 2, 2, 5, 3, 2, 3, 6}, 3) ==
        Values{1, exact("4/5"), exact("2/3")});
  CHECK(oracle_relative_pivots({1, 2, 2, 1}, 2) == Values{1, -3});
  CHECK_FALSE(oracle_relative_pivots({1, 1, 1, 1}, 2));
  CHECK_FALSE(oracle_relative_pivots({0, 1, 1, 0}, 2));
}
