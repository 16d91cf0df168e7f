// Loss: a bad formula loses digits that a good formula keeps. An ill-conditioned value excuses the
// loss of every formula. Every output has a row with its largest loss, the entry and the state.
#include "verify/bounds/loss.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "verify/bounds/accuracy.hpp"
#include "verify/states/near_zeros.hpp"
#include "verify/systems.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

// V = m g l (1 - cos th) of a pendulum, in a form that loses digits of V and a form without loss.
const std::string form_head =
    "parameters m l g\ncoordinates th\nfunction potential_energy\n  0 = parameter m\n"
    "  1 = parameter l\n  2 = parameter g\n  3 = coordinate th\n  4 = multiply 0 1\n"
    "  5 = multiply 4 2\n";
const std::string cosine = form_head +
                           "  6 = cos 3\n  7 = constant 1\n  8 = subtract 7 6\n  9 = multiply 5 8\n"
                           "  result 1 1 = 9\n";
/// 2 sin(th/2)^2
const std::string half_angle =
    form_head +
    "  6 = constant 1/2\n  7 = multiply 6 3\n  8 = sin 7\n  9 = multiply 8 8\n"
    "  10 = add 9 9\n  11 = multiply 5 10\n  result 1 1 = 11\n";
/// m l g (pi/2 - atan(th)), which atan2(1, th) computes with all digits.
const std::string arctangent = form_head +
                               "  6 = atan 3\n  7 = constant 1/2*pi\n  8 = subtract 7 6\n"
                               "  9 = multiply 5 8\n  result 1 1 = 9\n";
/// m l g tanh(th), as in friction.
const std::string friction = form_head + "  6 = tanh 3\n  7 = multiply 5 6\n  result 1 1 = 7\n";

/// A system with one output, the potential energy computed by `text`.
System written_as(const std::string& text) {
  ModelBuilder builder;
  builder.coordinate("th", "rad").parameter("m", "2").parameter("l", "0.75").parameter("g", "9.81");
  builder.point("bob", {"l*sin(th)", "l - l*cos(th)"}, "m").gravity({"0", "-g"});
  return system_of(builder.model, text);
}

State at(double angle) {
  State state;
  state.parameters = {1, 1, cln::cl_RA(981) / 100};
  state.q = {exact_value(angle)};
  return state;
}

/// The loss of the first field, if the entries differ by `errors` from their exact values.
Loss loss_of(const System& system, const State& state, const std::vector<Real>& errors) {
  const SystemUnderTest subject = system.subject();
  const ComparedField place = field_places(subject).front();
  const ExactRun run =
      run_exactly(system.program, *place.function, state, rounding_constants<double>());
  OracleCache oracle(subject, state);
  LossMeter losses(subject, oracle, rounding_constants<double>());
  std::vector<Real> exact = values_of(run.entries);
  return losses.field_loss(place, run, errors, exact);
}

/// The loss of a single entry that differs from its exact value by `error` times u.
Loss loss_of(const System& system, const State& state, double error) {
  return loss_of(system, state, {Real(exact_value(error)) * rounding_constants<double>().roundoff});
}

/// True if doubles in compiled code lose no more than the tolerated number of digits.
bool keeps(const std::string& text, double angle) {
  const System system = written_as(text);
  const Function& function = system.program.functions.front();
  const State state = at(angle);
  const double x = evaluate(system.program, function, arguments_at<double>(state)).front();
  const ExactRun run = run_exactly(system.program, function, state, rounding_constants<double>());
  const Real error = abs(Real(exact_value(x)) - run.entries[0].value);
  return loss_of(system, state, {error}).relative_to_entry.loss <= tolerated_loss;
}

template <class Scalar = double>
CertificateRow row_of(const System& system, LossStates losing) {
  const SystemUnderTest subject = system.subject();
  const auto samples = sample_states<Scalar>(subject, {16, 1, true});
  for (const CertificateRow& row :
       check_accuracy(subject, samples, {{ComparisonMode::entries, losing}, {}})) {
    if (row.check == "digits lost") return row;
  }
  FAIL("no row");
  return {};
}

