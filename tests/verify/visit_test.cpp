// A visit compares one field at one state, by all entries or by one projection. Several processes
// give the same findings as one process, even if some processes fail.
#include "verify/bounds/visit.hpp"

#include <unistd.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <csignal>

#include "verify/bounds/accuracy.hpp"
#include "verify/changed_code.hpp"
#include "verify/systems.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

SampledState<double> state_of(const System& system, Region region = Region::nominal) {
  auto states = sample_states<double>(system.subject(), {1, 3, false});
  states.front().region = region;
  return states.front();
}

/// The finding of a visit of the program's first field.
Finding first_finding(const System& system, ComparisonMode comparison,
                      const SampledState<double>& state) {
  const SystemUnderTest subject = system.subject();
  StateCheck<double> visit(subject, state, {comparison});
  Sampler draw(1);
  return visit.check_field(field_places(subject).front(), draw);
}

System alone(const std::string& body, const std::string& results) {
  return system_of(cart_pole_model(), "parameters M m l g c\ncoordinates x th\ninputs u\n" +
                                          function_text("bias", body, results));
}

const ComparedField& place_of(const std::vector<ComparedField>& places, const std::string& function,
                              const std::string& field) {
  for (const ComparedField& place : places) {
    if (place.function->name == function && place.field().name == field) return place;
  }
  FAIL("no field " << function << "." << field);
  return places.front();
}

/// A system with the coordinate x and the potential V, which the program computes by `body`.
System with_potential(const std::string& V, const std::string& body) {
  ModelBuilder builder;
  builder.coordinate("x").T("x_d^2/2").V(V);
  return system_of(builder.model,
                   "coordinates x\nfunction potential_energy\n  0 = coordinate x\n" + body);
}

/// 2 (sin(x/2)/x)^2
System half_angles() {
  return with_potential("(1 - cos(x))/x^2",
                        "  1 = constant 1/2\n  2 = multiply 1 0\n  3 = sin 2\n"
                        "  4 = divide 3 0\n  5 = multiply 4 4\n  6 = add 5 5\n"
                        "  result 1 1 = 6\n");
}

/// sin(x) (1 - cos(x))/(cos(x) x^3), with 1 - cos(x) computed as 2 sin(x/2)^2.
System tangent_less_sine() {
  return with_potential("(tan(x) - sin(x))/x^3",
                        "  1 = constant 1/2\n  2 = multiply 1 0\n  3 = sin 2\n"
                        "  4 = divide 3 0\n  5 = multiply 4 4\n  6 = add 5 5\n"
                        "  7 = tan 0\n  8 = divide 7 0\n  9 = multiply 8 6\n"
                        "  result 1 1 = 9\n");
}

/// A load on a rope of length l at the angle th. a_l = l th_d^2 + g cos(th). When the oracle
/// computes a_th = -(2 l_d th_d + g sin(th))/l, large terms without the factor l cancel.
System crane(const std::string& twice = "13 = add 12 12") {
  ModelBuilder builder;
  builder.coordinate("l").coordinate("th").parameter("m", "50").parameter("g", "9.81");
  builder.point("load", {"l*sin(th)", "-l*cos(th)"}, "m").gravity({"0", "-g"});
  return system_of(builder.model,
                   "parameters m g\ncoordinates l th\nfunction forward_dynamics\n"
                   "  0 = parameter g\n  1 = coordinate l\n  2 = coordinate th\n"
                   "  3 = velocity l\n  4 = velocity th\n  5 = sin 2\n  6 = cos 2\n"
                   "  7 = multiply 0 6\n  8 = multiply 4 4\n  9 = multiply 1 8\n"
                   "  10 = add 9 7\n  11 = multiply 0 5\n  12 = multiply 3 4\n  " +
                       twice +
                       "\n  14 = add 13 11\n  15 = divide 14 1\n  16 = negate 15\n"
                       "  17 = constant 1\n  result acceleration 2 1 = 10 16\n"
                       "  result relative_pivots 2 1 = 17 17\n");
}

SampledState<double> state_at_length(const System& system, double l) {
  SampledState<double> state = state_of(system, Region::extreme);
  state.values.q = {l, 0.3};
  state.values.v = {1, 2};
  return state;
}

