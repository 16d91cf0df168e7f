// Sampled states, null spaces of sampled matrices, and the text of numbers in messages.
#include "inspect/samples.hpp"

#include <cln/float.h>

#include <catch2/catch.hpp>

#include "inspect/null_space.hpp"
#include "inspect/readable.hpp"
#include "oracle/samples.hpp"

using namespace elgen;
using namespace elgen::test;
using cln::cl_R;
using cln::cl_RA;

TEST_CASE("samples are reproducible, differ by seed, and lie inside the ranges") {
  ModelBuilder b = cart_pole();
  b.model.coordinates[0].range = Interval{3, 4};
  const InspectedModel subject{b.model, {}};
  CHECK(sample_state(subject, 5).q == sample_state(subject, 5).q);
  CHECK(sample_state(subject, 5).q != sample_state(subject, 6).q);
  for (unsigned seed = 0; seed < 20; ++seed) {
    const State state = sample_state(subject, seed);
    CHECK((state.q[0] > 3 && state.q[0] <= 4));
  }
}

TEST_CASE("a run-time parameter of value 0 is sampled, a fixed parameter is not") {
  ModelBuilder b;
  b.coordinate("x").parameter("m", "0").T("m*x_d^2/2");
  CHECK(sample_state({b.model, {}}, 1).parameters[0] > 0);
  Scene scene;
  scene.specialisation.fixed[0] = {0};
  CHECK(sample_state({b.model, scene}, 1).parameters[0] == 0);
}

TEST_CASE("a mass matrix is sampled at a state where it has a value") {
  ModelBuilder b;
  b.coordinate("x").T("sqrt(x)*x_d^2/2");
  const auto sample = sample_mass_matrix({b.model, {}}, 3);
  REQUIRE(sample);
  CHECK(sample->state.q[0] > 0);
  ModelBuilder nowhere;
  nowhere.coordinate("x").T("sqrt(-1 - x^2)*x_d^2/2");
  CHECK_FALSE(sample_mass_matrix({nowhere.model, {}}, 3));
}

TEST_CASE("a regular matrix has no null space, whatever its scale") {
  CHECK(null_space({1, 2, 3, 4}, {2, 4}).empty());
  const cl_R tiny = cln::expt(cl_R(10), -60);
  const RealVector diagonal{1, 0, 0, tiny};
  CHECK(null_space(diagonal, row_scales(diagonal, 2)).empty());
}

TEST_CASE("each null vector has an entry 1 in a row where the others have 0") {
  const RealVector ones(9, cl_R(1));
  const auto basis = null_space(ones, row_scales(ones, 3));
  REQUIRE(basis.size() == 2);
  CHECK(basis[0] == RealVector{-1, 1, 0});
  CHECK(basis[1] == RealVector{-1, 0, 1});
}

TEST_CASE("a zero row and its column are a free direction") {
  const RealVector matrix{0, 0, 0, 5};
  const auto basis = null_space(matrix, row_scales(matrix, 2));
  REQUIRE(basis.size() == 1);
  CHECK(basis[0] == RealVector{1, 0});
}

TEST_CASE("a row of rounding errors is a zero row") {
  const RealVector matrix{3, 0, 0, cln::expt(cl_R(10), -94)};
  const auto basis = null_space(matrix, row_scales(matrix, 2));
  REQUIRE(basis.size() == 1);
  CHECK(basis[0] == RealVector{0, 1});
}

TEST_CASE("pivots are searched in all rows: a matrix with a zero diagonal can be regular") {
  CHECK(null_space({0, 1, 1, 0}, {1, 1}).empty());
}

TEST_CASE("the residue of a cancellation is zero, relative to the given scale") {
  const cl_R noise = cln::expt(cl_R(10), -70);
  CHECK(null_space({noise}, {1}).size() == 1);
  CHECK(null_space({noise}, {noise}).empty());
}

TEST_CASE("integers and short fractions are printed exactly") {
  CHECK(readable_number(0) == "0");
  CHECK(readable_number(-1) == "-1");
  CHECK(readable_number(cl_RA(1) / cl_RA(3)) == "1/3");
  CHECK(readable_number(cl_RA(-7) / cl_RA(2)) == "-7/2");
  const cln::cl_F third = cln::cl_float(cl_RA(1) / cl_RA(3), cln::float_format(60));
  CHECK(readable_number(third) == "1/3");
}

TEST_CASE("other numbers are printed with five digits") {
  const cln::cl_F two = cln::cl_float(cl_RA(2), cln::float_format(60));
  CHECK(readable_number(cln::sqrt(two)) == "1.4142");
  CHECK(readable_number(cl_RA(1) / cl_RA(1009)) == "0.00099108");
}

TEST_CASE("a rounding error of 60-digit arithmetic is printed as zero") {
  CHECK(readable_number(cln::expt(cl_R(10), -41)) == "0");
  CHECK(readable_number(cln::expt(cl_R(10), -20)) == "1e-20");
}
