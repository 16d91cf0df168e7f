// Which method, and by which steps: what is refused, and why.
#include "simulate/method_choice.hpp"

#include <catch2/catch.hpp>

using namespace elgen;

namespace {

std::string message(const Diagnostics& diagnostics) {
  if (diagnostics.empty()) return "";
  const Diagnostic& first = diagnostics.front();
  return std::string(code_row(first.code).name) + " " + first.message +
         (first.hint.empty() ? "" : " | " + first.hint);
}

std::string rule_of(const SimulationOptions& options) {
  return message(step_rule(*find_method(options), options).diagnostics);
}

}  // namespace

TEST_CASE("methods have names") {
  CHECK(find_method({.method = "rk4"})->name == "rk4");
  CHECK(message(find_method({.method = "rk5"}).diagnostics) ==
        "E620 unknown method `rk5` | did you mean `rk4`?");
  for (const std::string name : {"gauss", "euler", "fehlberg78"}) {
    CHECK(message(find_method({.method = name}).diagnostics) ==
          "E620 unknown method `" + name + "` | one of rk4, dopri5, verlet, midpoint");
  }
  CHECK(find_method({.is_reference = true})->name == "fehlberg78");
}

TEST_CASE("verlet and midpoint go by a program of `step`") {
  CHECK(step_of_run({.method = "verlet"}) == StepMethod::verlet);
  CHECK(step_of_run({.method = "midpoint"}) == StepMethod::midpoint);
  for (const char* name : {"rk4", "dopri5", "rk5"}) CHECK_FALSE(step_of_run({.method = name}));
}

TEST_CASE("times, steps and tolerances are positive, and one rule decides the steps") {
  CHECK(rule_of({.time = 1}).empty());
  CHECK(step_rule(*find_method({}), {.time = 1})->tolerance == 1e-9);
  CHECK(rule_of({.time = -1}) == "E621 `--time -1` is not a positive number");
  CHECK(rule_of({.from = 1.0 / 0.0, .time = 1}) == "E621 `--from inf` is not a number");
  CHECK(rule_of({.time = 1, .step = 0}) == "E621 `--step 0` is not a positive number");
  CHECK(rule_of({.time = 1, .tolerance = 0}) == "E621 `--tolerance 0` is not a positive number");
  CHECK(rule_of({.time = 1, .hold = -2}) == "E621 `--hold -2` is not a positive number");
  CHECK(rule_of({.time = 1, .step = 0.1, .tolerance = 0.1}) ==
        "E621 `--step` and `--tolerance` are given, but one follows from the other");
  CHECK(rule_of({.time = 1, .every = 2}) ==
        "E621 `--every 2` is longer than the whole run, `--time 1`");
  CHECK(rule_of({.method = "rk4", .time = 1}) == "E621 `rk4` needs a step | give it `--step`");
  CHECK(rule_of({.method = "rk4", .time = 1, .tolerance = 1e-3}) ==
        "E621 `rk4` does not choose its steps by a tolerance | give it `--step`, or take `dopri5`");
}