SampledState<double> state_at(const System& system, double x) {
  SampledState<double> state = state_of(system, Region::extreme);
  state.values.q[0] = x;
  return state;
}

using Change = std::function<double(double)>;

double unchanged(double x) { return x; }

/// All rows of `system` as text and JSON; `change` applies to bias in the build with users' flags.
std::string rows_by(std::size_t jobs, const System& system, const Change& change = unchanged,
                    ComparisonMode comparison = ComparisonMode::entries) {
  const Changed code(system.program, "bias", change);
  const AccuracyOptions options{{comparison, LossStates::everywhere, 0, &code}, {}, jobs};
  const auto states = sample_states<double>(system.subject(), {4, 1, true});
  const Certificate certificate{"sample", "full", 1,
                                check_accuracy(system.subject(), states, options)};
  return to_full_text(certificate) + to_json(certificate);
}

/// A change that calls `fail` in the child processes, not in the waiting parent.
Change in_child_processes(const std::function<void()>& fail) {
  return [fail, waiting = ::getpid()](double x) {
    if (::getpid() != waiting) fail();
    return x;
  };
}

volatile std::sig_atomic_t late_signals = 0;

}  // namespace

TEST_CASE("a correct field has no error, and its roundings are counted") {
  const System system = alone(instructions::rates, "  result 2 1 = 23 22\n");
  for (const ComparisonMode comparison : {ComparisonMode::entries, ComparisonMode::projections}) {
    const Finding finding = first_finding(system, comparison, state_of(system));
    CHECK(finding.regime == Regime::regular);
    CHECK(finding.mistake.empty());
    CHECK(finding.errors.size() == 2);
  }
}

TEST_CASE("a wrong field is found by both comparisons") {
  const System system = alone(instructions::rates, "  result 2 1 = 23 21\n");
  const SampledState<double> state = state_of(system);
  CHECK(first_finding(system, ComparisonMode::entries, state).mistake.find("entry 2 is ") == 0);
  CHECK(first_finding(system, ComparisonMode::projections, state).mistake.find("w.x is ") == 0);
}

TEST_CASE("where 1 - cos(x) needs more digits, program and oracle get them") {
  for (const System& system : {half_angles(), tangent_less_sine()}) {
    for (const double x : {1e-12, 1e-30, 1e-60, 1e-150}) {
      for (const ComparisonMode comparison :
           {ComparisonMode::entries, ComparisonMode::projections}) {
        const Finding finding = first_finding(system, comparison, state_at(system, x));
        INFO(x << ": " << finding.mistake);
        CHECK(finding.mistake.empty());
        CHECK(finding.regime == Regime::regular);
      }
    }
  }
}

TEST_CASE(
    "a solution after cancellation of large forces is compared with as many digits as it needs") {
  const System right = crane();
  for (const double l : {1.0, -1e-10, -1e-150}) {
    for (const ComparisonMode comparison : {ComparisonMode::entries, ComparisonMode::projections}) {
      const Finding finding = first_finding(right, comparison, state_at_length(right, l));
      INFO(l << ": " << finding.mistake);
      CHECK(finding.is_compared);
      CHECK(finding.mistake.empty());
    }
  }
  const System wrong = crane("13 = add 12 3");
  for (const double l : {1.0, -1e-10}) {
    INFO(l);
    CHECK_FALSE(
        first_finding(wrong, ComparisonMode::entries, state_at_length(wrong, l)).mistake.empty());
  }
}

TEST_CASE("a mistake is found with any number of digits, near a zero too") {
  // The program computes (sin(x/2)/x)^2, half of V.
  const System system = with_potential("(1 - cos(x))/x^2",
                                       "  1 = constant 1/2\n  2 = multiply 1 0\n  3 = sin 2\n"
                                       "  4 = divide 3 0\n  5 = multiply 4 4\n"
                                       "  result 1 1 = 5\n");
  for (const double x : {1.0, 1e-3, 1e-12, 1e-30}) {
    INFO(x);
    const SampledState<double> state = state_at(system, x);
    CHECK_FALSE(first_finding(system, ComparisonMode::entries, state).mistake.empty());
    CHECK_FALSE(first_finding(system, ComparisonMode::projections, state).mistake.empty());
  }
}

