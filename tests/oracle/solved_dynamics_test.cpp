// Solves symmetric systems and M a = B u - bias, in both orders of elimination.
#include "oracle/solved_dynamics.hpp"

#include <catch2/catch.hpp>

#include "elgen/oracle.hpp"
#include "model/elimination.hpp"
#include "oracle/constraints.hpp"
#include "oracle/real_functions.hpp"
#include "oracle/samples.hpp"

namespace elgen::test {

using namespace elgen::oracle;

namespace {

using Values = std::vector<cln::cl_R>;

Model coupled() {
  ModelBuilder b;
  b.coordinate("x").coordinate("y");
  b.T("x_d^2 + x_d*y_d + 2*y_d^2").V("x*y");
  return b.model;
}

/// The model with two frames on a common parent, so that elimination starts with the last velocity.
Model branched(Model model) {
  model.frames.resize(3);
  model.frames[1].parent = model.frames[2].parent = 0;
  return model;
}

}  // namespace

TEST_CASE("the mass matrix is symmetric and the solution solves the system") {
  const Model model = coupled();
  const State state = random_state(model, 4);
  Mechanics at(model, state);
  const auto mass = at.mass_matrix();
  CHECK(mass == Values{2, 1, 1, 4});
  const auto solution = solve_mass(model, mass, {3, 5});
  CHECK(solution.x == Values{1, 1});
}

TEST_CASE("pivots depend on the order of elimination, the solution does not") {
  const Model model = coupled();
  const Model tree = branched(model);
  REQUIRE_FALSE(eliminates_backward(model));
  REQUIRE(eliminates_backward(tree));
  const Values mass{2, 1, 1, 4};
  const auto forwards = solve_mass(model, mass, {3, 5});
  const auto backwards = solve_mass(tree, mass, {3, 5});
  CHECK(forwards.x == backwards.x);
  CHECK(forwards.relative_pivots == Values{1, cln::cl_RA(7) / 8});
  CHECK(backwards.relative_pivots == Values{cln::cl_RA(7) / 8, 1});
}

TEST_CASE("the acceleration satisfies the equation of motion") {
  const Model model = coupled();
  const State state = random_state(model, 6);
  Mechanics at(model, state);
  const auto a = constrained_motion(at, constrained_system(at)).x;
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(agree(at.inverse_dynamics(at.unit(i), a), 0, 80, 1));
  }
}

TEST_CASE("solutions and relative pivots of rational matrices are exact") {
  const SymmetricSolution s = solve_symmetric({4, 2, 2, 3}, {2, 5});
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

TEST_CASE("a singular matrix has no solution, exactly or within rounding") {
  CHECK_THROWS_AS(solve_symmetric({1, 1, 1, 1}, {1, 1}), OutsideDomain);
  CHECK_THROWS_AS(solve_symmetric({0}, {1}), OutsideDomain);
  const cln::cl_R third = as_float(exact("1/3"));
  CHECK_THROWS_AS(solve_symmetric({third, 1, 1, 3}, {1, 1}), OutsideDomain);
}

TEST_CASE("relative pivots are D_ii / M_ii of L D L^T, and missing for a singular matrix") {
  CHECK(oracle_relative_pivots({5, 0, 0, 7}, 2) == Values{1, 1});
  // D = (4, 5 - 4/4, 6 - 4/4 - 4/4 = 4)
  CHECK(oracle_relative_pivots({4, 2, 2, 2, 5, 3, 2, 3, 6}, 3) ==
        Values{1, exact("4/5"), exact("2/3")});
  CHECK(oracle_relative_pivots({1, 2, 2, 1}, 2) == Values{1, -3});
  CHECK_FALSE(oracle_relative_pivots({1, 1, 1, 1}, 2));
  CHECK_FALSE(oracle_relative_pivots({0, 1, 1, 0}, 2));
}

}  // namespace elgen::test
