// Exact runs of a program: regimes, and errors in units of roundoff. The lost digits of solutions
// are measured in the norm of D^1/2, with constraints too.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "verify/bounds/loss.hpp"
#include "verify/bounds/visit.hpp"
#include "verify/systems.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// M = [1 c; c 1] and bias = (b, 0), with parameters as entries, solved by `body`.
System symmetric_pair(const std::string& body, const std::string& results) {
  const std::string leaves =
      "  0 = parameter one\n  1 = parameter c\n  2 = parameter b\n  3 = constant 0\n";
  ModelBuilder builder;
  builder.coordinate("x", "m").coordinate("y", "m");
  builder.parameter("one", "1").parameter("c", "0.5").parameter("b", "3");
  builder.T("one*x_d^2/2 + c*x_d*y_d + one*y_d^2/2").V("b*x");
  return system_of(builder.model,
                   "parameters one c b\ncoordinates x y\n" +
                       function_text("mass_matrix", leaves, "  result 2 2 = 0 1 1 0\n") +
                       function_text("bias", leaves, "  result 2 1 = 2 3\n") +
                       function_text("forward_dynamics", leaves + body, results));
}

// 4 r1 = -b  5 L = c/1  7 D2 = 1 - c L  9 -L r1 = c b  10 a2  11 L a2  12 a1  13 d2
const std::string solve =
    "  4 = negate 2\n  5 = divide 1 0\n  6 = multiply 5 1\n  7 = subtract 0 6\n"
    "  8 = multiply 5 4\n  9 = negate 8\n  10 = divide 9 7\n  11 = multiply 5 10\n"
    "  12 = subtract 4 11\n  13 = divide 7 0\n";
const std::string results =
    "  result acceleration 2 1 = 12 10\n  result relative_pivots 2 1 = 0 13\n";

SampledState<double> state_with(const System& system, double c) {
  auto states = sample_states<double>(system.subject(), {1, 3, false});
  states.front().values.parameters[1] = c;
  return states.front();
}

/// The same pair, driven by b and d, with the constraint x = 0. M is eliminated first, then
/// S = A M^-1 A^T.
System held_pair(const std::optional<std::pair<std::string, std::string>>& gains = {}) {
  const std::string leaves =
      "  0 = parameter one\n  1 = parameter c\n  2 = parameter b\n  3 = parameter d\n"
      "  4 = constant 0\n  5 = constant 1\n";
  // 6 r1  7 r2  8 L = c/1  10 D2  12 z2 = r2 - L r1  13 L/D2  16 S  19 L z2/D2 - r1  20 lambda
  const std::string body =
      "  6 = negate 2\n  7 = negate 3\n  8 = divide 1 0\n  9 = multiply 8 1\n"
      "  10 = subtract 0 9\n  11 = multiply 8 6\n  12 = subtract 7 11\n  13 = divide 8 10\n"
      "  14 = multiply 8 13\n  15 = divide 5 0\n  16 = add 15 14\n  17 = multiply 13 12\n"
      "  18 = divide 6 0\n  19 = subtract 17 18\n  20 = divide 19 16\n"
      // 21 r1 + lambda  23 z2 - L lambda  24 a2  27 a1  28 d2 = D2/1
      "  21 = add 6 20\n  22 = multiply 8 20\n  23 = subtract 12 22\n  24 = divide 23 10\n"
      "  25 = divide 21 0\n  26 = multiply 8 24\n  27 = subtract 25 26\n  28 = divide 10 0\n";
  ModelBuilder builder;
  builder.coordinate("x", "m").coordinate("y", "m");
  builder.parameter("one", "1").parameter("c", "0.5").parameter("b", "3.1").parameter("d", "1.7");
  builder.T("one*x_d^2/2 + c*x_d*y_d + one*y_d^2/2").V("b*x + d*y");
  Constraint held;
  held.name = held.identifier = "held";
  held.value = builder.expression("x");
  if (gains) held.omega = builder.expression(gains->first);
  if (gains) held.zeta = builder.expression(gains->second);
  builder.model.constraints.push_back(held);
  return system_of(
      builder.model,
      "parameters one c b d\ncoordinates x y\n" +
          function_text("mass_matrix", leaves, "  result 2 2 = 0 1 1 0\n") +
          function_text("bias", leaves, "  result 2 1 = 2 3\n") +
          function_text("forward_dynamics", leaves + body,
                        "  result acceleration 2 1 = 27 24\n"
                        "  result relative_pivots 3 1 = 5 28 5\n  result multipliers 1 1 = 20\n") +
          function_text("constraint_residual", "  0 = coordinate x\n  1 = velocity x\n",
                        "  result position 1 1 = 0\n  result rate 1 1 = 1\n") +
          function_text("constraint_jacobian", leaves, "  result 1 2 = 5 4\n") +
          function_text("constraint_bias", leaves, "  result 1 1 = 4\n"));
}