/// The row of V = (x - 1)^2 + (y - 3/10)^2 as `body` computes it, near the zeros of V.
CertificateRow row_of_anchor(const std::string& body,
                             LossStates losing = LossStates::inside_ranges) {
  ModelBuilder builder;
  builder.coordinate("x").coordinate("y").T("(x_d^2 + y_d^2)/2").V("(x - 1)^2 + (y - 0.3)^2");
  for (Coordinate& coordinate : builder.model.coordinates) coordinate.range = Interval{-3, 4};
  const System system = system_of(
      builder.model,
      "coordinates x y\nfunction potential_energy\n  0 = coordinate x\n  1 = coordinate y\n" +
          body);
  const auto states = states_near_zeros<double>(system.subject(), {16, 1, true});
  for (const CertificateRow& row :
       check_accuracy(system.subject(), states, {{ComparisonMode::entries, losing}, {}})) {
    if (row.check == "digits lost") return row;
  }
  FAIL("no row");
  return {};
}

/// The cosine form, with th in [0, `range`].
System near_zero(const char* range) {
  System system = written_as(cosine);
  system.model.coordinates[0].range = Interval{0, exact(range)};
  return system;
}

}  // namespace

TEST_CASE("1 - cos(th) keeps its digits at ordinary angles and loses all at tiny ones") {
  CHECK(keeps(cosine, 1));
  CHECK_FALSE(keeps(cosine, 1e-3));
  CHECK_FALSE(keeps(cosine, 1e-8));
  CHECK(keeps(half_angle, 1));
  CHECK(keeps(half_angle, 1e-8));
}

TEST_CASE("an angle of 1e15 rad excuses any loss") { CHECK(keeps(cosine, 1e15)); }

TEST_CASE("an angle with an uncertainty above 1/1000 rad gives no figure") {
  const System system = written_as(cosine);
  const SystemUnderTest subject = system.subject();
  const State far = at(1e14);
  const State near = at(1e10);
  OracleCache far_oracle(subject, far);
  OracleCache near_oracle(subject, near);
  CHECK_FALSE(LossMeter(subject, far_oracle, rounding_constants<double>()).has_accurate_angles());
  CHECK(LossMeter(subject, near_oracle, rounding_constants<double>()).has_accurate_angles());
  CHECK_FALSE(LossMeter(subject, near_oracle, rounding_constants<float>()).has_accurate_angles());
}

TEST_CASE("losses are relative to the effect of the inputs' rounding") {
  const System system = written_as(cosine);
  // R = |x| + K with x = 9.81 (1 - cos 1). K is x for each of m, l and g, and 9.81 sin 1 for th.
  const double x = 9.81 * (1 - std::cos(1.0));
  const double reference = 4 * x + 9.81 * std::sin(1.0);
  CHECK(loss_of(system, at(1), 100 * x).relative_to_entry.loss == Approx(100 * x / reference));
  // Up to an error of 2 u |x| the loss is computed with R = |x|, without K.
  CHECK(loss_of(system, at(1), 2 * x).relative_to_entry.loss == Approx(2));
  CHECK(loss_of(system, at(1), 100 * x).relative_to_field.loss == Approx(100));
}

TEST_CASE("literals and pi excuse no cancellation") {
  CHECK(keeps(arctangent, 1));
  CHECK_FALSE(keeps(arctangent, 1e8));
  const System system = written_as(arctangent);
  const double x = 9.81 * 1e-8;
  // R = 5 x: |x|, and x for each of m, l, g and th.
  CHECK(loss_of(system, at(1e8), 100 * x).relative_to_entry.loss == Approx(100 / 5.0));
}

