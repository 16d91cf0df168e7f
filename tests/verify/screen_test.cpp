// Screening: the same whatever the number of processes, and their failures in words.
#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <functional>

#include "elgen/certificate.hpp"
#include "elgen/screening.hpp"
#include "evaluate/states.hpp"
#include "verify/systems.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// Judges the first field by q[0], says nothing of the others.
class Judge final : public ScreeningCode {
 public:
  Judge(const Program& program, std::function<double(double)> figure) : figure_(std::move(figure)) {
    for (const Function& function : program.functions) fields_ += function.fields.size();
  }
  void judge(const Arguments<double>& state, double* figures) const override {
    judge_first(state.q[0], figures);
  }
  void judge(const Arguments<float>& state, double* figures) const override {
    judge_first(static_cast<double>(state.q[0]), figures);
  }

 private:
  void judge_first(double q, double* figures) const {
    for (std::size_t i = 0; i < fields_ * figures_per_field; ++i) figures[i] = -1;
    figures[0] = figure_(q);
  }

  std::size_t fields_ = 0;
  std::function<double(double)> figure_;
};

double position(double q) { return q; }

Result<Screening> screened(const System& system, const std::function<double(double)>& figure,
                           ScreeningOptions options = {.samples = 200}) {
  const Judge judge(system.program, figure);
  return screen(system.model, system.scene, system.program, judge, options);
}

void crash_at_large_ones(double q) {
  if (q > 100) (void)::raise(SIGSEGV);
}

}  // namespace

TEST_CASE("the worst states are found, of both scalars") {
  const System system = cart_pole_system();
  const auto found = screened(system, position);
  REQUIRE(found);
  REQUIRE(found->size() == 2);
  CHECK(found->back().scalar == ScalarKind::single_precision);
  const ScreenedStates& doubles = found->front();
  const auto states = sample_states<double>(system.subject(), {200, 1, true});
  CHECK(doubles.states == states.size());
  double largest = 0;
  for (const auto& state : states) largest = std::max(largest, state.values.q[0]);
  REQUIRE_FALSE(doubles.worst[0].empty());
  CHECK(doubles.worst[0].front().figure == largest);
  CHECK(states[doubles.worst[0].front().state].values.q[0] == largest);
  CHECK(doubles.worst[1].empty());
}

TEST_CASE("processes and shards find together what one finds") {
  const System system = cart_pole_system();
  const auto alone = screened(system, position);
  const auto by_three = screened(system, position, {.samples = 200, .jobs = 3});
  REQUIRE(alone);
  REQUIRE(by_three);
  CHECK(*alone == *by_three);
  std::vector<Screening> shards;
  for (std::uint64_t number = 1; number <= 3; ++number) {
    const auto shard =
        screened(system, position, {.samples = 200, .shard = {number, 3}, .jobs = 2});
    REQUIRE(shard);
    shards.push_back(*shard);
  }
  CHECK(joined(shards) == *alone);
}

TEST_CASE("another seed has other states") {
  const System system = cart_pole_system();
  CHECK(*screened(system, position) != *screened(system, position, {.samples = 200, .seed = 2}));
}

TEST_CASE("a process that fails is E710, one that is late E909") {
  const System system = cart_pole_system();
  const auto diagnostic = [&](const std::function<double(double)>& figure) {
    const auto found = screened(system, figure, {.samples = 200, .jobs = 2, .seconds = 7});
    REQUIRE_FALSE(found);
    return found.diagnostics.front();
  };
  const Diagnostic crashed = diagnostic([](double q) {
    crash_at_large_ones(q);
    return q;
  });
  CHECK(crashed.code == Code::E710);
  CHECK(crashed.message == "a screening process was ended by signal 11");
  const Diagnostic thrown = diagnostic([](double q) { return q > 100 ? throw 1 : q; });
  CHECK(thrown.message == "a screening process exits 70");
  const Diagnostic late = diagnostic([](double) { return ::raise(SIGXCPU); });
  CHECK(late.code == Code::E909);
  CHECK(late.message == "7 s of processor time are over");
}

TEST_CASE("of screened states only some are visited, and the certificate says so") {
  const System system = cart_pole_system();
  const auto found = screened(system, position, {.samples = 3000});
  REQUIRE(found);
  const VerifyOptions options{.samples = 3000, .screening = &*found};
  Screening few = *found;
  for (ScreenedStates& states : few) {
    for (auto& worst : states.worst) worst.resize(std::min<std::size_t>(worst.size(), 8));
  }
  VerifyOptions quick = options;
  quick.screening = &few;
  const Certificate certificate =
      verify(system.model, system.scene, system.program, {}, quick).certificate;
  CHECK(holds(certificate));
  REQUIRE(certificate.screened.size() == 2);
  CHECK(certificate.screened.front().states == found->front().states);
  CHECK(certificate.screened.front().visited <= 64 + 8);
  CHECK(certificate.screened.front().visited >= 64);
  CHECK(to_text(certificate).find(" states in double, of which ") != std::string::npos);
}