/// The columns of one field of forward_dynamics.
std::vector<SolvedColumn> columns_at(const System& system, double c, std::size_t field = 0) {
  const SystemUnderTest subject = system.subject();
  OracleCache oracle(subject, exact_state(subject, state_with(system, c).values));
  return solved_columns(compared_fields(subject, 2)[field], oracle);
}

Finding finding_at(const System& system, double c, std::size_t field = 0) {
  const SystemUnderTest subject = system.subject();
  const SampledState<double> sample = state_with(system, c);
  StateCheck<double> visit(subject, sample, {ComparisonMode::entries, LossStates::everywhere});
  Sampler draw(1);
  return visit.check_field(compared_fields(subject, 2)[field], draw);
}

/// A program that computes sqrt(x^2/(x - y)).
const char* text =
    "coordinates x y\nfunction bias\n  0 = coordinate x\n  1 = coordinate y\n"
    "  2 = multiply 0 0\n  3 = subtract 0 1\n  4 = divide 2 3\n  5 = square_root 4\n"
    "  result 1 1 = 5\n";

template <class Scalar>
ExactRun run_at(double x, double y) {
  const Program program = read_program(text);
  State state;
  state.q = {exact_value(x), exact_value(y)};
  return run_exactly(program, program.functions.front(), state, rounding_constants<Scalar>());
}

}  // namespace

TEST_CASE("accelerations are one column, weighted by the square roots of M's diagonal") {
  const auto columns = columns_at(symmetric_pair(solve, results), 0.5);
  REQUIRE(columns.size() == 1);
  CHECK(columns[0].entries == std::vector<std::size_t>{0, 1});
  CHECK(to_double(columns[0].weights[1].value()) == Approx(1));
  CHECK(columns_at(symmetric_pair(solve, results), 0.5, 1).empty());
}

TEST_CASE("a small acceleration beside a large one has no digits of its own") {
  // a = (-b, c b)/(1 - c^2). At c = 2^-60 all digits of a_2 are lost in (1 + c) - 1.
  const std::string body =
      "  4 = add 0 1\n  5 = subtract 4 0\n  6 = negate 2\n  7 = multiply 5 2\n"
      "  8 = multiply 1 1\n  9 = subtract 0 8\n  10 = divide 6 9\n  11 = divide 7 9\n"
      "  12 = divide 9 0\n";
  const System system = symmetric_pair(
      body, "  result acceleration 2 1 = 10 11\n  result relative_pivots 2 1 = 0 12\n");
  const Finding finding = finding_at(system, 0x1p-60);
  CHECK(finding.mistake.empty());
  REQUIRE(finding.loss);
  CHECK(finding.loss->relative_to_entry.loss < 2);
}

TEST_CASE("near a singular M a solution is accepted, and K excuses its lost digits") {
  const System system = symmetric_pair(solve, results);
  for (const double c : {0.5, 1 - 1e-9, 1 - 1e-12}) {
    INFO(c);
    const Finding finding = finding_at(system, c);
    CHECK(finding.mistake.empty());
    REQUIRE(finding.loss);
    CHECK(finding.loss->relative_to_entry.loss < 64);
  }
  CHECK(finding_at(system, 1 - 1e-15).regime == Regime::ill_conditioned);
}

