// Loss: bad formulas lose digits that good ones keep, and ill-conditioned values excuse both.
#include "verify/bounds/loss.hpp"

#include <catch2/catch.hpp>

#include "verify/pendulum_forms.hpp"

using namespace elgen;
using namespace elgen::test;
using namespace elgen::test::pendulum_forms;

namespace {

State at(double angle) {
  State state;
  state.parameters = {1, 1, cln::cl_RA(981) / 100};
  state.q = {exact_value(angle)};
  return state;
}

/// The largest loss of values that are off by `errors` times u.
Loss loss_of(const System& system, const State& state, double error) {
  const Subject subject = system.subject();
  const FieldPlace place = field_places(subject).front();
  const auto exact = bounded_run(system.program, *place.function, state, rounding<double>());
  Losses losses(subject, state, rounding<double>());
  const Real off = Real(exact_value(error)) * rounding<double>().roundoff;
  return losses.of_field(place, {off}, {exact.entries[0].value}, {});
}

/// Whether doubles, as the code computes them, lose no more than is tolerated.
bool keeps(const std::string& text, double angle) {
  const System system = written_as(text);
  const Subject subject = system.subject();
  const FieldPlace place = field_places(subject).front();
  const State state = at(angle);
  const auto exact = bounded_run(system.program, *place.function, state, rounding<double>());
  const double x = evaluate(system.program, *place.function, arguments_at<double>(state)).front();
  Losses losses(subject, state, rounding<double>());
  const Real error = abs(Real(exact_value(x)) - exact.entries[0].value);
  return losses.of_field(place, {error}, {exact.entries[0].value}, {}).of_entry.figure <=
         tolerated_loss;
}

}  // namespace

TEST_CASE("1 - cos(th) keeps its digits at ordinary angles and none at tiny ones") {
  CHECK(keeps(cosine, 1));
  CHECK_FALSE(keeps(cosine, 1e-3));
  CHECK_FALSE(keeps(cosine, 1e-8));
  CHECK(keeps(half_angle, 1));
  CHECK(keeps(half_angle, 1e-8));
}

TEST_CASE("an angle of 1e15 rad excuses what is made of it") { CHECK(keeps(cosine, 1e15)); }

TEST_CASE("an angle that is not known to 1/1000 rad tells nothing") {
  const System system = written_as(cosine);
  const Subject subject = system.subject();
  const State far = at(1e14);
  const State near = at(1e10);
  CHECK_FALSE(Losses(subject, far, rounding<double>()).knows_angles());
  CHECK(Losses(subject, near, rounding<double>()).knows_angles());
  CHECK_FALSE(Losses(subject, near, rounding<float>()).knows_angles());
}

TEST_CASE("losses are counted in what the inputs' rounding costs") {
  const System system = written_as(cosine);
  // x = 9.81 (1 - cos 1); m, l, g and th each cost their share.
  const double x = 9.81 * (1 - std::cos(1.0));
  const double reference = 4 * x + 9.81 * std::sin(1.0);
  CHECK(loss_of(system, at(1), 100 * x).of_entry.figure == Approx(100 * x / reference));
  // R >= |x|, which does until the loss is grave.
  CHECK(loss_of(system, at(1), 60 * x).of_entry.figure == Approx(60));
  CHECK(loss_of(system, at(1), 100 * x).of_field.figure == Approx(100));
}

TEST_CASE("where K has no value nothing is said of a loss") {
  const System system = written_as(friction);
  // Beyond 2^29 no exponential is a number of 60 digits; the bounds know that tanh is 1.
  CHECK(loss_of(system, at(1e8), 1e6).of_entry.figure > 1e4);
  CHECK(loss_of(system, at(1e9), 1e6).of_entry.figure == 0);
}