TEST_CASE("a fixed parameter excuses as much as an argument, a literal in the text does not") {
  const std::string text =
      "coordinates th\nfunction potential_energy\n  0 = coordinate th\n"
      "  1 = cos 0\n  2 = constant 1\n  3 = subtract 2 1\n"
      "  4 = constant 3/10\n  5 = multiply 4 3\n  result 1 1 = 5\n";
  System system = written_as(text);
  const double x = 0.3 * (1 - std::cos(1.0));
  const double of_angle = 0.3 * std::sin(1.0);
  const auto reference = [&] {
    return 100 * x / loss_of(system, at(1), 100 * x).relative_to_entry.loss;
  };
  CHECK(reference() == Approx(x + of_angle));
  system.scene.specialisation.fixed[1] = {exact("3/10")};
  CHECK(reference() == Approx(2 * x + of_angle));
  system.model.expressions.push_back({.number = cln::cl_RA(3) / 10});
  CHECK(reference() == Approx(x + of_angle));
}

TEST_CASE("if R is exactly 0, the entry has no figure and is counted") {
  const System system = written_as(
      "parameters m l\ncoordinates x y\nfunction gravity\n  0 = parameter m\n  1 = parameter l\n"
      "  2 = add 0 1\n  3 = subtract 2 0\n  4 = subtract 3 1\n  result 2 1 = 2 4\n");
  State state = at(1);
  state.parameters = {1, 2};
  const Loss loss =
      loss_of(system, state, {Real(), Real(300) * rounding_constants<double>().roundoff});
  CHECK(loss.relative_to_entry.loss == 0);
  CHECK(loss.entries_without_reference == 1);
  CHECK(loss.relative_to_field.loss == Approx(100));
  CHECK(loss.relative_to_field.entry == 1);
}

TEST_CASE("the loss is at most the digits of a scalar") {
  // Computes m by adding and subtracting numbers of about 1e20, which cancel exactly. The rounded
  // numbers do not cancel.
  const auto lossy = [](const std::string& x, const std::string& y,
                        const std::pair<std::string, std::string>& sum) {
    ModelBuilder builder;
    builder.coordinate("x").parameter("m", "0.1").T("x_d^2/2").V("m");
    const std::string scale = "00000000000000000000";
    return system_of(builder.model,
                     "parameters m\ncoordinates x\nfunction potential_energy\n"
                     "  0 = parameter m\n  1 = constant 1" +
                         scale + x + "\n  2 = constant 1" + scale + y + "\n  3 = constant " +
                         sum.first + scale + sum.second +
                         "\n  4 = add 0 1\n  5 = add 4 2\n  6 = subtract 5 3\n"
                         "  result 1 1 = 6\n");
  };
  const CertificateRow in_double =
      row_of(lossy("/3", "/13", {"16", "/39"}), LossStates::everywhere);
  CHECK(in_double.loss.value_or(0) == Approx(1e16));
  CHECK(mentions(in_double.worst_value,
                 "16.0 digits of potential_energy (of the largest entry 16.0)"));
  CHECK(mentions(in_double.tolerance,
                 "noted if the largest entry of a field loses more than 8.0 of the 16 digits"));
  const CertificateRow in_float =
      row_of<float>(lossy("/7", "/11", {"18", "/77"}), LossStates::everywhere);
  CHECK(in_float.loss.value_or(0) == Approx(1e7));
  CHECK(mentions(in_float.worst_value, "7.0 digits of potential_energy"));
}

TEST_CASE("if K has no value, no loss is reported") {
  // For large th tanh is 1 in all digits. Exponentials beyond 2^29 have no value in 60 digits.
  const System system = written_as(friction);
  CHECK(loss_of(system, at(1e8), 1e6).relative_to_entry.loss > 1e4);
  CHECK(loss_of(system, at(1e9), 1e6).relative_to_entry.loss > 1e4);
  const std::string decay = form_head + "  6 = exp 3\n  7 = multiply 5 6\n  result 1 1 = 7\n";
  CHECK(loss_of(written_as(decay), at(-1e9), 1e6).relative_to_entry.loss == 0);
}

