// Bounds along a program: regimes, and errors measured in them. Solutions are judged by the
// condition of M, and of the whole under constraints, not by the code that solves.
#include "verify/bounds/solution_bound.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "elgen/certificate.hpp"
#include "verify/bounds/accuracy.hpp"
#include "verify/bounds/own_bound.hpp"
#include "verify/bounds/visit.hpp"
#include "verify/systems.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// M = [1 c; c 1] and bias = (b, 0), all parameters, solved as `body` says.
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

// 4 -b  5 L = c/1  6 D2 = 1 - c L  7 -L r1 = c b  8 a2  9 L a2  10 a1  11 d2
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

/// The same pair, driven by b and d, with x held at 0: M is eliminated first, then A M^-1 A^T.
System held_pair(const std::optional<std::pair<std::string, std::string>>& gains = {}) {
  const std::string leaves =
      "  0 = parameter one\n  1 = parameter c\n  2 = parameter b\n  3 = parameter d\n"
      "  4 = constant 0\n  5 = constant 1\n";
  // 6 r1  7 r2  8 L = c/1  10 D2  12 z2 = r2 - L r1  13 L/D2  16 S  19 w z2 - r1  20 lambda
  const std::string body =
      "  6 = negate 2\n  7 = negate 3\n  8 = divide 1 0\n  9 = multiply 8 1\n"
      "  10 = subtract 0 9\n  11 = multiply 8 6\n  12 = subtract 7 11\n  13 = divide 8 10\n"
      "  14 = multiply 8 13\n  15 = divide 5 0\n  16 = add 15 14\n  17 = multiply 13 12\n"
      "  18 = divide 6 0\n  19 = subtract 17 18\n  20 = divide 19 16\n"
      // 21 z1 + W1 lambda  23 z2 + W2 lambda  24 a2  27 a1  28 d2
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

/// Of one field of forward_dynamics.
std::vector<SolvedColumn> columns_at(const System& system, double c, std::size_t field = 0) {
  const Subject subject = system.subject();
  const SampledState<double> sample = state_with(system, c);
  const State state = exact_state(subject, sample.values);
  SolutionBounds bounds(system.model, &system.program, state, rounding<double>());
  const FieldPlace place = field_places(subject, 2)[field];
  const BoundedRun run = bounded_run(system.program, *place.function, state, rounding<double>());
  return bounds.columns(place, run.entries);
}

Finding finding_at(const System& system, double c, const Program* parts, std::size_t field = 0) {
  const Subject subject = system.subject();
  const SampledState<double> sample = state_with(system, c);
  Visit<double> visit(subject, sample, {Comparison::entries, parts});
  Sampler draw(1);
  return visit.look_at(field_places(subject, 2)[field], draw);
}

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

TEST_CASE("the bound is cond ((n + |B_M|) |x| + |B_b|), in the norm of D^1/2 x") {
  // M = [1 1/2; 1/2 1] has the eigenvalues 1/2 and 3/2; a = (-4, 2), and B_M = M, B_b = (3, 0).
  const auto columns = columns_at(symmetric_pair(solve, results), 0.5);
  REQUIRE(columns.size() == 1);
  CHECK(columns[0].entries == std::vector<std::size_t>{0, 1});
  const double frobenius = std::sqrt(2.5);
  const double expected = 3 * ((2 + frobenius) * std::sqrt(20.0) + 3);
  CHECK(ScalarTraits<double>::from_real(columns[0].bound.value()) == Approx(expected));
  CHECK(ScalarTraits<double>::from_real(columns[0].weights[1].value()) == Approx(1));
}

TEST_CASE("M that takes many roundings is as uncertain as they make it") {
  // M11 = 1 + c - c + c - … of 24 sums: 24 u B where 8 u B cover eight.
  System system = symmetric_pair(solve, results);
  const Real plain = columns_at(system, 0.5).front().bound;
  Function& mass = system.program.functions.front();
  std::uint32_t last = 0;
  for (int i = 0; i < 24; ++i) {
    const Opcode opcode = i % 2 == 0 ? Opcode::add : Opcode::subtract;
    mass.instructions.push_back({.opcode = opcode, .a = last, .b = 1});
    mass.names.emplace_back();
    last = static_cast<std::uint32_t>(mass.instructions.size() - 1);
  }
  mass.fields.front().entries.front() = last;
  // B of M11 is 1 + 24/2 = 13, and three times that for 24 roundings.
  const double frobenius = std::sqrt(39 * 39 + 1 + 0.5);
  const double expected = 3 * ((2 + frobenius) * std::sqrt(20.0) + 3);
  const Real counted = columns_at(system, 0.5).front().bound;
  CHECK(ScalarTraits<double>::from_real(counted.value()) == Approx(expected));
  CHECK(plain.value() < counted.value());
}

TEST_CASE("near a singular M nothing is claimed, and far from it everything is bounded") {
  const System system = symmetric_pair(solve, results);
  CHECK(columns_at(system, 1 - 1e-15).empty());
  CHECK(columns_at(system, 1).empty());
  CHECK_FALSE(columns_at(system, 1 - 1e-12).empty());
  const Finding bounded = finding_at(system, 1 - 1e-12, &system.program);
  CHECK(bounded.regime == Regime::regular);
  REQUIRE(bounded.error);
  CHECK(*bounded.error < promised_bounds);
  const Finding unbounded = finding_at(system, 1 - 1e-15, &system.program);
  CHECK(unbounded.regime == Regime::ill_conditioned);
  CHECK(unbounded.mistake.empty());
}

TEST_CASE("a solution whose own bound says nothing is still judged, and found wrong") {
  // (c + 1e6) - 1e6 for c in the pivot: 4 1e6  6 c  7 -b  8 L  10 D2  13 a2  15 a1
  const std::string body =
      "  4 = constant 1000000\n  5 = add 1 4\n  6 = subtract 5 4\n  7 = negate 2\n"
      "  8 = divide 1 0\n  9 = multiply 8 6\n  10 = subtract 0 9\n  11 = multiply 8 7\n"
      "  12 = negate 11\n  13 = divide 12 10\n  14 = multiply 8 13\n  15 = subtract 7 14\n"
      "  16 = divide 10 0\n";
  const System system = symmetric_pair(
      body, "  result acceleration 2 1 = 15 13\n  result relative_pivots 2 1 = 0 16\n");
  const Finding finding = finding_at(system, 0.3, &system.program);
  REQUIRE(finding.error);
  CHECK(*finding.error > promised_bounds);
  CHECK(finding.imprecision.find("times its error bound") != std::string::npos);
}

TEST_CASE("under constraints it is that of the whole system, times cond M") {
  // K = [1 1/2 1; 1/2 1 0; 1 0 0] has the eigenvalues -0.6617, 0.8210 and 1.8407 with more digits;
  // a = (0, -1.7) and lambda = 2.25.
  const double condition = 3 * 2.781712822094902;
  const double of_solution = (3 + std::sqrt(4.5)) * std::hypot(1.7, 2.25);
  const auto accelerations = columns_at(held_pair(), 0.5);
  const auto multipliers = columns_at(held_pair(), 0.5, 2);
  REQUIRE(accelerations.size() == 1);
  REQUIRE(multipliers.size() == 1);
  const double expected = condition * (of_solution + std::hypot(3.1, 1.7));
  CHECK(ScalarTraits<double>::from_real(accelerations[0].bound.value()) == Approx(expected));
  CHECK(ScalarTraits<double>::from_real(multipliers[0].bound.value()) == Approx(expected));
  CHECK(multipliers[0].entries == std::vector<std::size_t>{0});
  CHECK(ScalarTraits<double>::from_real(multipliers[0].weights.at(0).value()) == Approx(1));
  CHECK(columns_at(held_pair(), 0.5, 1).size() == 3);
  // The side of the constraint is as uncertain as 2 zeta omega r and omega^2 f are.
  const System stabilised = held_pair(std::pair("3", "0.5"));
  const Arguments<double> at = state_with(stabilised, 0.5).values;
  const double side = 3 * std::abs(at.v[0]) + 9 * std::abs(at.q[0]);
  const double more = condition * (of_solution + std::hypot(3.1, 1.7, side));
  const Real found = columns_at(stabilised, 0.5).at(0).bound;
  CHECK(ScalarTraits<double>::from_real(found.value()) == Approx(more));
}

TEST_CASE("where M alone is ill-conditioned, digits are lost that the whole system would keep") {
  const double c = 1 - 1e-9;
  const System system = held_pair();
  const Finding finding = finding_at(system, c, &system.program);
  CHECK(finding.mistake.empty());
  CHECK(finding.in_norm);
  REQUIRE(finding.error);
  CHECK(*finding.error <= promised_bounds);
  const double condition_of_mass = (1 + c) / (1 - c);
  CHECK(*finding.error * condition_of_mass > 1e6 * promised_bounds);
  for (const std::size_t field : {1U, 2U}) {
    const Finding other = finding_at(system, c, &system.program, field);
    CHECK(other.mistake.empty());
    CHECK(other.in_norm);
    REQUIRE(other.error);
    CHECK(*other.error <= promised_bounds);
  }
}

TEST_CASE("without the parts there is no such bound") {
  const System system = symmetric_pair(solve, results);
  const Finding own = finding_at(system, 0.5, nullptr);
  CHECK(own.regime == Regime::regular);
  const Subject subject = system.subject();
  const State state = exact_state(subject, state_with(system, 0.5).values);
  SolutionBounds none(system.model, nullptr, state, rounding<double>());
  CHECK(none.columns(field_places(subject, 2).front(), {}).empty());
}

TEST_CASE("the tolerance names what judged") {
  const System system = symmetric_pair(solve, results);
  const std::vector<SampledState<double>> states{state_with(system, 0.5)};
  const auto tolerance = [&](const Program* parts) {
    AccuracyOptions options;
    options.visit.parts = parts;
    for (const CertificateRow& row : check_accuracy(system.subject(), states, options)) {
      if (row.subject == "forward_dynamics.acceleration (double)") return row.tolerance;
    }
    return std::string();
  };
  CHECK(tolerance(&system.program).find("in the norm of D^1/2 x") != std::string::npos);
  CHECK_FALSE(tolerance(nullptr).empty());
  CHECK(tolerance(nullptr).find("norm") == std::string::npos);
}

TEST_CASE("what solves names its parts") {
  System system = cart_pole_system();
  const auto kinds = [&] {
    std::vector<OutputKind> result;
    for (const OutputRequest& request : needed_parts(system.model, system.scene)) {
      result.push_back(request.kind);
    }
    return result;
  };
  CHECK(kinds() == std::vector<OutputKind>{OutputKind::mass_matrix, OutputKind::bias,
                                           OutputKind::input_matrix});
  system.scene.outputs = {OutputRequest{.kind = OutputKind::linearization}};
  CHECK(kinds().size() == 5);
  system.scene.outputs = {OutputRequest{.kind = OutputKind::inverse_dynamics}};
  CHECK(kinds().empty());
  system = held_pair();
  CHECK(kinds() == std::vector<OutputKind>{
                       OutputKind::mass_matrix, OutputKind::bias, OutputKind::constraint_residual,
                       OutputKind::constraint_jacobian, OutputKind::constraint_bias});
}

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
