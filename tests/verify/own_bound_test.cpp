// Bounds along a program: regimes, and errors measured in them.
#include "verify/bounds/own_bound.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "verify/systems.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// x^2 / (x - y), then its square root.
const char* text =
    "coordinates x y\nfunction bias\n  0 = coordinate x\n  1 = coordinate y\n"
    "  2 = multiply 0 0\n  3 = subtract 0 1\n  4 = divide 2 3\n  5 = square_root 4\n"
    "  result 1 1 = 5\n";

template <class Scalar>
BoundedRun run_at(double x, double y) {
  const Program program = program_of(text);
  State state;
  state.q = {exact_value(x), exact_value(y)};
  return bounded_run(program, program.functions.front(), state, rounding<Scalar>());
}

Bound unit() { return leaf_bound(Real(1), true); }

}  // namespace

TEST_CASE("each regime is told") {
  CHECK(run_at<double>(3, 2).regime == Regime::regular);
  CHECK(run_at<double>(2, 2).regime == Regime::undefined);
  CHECK(run_at<double>(2, 3).regime == Regime::undefined);
  CHECK(run_at<double>(1e160, 1).regime == Regime::overflow);
  CHECK(run_at<float>(1e30, 1).regime == Regime::overflow);
  CHECK(run_at<double>(1e30, 1).regime == Regime::regular);
  const double next = std::nextafter(3.0, 4.0);
  CHECK(run_at<double>(next, 3).regime == Regime::ill_conditioned);
}

TEST_CASE("what leaves every exponent is an overflow too") {
  const Program program = program_of(
      "coordinates x\nfunction bias\n  0 = coordinate x\n  1 = exp 0\n  result 1 1 = 1\n");
  State state;
  state.q = {exact_value(1e300)};
  CHECK(bounded_run(program, program.functions.front(), state, rounding<double>()).regime ==
        Regime::overflow);
}

TEST_CASE("entries are exact to 64 digits, and the largest intermediate is known") {
  const BoundedRun run = run_at<double>(3, 2);
  CHECK(ScalarTraits<double>::from_real(run.entries.at(0).value.value()) == 3);
  CHECK(ScalarTraits<double>::from_real(run.largest.value()) == 9);
}

TEST_CASE("errors are measured in u B, less what underflow may cost") {
  const double next = std::nextafter(1.0, 2.0);
  CHECK(error_in_bounds(1.0, unit(), 5, rounding<double>()) == 0);
  CHECK(error_in_bounds(next, unit(), 5, rounding<double>()) == Approx(2));
  CHECK(error_in_bounds(std::nextafter(1.0F, 2.0F), unit(), 5, rounding<float>()) == Approx(2));
  CHECK(error_in_bounds(5e-324, leaf_bound(Real(), true), 1, rounding<double>()) == 0);
}

TEST_CASE("what underflows on the way is judged by the own bound") {
  // x^2/(x - y) of 1e-200: x^2 is lost whole, and the division makes it 1e-200 again.
  const Bound lost = run_at<double>(1e-200, 0).entries.at(0);
  CHECK(lost.underflows);
  CHECK(error_in_bounds(0.0, lost, 5, rounding<double>()) <= 8);
  CHECK(&judging_bound(lost, unit()) == &lost);
  const Bound kept = run_at<double>(1e-100, 0).entries.at(0);
  const Bound closed = unit();
  CHECK_FALSE(kept.underflows);
  CHECK(&judging_bound(kept, closed) == &closed);
}

TEST_CASE("no number, and a difference where the bound is 0, are infinitely wrong") {
  CHECK(std::isinf(error_in_bounds(std::nan(""), unit(), 1, rounding<double>())));
  CHECK(std::isinf(error_in_bounds(HUGE_VAL, unit(), 1, rounding<double>())));
  CHECK(std::isinf(error_in_bounds(1e-100, leaf_bound(Real(), true), 1, rounding<double>())));
}

TEST_CASE("a long sum may be off by its roundings") {
  const double next = std::nextafter(1.0, 2.0);
  Bound entry = unit();
  entry.roundings = 8;
  CHECK(error_in_bounds(next, entry, 5, rounding<double>()) == Approx(2));
  entry.roundings = 160;
  CHECK(error_in_bounds(next, entry, 5, rounding<double>()) == Approx(0.1));
}