TEST_CASE("an elimination that loses digits is reported") {
  // The pivot D2 uses (c + 1e6) - 1e6 for c: 4 1e6  6 c  7 -b  8 L  10 D2  13 a2  15 a1
  const std::string body =
      "  4 = constant 1000000\n  5 = add 1 4\n  6 = subtract 5 4\n  7 = negate 2\n"
      "  8 = divide 1 0\n  9 = multiply 8 6\n  10 = subtract 0 9\n  11 = multiply 8 7\n"
      "  12 = negate 11\n  13 = divide 12 10\n  14 = multiply 8 13\n  15 = subtract 7 14\n"
      "  16 = divide 10 0\n";
  const System system = symmetric_pair(
      body, "  result acceleration 2 1 = 15 13\n  result relative_pivots 2 1 = 0 16\n");
  const Finding finding = finding_at(system, 0.3);
  CHECK(finding.mistake.empty());
  REQUIRE(finding.loss);
  CHECK(finding.loss->relative_to_entry.loss > 1e3);
}

TEST_CASE("multipliers are weighted by the rows of A D^-1/2") {
  const auto multipliers = columns_at(held_pair(), 0.5, 2);
  REQUIRE(multipliers.size() == 1);
  CHECK(multipliers[0].entries == std::vector<std::size_t>{0});
  CHECK(to_double(multipliers[0].weights.at(0).value()) == Approx(1));
  CHECK(columns_at(held_pair(), 0.5).size() == 1);
}

TEST_CASE(
    "if only M is ill-conditioned, digits are lost that a solution of the whole system keeps") {
  const System system = held_pair();
  const Finding finding = finding_at(system, 1 - 1e-9);
  CHECK(finding.mistake.empty());
  REQUIRE(finding.loss);
  CHECK(finding.loss->relative_to_entry.loss > 1e3);
}

TEST_CASE("each regime is recognised") {
  CHECK(run_at<double>(3, 2).regime == Regime::regular);
  CHECK(run_at<double>(2, 2).regime == Regime::undefined);
  CHECK(run_at<double>(2, 3).regime == Regime::undefined);
  CHECK(run_at<double>(1e160, 1).regime == Regime::overflow);
  CHECK(run_at<float>(1e30, 1).regime == Regime::overflow);
  CHECK(run_at<double>(1e30, 1).regime == Regime::regular);
  // x - y is exact. sqrt(x) - y keeps hardly any digit.
  CHECK(run_at<double>(std::nextafter(3.0, 4.0), 3).regime == Regime::regular);
  const Program program = read_program(
      "coordinates x y\nfunction bias\n  0 = coordinate x\n  1 = coordinate y\n"
      "  2 = square_root 0\n  3 = subtract 2 1\n  4 = divide 0 3\n  result 1 1 = 4\n");
  State state;
  state.q = {exact_value(2), exact_value(std::sqrt(2.0))};
  CHECK(
      run_exactly(program, program.functions.front(), state, rounding_constants<double>()).regime ==
      Regime::ill_conditioned);
}

TEST_CASE("a value beyond every exponent is an overflow too") {
  const Program program = read_program(
      "coordinates x\nfunction bias\n  0 = coordinate x\n  1 = exp 0\n  result 1 1 = 1\n");
  State state;
  state.q = {exact_value(1e300)};
  CHECK(
      run_exactly(program, program.functions.front(), state, rounding_constants<double>()).regime ==
      Regime::overflow);
}

TEST_CASE("entries are exact to 64 digits") {
  CHECK(to_double(run_at<double>(3, 2).entries.at(0).value.value()) == 3);
}

TEST_CASE("errors are in units of roundoff, minus the effect of underflow") {
  const auto in_double = [](double x, const Real& exact, std::size_t operations) {
    return error_in_roundoffs(excess_error(x, exact, operations, rounding_constants<double>()),
                              exact, rounding_constants<double>());
  };
  const double next = std::nextafter(1.0, 2.0);
  CHECK(in_double(1.0, Real(1), 5) == 0);
  CHECK(in_double(next, Real(1), 5) == Approx(2));
  CHECK(in_double(5e-324, Real(), 1) == 0);
  CHECK(std::isinf(in_double(std::nan(""), Real(1), 1)));
  CHECK(std::isinf(in_double(HUGE_VAL, Real(1), 1)));
  CHECK(std::isinf(in_double(1e-100, Real(), 1)));
  CHECK(error_in_roundoffs(
            excess_error(std::nextafter(1.0F, 2.0F), Real(1), 5, rounding_constants<float>()),
            Real(1), rounding_constants<float>()) == Approx(2));
}
