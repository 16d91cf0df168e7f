// Compares the output of elgen for random models and scenes with values from the definition of the
// equations. A wrong number must be found.
#include <catch2/catch.hpp>

#include "random/generator.hpp"
#include "random/trial.hpp"
#include "support/shell.hpp"

using namespace elgen::test::random;

namespace {

constexpr std::uint64_t seeds = 40;
/// `verify` takes seconds per seed. The target `random` runs it for every seed.
constexpr std::uint64_t verified_every = 8;

std::string findings_text(std::uint64_t seed, const std::vector<Finding>& findings) {
  std::string text;
  for (const Finding& finding : findings) {
    text += "seed " + std::to_string(seed) + ": " + finding.kind + "\n" + finding.text;
  }
  return text;
}

System pendulum() {
  System system;
  Model& model = system.model;
  model.name = "pendulum";
  model.coordinates = {{.name = "q1"}};
  model.parameters = {{.name = "l", .values = {number("0.5")}}};
  const Expression q = name("q1");
  const Expression l = name("l");
  model.points = {{.name = "bob",
                   .at = {l * call_of("sin", {q}), -l * call_of("cos", {q})},
                   .mass = number(2)}};
  model.gravity = {number(0), -call_of("sqrt", {number(3)})};
  return system;
}

}  // namespace

TEST_CASE("random models: generated, shown and compiled equations are true") {
  const elgen::test::Workspace folder;
  std::vector<Trial> trials;
  std::string failures;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    trials.push_back(make_trial(Generator(seed).system(), seed));
    failures += findings_text(seed, compare_shown(trials.back(), folder.path()));
  }
  const auto compiled = compare_compiled(trials, folder.path());
  for (std::size_t i = 0; i < trials.size(); ++i)
    failures += findings_text(trials[i].seed, compiled[i]);
  INFO(failures);
  CHECK(failures.empty());
}

TEST_CASE("random models: verify gives the right verdicts") {
  std::string failures;
  for (std::uint64_t seed = 0; seed < seeds; seed += verified_every) {
    // Even seeds have rational constants, odd seeds irrational constants. Both kinds are needed.
    const std::uint64_t drawn = seed + seed / verified_every % 2;
    const elgen::test::Workspace folder;
    Trial trial = make_trial(Generator(drawn).system(), drawn);
    failures += findings_text(drawn, compare_shown(trial, folder.path()));
    failures += findings_text(drawn, compare_verdicts(trial, folder.path()));
  }
  INFO(failures);
  CHECK(failures.empty());
}

TEST_CASE("states far outside the ranges raise no false error") {
  // These states have ratios of parameters up to 1e12. At seed 8129 intermediate values have larger
  // rounding errors than M and b. At seed 8136 derivatives cancel in 64 digits.
  for (const std::uint64_t seed : {8129U, 8136U}) {
    const elgen::test::Workspace folder;
    Trial trial = make_trial(Generator(seed).system(), seed);
    REQUIRE(compare_shown(trial, folder.path()).empty());
    CHECK(findings_text(seed, compare_verdicts(trial, folder.path())).empty());
  }
}

TEST_CASE("a wrong number is found in shown equations and in compiled code") {
  const elgen::test::Workspace folder;
  Trial trial = make_trial(pendulum(), 1);
  REQUIRE(findings_text(1, compare_shown(trial, folder.path())).empty());
  REQUIRE(compare_compiled({trial}, folder.path())[0].empty());

  trial.drawn["gravity"][0] += Number("1e-35");
  const auto shown = compare_shown(trial, folder.path());
  REQUIRE(shown.size() == 1);
  CHECK(shown[0].kind == "shown gravity");

  trial.given["gravity"][0] += Number("1e-10");
  const auto compiled = compare_compiled({trial}, folder.path())[0];
  REQUIRE(compiled.size() == 1);
  CHECK(compiled[0].kind == "compiled gravity");
}
