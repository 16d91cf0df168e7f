// M a = B u - bias in either order of elimination.
#include "oracle/solved_dynamics.hpp"

#include <catch2/catch.hpp>

#include "oracle/samples.hpp"

namespace elgen::test {
namespace {

using oracle::Mechanics;

Model coupled() {
  ModelBuilder b;
  b.coordinate("x").coordinate("y");
  b.T("x_d^2 + x_d*y_d + 2*y_d^2").V("x*y");
  return b.model;
}

/// A frame that carries two others: elimination starts with the last velocity.
Model branched(Model model) {
  model.frames.resize(3);
  model.frames[1].parent = model.frames[2].parent = 0;
  return model;
}

}  // namespace

TEST_CASE("the mass matrix is symmetric and the solution solves") {
  const Model model = coupled();
  const State state = random_state(model, 4);
  Mechanics at(model, state);
  const auto mass = oracle::mass_matrix_values(at);
  CHECK(mass == std::vector<cln::cl_R>{2, 1, 1, 4});
  const auto solution = oracle::solve_mass(model, mass, {3, 5});
  CHECK(solution.x == std::vector<cln::cl_R>{1, 1});
}

TEST_CASE("pivots follow the order of elimination, the solution does not") {
  const Model model = coupled();
  const Model tree = branched(model);
  REQUIRE_FALSE(eliminates_last_first(model));
  REQUIRE(eliminates_last_first(tree));
  const std::vector<cln::cl_R> mass{2, 1, 1, 4};
  const auto forwards = oracle::solve_mass(model, mass, {3, 5});
  const auto backwards = oracle::solve_mass(tree, mass, {3, 5});
  CHECK(forwards.x == backwards.x);
  CHECK(forwards.relative_pivots == std::vector<cln::cl_R>{1, cln::cl_RA(7) / 8});
  CHECK(backwards.relative_pivots == std::vector<cln::cl_R>{cln::cl_RA(7) / 8, 1});
}

TEST_CASE("the acceleration satisfies the equation of motion") {
  const Model model = coupled();
  const State state = random_state(model, 6);
  Mechanics at(model, state);
  const auto a = oracle::solved_dynamics(at, oracle::mass_matrix_values(at)).x;
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(agree(at.inverse_dynamics(at.unit(i), a), 0, 80, 1));
  }
}

}  // namespace elgen::test
