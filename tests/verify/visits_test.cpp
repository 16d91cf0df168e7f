// Visits shared out: several processes find what one finds, whatever becomes of them.
#include "verify/bounds/visits.hpp"

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

using Change = std::function<double(double)>;

double as_is(double x) { return x; }

/// All rows of a system, whose bias as users compile it is changed.
std::string rows_by(std::size_t jobs, const System& system, const Change& change = as_is,
                    Comparison comparison = Comparison::entries) {
  const Changed code(system.program, "bias", change);
  const AccuracyOptions options{{comparison, nullptr, Losing::everywhere, &code}, {}, jobs};
  const auto states = sample_states<double>(system.subject(), {4, 1, true});
  const Certificate certificate{
      "sample", "full", 1, check_accuracy(system.subject(), states, options)};
  return to_full_text(certificate) + to_json(certificate);
}

/// What a process does that shares the states; the one that waits for it goes on.
Change in_others(const std::function<void()>& fail) {
  return [fail, waiting = ::getpid()](double x) {
    if (::getpid() != waiting) fail();
    return x;
  };
}

volatile std::sig_atomic_t late_signals = 0;

}  // namespace

TEST_CASE("several processes find what one finds, mistakes and infinite errors too") {
  const auto infinite = [](double) { return HUGE_VAL; };
  const System right = cart_pole_system();
  const System wrong = mutated("gravity", "= 16 15", "= 16 14");
  for (const Comparison comparison : {Comparison::entries, Comparison::projections}) {
    CHECK(rows_by(3, right, as_is, comparison) == rows_by(1, right, as_is, comparison));
    CHECK(rows_by(3, wrong, as_is, comparison) == rows_by(1, wrong, as_is, comparison));
  }
  CHECK(rows_by(2, right, infinite) == rows_by(1, right, infinite));
  CHECK(rows_by(500, right) == rows_by(1, right));
}

TEST_CASE("where states are shared out, the process that waits visits none") {
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

TEST_CASE("where a process fails, the one that waits visits all states") {
  const System system = cart_pole_system();
  const std::string alone = rows_by(1, system);
  CHECK(rows_by(2, system, in_others([] { (void)::raise(SIGKILL); })) == alone);
  CHECK(rows_by(2, system, in_others([] { throw 1; })) == alone);
}

TEST_CASE("the time of one process is the time of all") {
  const auto before = ::signal(SIGXCPU, [](int) { late_signals = late_signals + 1; });
  (void)rows_by(2, cart_pole_system(), in_others([] { (void)::raise(SIGXCPU); }));
  (void)::signal(SIGXCPU, before);
  CHECK(late_signals == 1);
}

TEST_CASE("every state is taken once, in order, and steps are told") {
  const System system = cart_pole_system();
  const Subject subject = system.subject();
  const auto states = sample_states<float>(subject, {8, 1, false});
  for (const std::size_t jobs : {1U, 3U}) {
    std::vector<std::size_t> taken;
    std::vector<std::string> steps;
    const AccuracyOptions options{
        {}, [&steps](const std::string& step) { steps.push_back(step); }, jobs};
    visit_all(subject, states, options, [&taken, &subject](std::size_t at, const Findings& found) {
      taken.push_back(at);
      CHECK(found.size() == field_places(subject).size());
    });
    CHECK(taken == std::vector<std::size_t>{0, 1, 2, 3, 4, 5, 6, 7});
    REQUIRE_FALSE(steps.empty());
    CHECK(steps.front().find("accuracy in float, state ") == 0);
  }
}