TEST_CASE("a value must be defined where the oracle's is only at ordinary states") {
  const System system =
      alone(instructions::rates + "  24 = divide 22 17\n", "  result 2 1 = 23 24\n");
  const Finding ordinary = first_finding(system, ComparisonMode::entries, state_of(system));
  CHECK(mentions(ordinary.mistake, "is undefined, the oracle says "));
  const Finding extreme =
      first_finding(system, ComparisonMode::entries, state_of(system, Region::extreme));
  CHECK(extreme.mistake.empty());
  CHECK(extreme.regime == Regime::undefined);
}

TEST_CASE("the fields of an output are adjacent, in the oracle as in the program") {
  const System system = cart_pole_system();
  const auto places = field_places(system.subject());
  const ComparedField& pivots = place_of(places, "forward_dynamics", "relative_pivots");
  CHECK(pivots.field_index == 1);
  CHECK(pivots.first_entry == 2);
  CHECK(pivots.first_oracle_entry == 2);
  CHECK(pivots.request.kind == OutputKind::forward_dynamics);
  CHECK(pivots.request_field_index == 1);
}

TEST_CASE("a field of `dynamics` is the output of the same name") {
  const System system = cart_pole_system();
  const auto places = field_places(system.subject());
  const ComparedField& bias = place_of(places, "dynamics", "bias");
  CHECK(bias.field_index == 1);
  CHECK(bias.first_entry == 4);
  CHECK(bias.first_oracle_entry == 0);
  CHECK(bias.request.kind == OutputKind::bias);
  CHECK(bias.request_field_index == 0);
}

TEST_CASE("several processes find the same as one, mistakes and infinite errors too") {
  const auto infinite = [](double) { return HUGE_VAL; };
  const System right = cart_pole_system();
  const System wrong = with_mistake("gravity", "= 16 15", "= 16 14");
  for (const ComparisonMode comparison : {ComparisonMode::entries, ComparisonMode::projections}) {
    CHECK(rows_by(3, right, unchanged, comparison) == rows_by(1, right, unchanged, comparison));
    CHECK(rows_by(3, wrong, unchanged, comparison) == rows_by(1, wrong, unchanged, comparison));
  }
  CHECK(rows_by(2, right, infinite) == rows_by(1, right, infinite));
  CHECK(rows_by(500, right) == rows_by(1, right));
}

TEST_CASE("if states are distributed, the waiting process visits none") {
  std::size_t calls = 0;
  const auto counted = [&calls](double x) {
    ++calls;
    return x;
  };
  (void)rows_by(2, cart_pole_system(), counted);
  CHECK(calls == 0);
  (void)rows_by(1, cart_pole_system(), counted);
  CHECK(calls > 0);
}

TEST_CASE("if a process fails, the waiting process visits all states") {
  const System system = cart_pole_system();
  const std::string alone = rows_by(1, system);
  CHECK(rows_by(2, system, in_child_processes([] { (void)::raise(SIGKILL); })) == alone);
  CHECK(rows_by(2, system, in_child_processes([] { throw 1; })) == alone);
}

TEST_CASE("the time limit of one process is the limit of all") {
  const auto before = ::signal(SIGXCPU, [](int) { late_signals = late_signals + 1; });
  (void)rows_by(2, cart_pole_system(), in_child_processes([] { (void)::raise(SIGXCPU); }));
  (void)::signal(SIGXCPU, before);
  CHECK(late_signals == 1);
}

TEST_CASE("every state is taken once, in order, and progress is reported") {
  const System system = cart_pole_system();
  const SystemUnderTest subject = system.subject();
  const auto states = sample_states<float>(subject, {8, 1, false});
  for (const std::size_t jobs : {1U, 3U}) {
    std::vector<std::size_t> taken;
    std::vector<std::string> steps;
    const AccuracyOptions options{
        {}, [&steps](const std::string& step) { steps.push_back(step); }, jobs};
    check_states(subject, states, options,
                 [&taken, &subject](std::size_t at, const Findings& found) {
                   taken.push_back(at);
                   CHECK(found.size() == field_places(subject).size());
                 });
    CHECK(taken == std::vector<std::size_t>{0, 1, 2, 3, 4, 5, 6, 7});
    REQUIRE_FALSE(steps.empty());
    CHECK(steps.front().find("accuracy in float, state ") == 0);
  }
}