TEST_CASE("1 - cos(th) loses little inside the ranges and everything at the extremes") {
  const System system = written_as(cosine);
  const CertificateRow inside = row_of(system, LossStates::inside_ranges);
  CHECK(inside.verdict == Verdict::holds);
  CHECK(inside.output == "potential_energy");
  CHECK(inside.subject == "potential_energy (double)");
  CHECK(inside.loss.value_or(1e9) < 64);
  const CertificateRow beyond = row_of(system, LossStates::everywhere);
  CHECK(beyond.verdict == Verdict::noted);
  CHECK(beyond.loss.value_or(0) > 1e8);
}

TEST_CASE("a loss of half of the digits inside the ranges is noted, with a state in 17 digits") {
  const CertificateRow row = row_of(near_zero("1e-6"), LossStates::inside_ranges);
  CHECK(row.verdict == Verdict::noted);
  CHECK(mentions(row.worst_value, "digits of potential_energy (of the largest entry "));
  CHECK(mentions(row.worst_state, "q = ("));
  CHECK(row.worst_state.size() > 60);
  CHECK(row_of(near_zero("1e-1"), LossStates::inside_ranges).verdict == Verdict::holds);
}

TEST_CASE("an expanded sum of squares is noted near its zero, an unexpanded one is not") {
  // 1.09 - x (2 - x) - y (0.6 - y)
  const CertificateRow expanded = row_of_anchor(
      "  2 = constant 109/100\n  3 = constant 2\n  4 = subtract 3 0\n  5 = multiply 0 4\n"
      "  6 = subtract 2 5\n  7 = constant 3/5\n  8 = subtract 7 1\n  9 = multiply 1 8\n"
      "  10 = subtract 6 9\n  result 1 1 = 10\n");
  CHECK(expanded.verdict == Verdict::noted);
  CHECK(expanded.loss.value_or(0) > 1e8);
  const CertificateRow typed = row_of_anchor(
      "  2 = constant 1\n  3 = subtract 0 2\n  4 = multiply 3 3\n  5 = constant 3/10\n"
      "  6 = subtract 1 5\n  7 = multiply 6 6\n  8 = add 4 7\n  result 1 1 = 8\n");
  CHECK(typed.verdict == Verdict::holds);
  CHECK(typed.loss.value_or(100) <= tolerated_loss);
}

TEST_CASE("NaN has lost all digits, even if no bound proves it wrong") {
  // d^2/d with d = x (x - 2) + y (y - 0.6) + 1.09, which is 0 in double next to the zero.
  const CertificateRow row = row_of_anchor(
      "  2 = constant 2\n  3 = subtract 0 2\n  4 = multiply 0 3\n  5 = constant 3/5\n"
      "  6 = subtract 1 5\n  7 = multiply 1 6\n  8 = add 4 7\n  9 = constant 109/100\n"
      "  10 = add 8 9\n  11 = multiply 10 10\n  12 = divide 11 10\n  result 1 1 = 12\n");
  CHECK(row.verdict == Verdict::noted);
  CHECK(row.loss.value_or(0) > 1e15);
}

TEST_CASE("a form that keeps its digits has no loss") {
  const CertificateRow row = row_of(written_as(half_angle), LossStates::everywhere);
  CHECK(row.verdict == Verdict::holds);
  CHECK(row.samples > 30);
  CHECK(row.loss.value_or(100) <= tolerated_loss);
}

TEST_CASE("losses are measured only if requested") {
  const System system = written_as(cosine);
  const auto samples = sample_states<double>(system.subject(), {4, 1, false});
  CHECK(check_accuracy(system.subject(), samples).size() == 1);
}

TEST_CASE("states are counted once, however many fields an output has") {
  const System system = cart_pole_system();
  const auto samples = sample_states<double>(system.subject(), {8, 1, false});
  std::size_t with_fields = 0;
  for (const CertificateRow& row : check_accuracy(
           system.subject(), samples, {{ComparisonMode::entries, LossStates::everywhere}, {}})) {
    if (row.check != "digits lost") continue;
    if (row.output == "dynamics") ++with_fields;
    CHECK(row.samples <= samples.size());
  }
  CHECK(with_fields == 1);
}
