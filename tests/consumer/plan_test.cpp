// The example that plans a swing-up: the plan satisfies its constraints, and its derivatives are
// correct.
#include <catch2/catch.hpp>
#include <iostream>
#include <string>

#include "consumer/projects.hpp"

namespace elgen::test {

namespace {

bool ipopt_is_installed() {
  return is_installed("ipopt or eigen3", "pkg-config --exists ipopt eigen3");
}

class Planner : public Example {
 public:
  Planner() : Example("plan") {}

  /// The outcome of build/plan, rebuilt after `file` is edited by the sed command `edit`.
  [[nodiscard]] Outcome run_edited(const std::string& file, const std::string& edit,
                                   const std::string& arguments = "") const {
    const std::string before = read(file);
    prepare("sed -i '" + edit + "' " + file);
    REQUIRE(read(file) != before);
    prepare("cmake --build build");
    return run("build/plan" + arguments);
  }
};

constexpr const char* miss = "constraints are met to ";
constexpr const char* distance = "a run by rk4 ends ";
constexpr const char* force = "at most ";

}  // namespace

TEST_CASE("the plan satisfies its constraints and is closer to a simulation on a finer grid",
          "[.all]") {
  if (!ipopt_is_installed()) return;
  const Planner planner;
  const Outcome plan = planner.run("build/plan");
  std::cout << plan.output << plan.errors;
  CHECK(plan.status == 0);
  CHECK(mentions(plan.errors, "solved in "));
  CHECK(number_after(plan.output, miss) < 1e-8);
  CHECK(number_after(plan.output, force) < 20);
  CHECK(planner.run("build/plan").output == plan.output);

  const Outcome finer = planner.run_edited("main.cpp", "s/intervals = 100,/intervals = 200,/");
  CHECK(finer.status == 0);
  // The collocation and rk4 both have order 4.
  const double ratio = number_after(plan.output, distance) / number_after(finer.output, distance);
  CHECK(ratio > 12);
  CHECK(ratio < 24);
}

TEST_CASE("the plan respects the limits of the force in the model", "[.all]") {
  if (!ipopt_is_installed()) return;
  const Outcome plan = Planner().run_edited("cart_pole.toml", "s/-20, 20/-8, 8/");
  CHECK(plan.status == 0);
  CHECK(number_after(plan.output, miss) < 1e-8);
  CHECK(number_after(plan.output, force) == 8);
}

TEST_CASE("Ipopt's derivative checker accepts the plan and finds an inserted error", "[.all]") {
  if (!ipopt_is_installed()) return;
  const Planner planner;
  const std::string found = "No errors detected by derivative checker.";
  const Outcome checked = planner.run("build/plan --check");
  CHECK(checked.status == 0);
  CHECK(mentions(checked.output, found));

  const Outcome spoilt = planner.run_edited("main.cpp", "s/\\* f.B/* 1.001 * f.B/", " --check");
  CHECK_FALSE(mentions(spoilt.output, found));
  CHECK(mentions(spoilt.output, "Derivative checker detected "));
}

}  // namespace elgen::test
