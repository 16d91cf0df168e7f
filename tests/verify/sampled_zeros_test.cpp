// What is said of zeros that nobody proved: in the certificate, in the receipt, and by not proving.
#include "verify/bounds/sampled_zeros.hpp"

#include <catch2/catch.hpp>

#include "verify/systems.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// Entries 1 and 2 of the mass matrix rest on a sampled zero; `dynamics` repeats them.
System with_sampled_zeros() {
  System system = cart_pole_system();
  for (Function& function : system.program.functions) {
    const bool repeats = function.kind == OutputKind::dynamics;
    if (repeats || function.kind == OutputKind::mass_matrix) function.sampled_zeros = {0, 1};
  }
  return system;
}

}  // namespace

TEST_CASE("entries that rest on sampled zeros are counted once") {
  CHECK(count_sampled_zeros(cart_pole_system().program) == 0);
  CHECK(count_sampled_zeros(with_sampled_zeros().program) == 2);
}

TEST_CASE("the certificate has a row for every function with such entries") {
  CHECK(sampled_zeros(cart_pole_system().program).empty());
  const auto rows = sampled_zeros(with_sampled_zeros().program);
  REQUIRE(rows.size() == 2);
  CHECK(rows[0].subject == "mass_matrix");
  CHECK(rows[0].samples == 64);
  CHECK(rows[0].worst == "in entries 1, 2");
}

TEST_CASE("the self-check's receipt says it") {
  const System system = with_sampled_zeros();
  const std::string text = receipt(self_check(system.model, system.scene, system.program));
  CHECK(text.find("; 2 entries rest on zeros found at 64 points, not proved") != std::string::npos);
  CHECK(receipt({2, 1.0, "", 1}).find("; 1 entry rests on zeros") != std::string::npos);
}
