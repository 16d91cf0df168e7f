// A state at which a change is seen.
#include "diff/witness.hpp"

#include <catch2/catch.hpp>

#include "diff/versions.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

EntryChange told(const std::string& before, const std::string& after) {
  const SystemChange system = compared(before, after);
  const auto entries = entries_of(system, "potential_energy");
  REQUIRE(entries.size() == 1);
  REQUIRE(entries[0].witness);
  return entries[0];
}

}  // namespace

TEST_CASE("the witness lists what the entry depends on, rounded as it is printed") {
  const EntryChange change = told(spring("1/2*k*x^2"), spring("k*x^2"));
  CHECK(change.share == Approx(0.5));
  const std::string& at = change.witness->at;
  REQUIRE(starts_with(at, "x = "));
  const double x = std::stod(at.substr(4));
  CHECK(change.witness->before == Approx(1.5 * x * x).epsilon(1e-12));
  CHECK(change.witness->after == Approx(3 * x * x).epsilon(1e-12));
}

TEST_CASE("parameters of value 0 are drawn, so that what they multiply is seen") {
  const std::string before = edited(spring(), "k = 3", "k = 3\nc = 0");
  const EntryChange change = told(before, edited(before, "1/2*k*x^2", "1/2*k*x^2 + c*x^4"));
  CHECK(mentions(change.witness->at, "c = "));
  CHECK(change.share > 0);
}
