// The table of identities: complete, and each balance sees what it is made of.
#include "verify/structure/identities.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "verify/systems.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

ExactValues at_random_state(const System& system) {
  return {system.subject(), random_state(system.model, 3)};
}

}  // namespace

TEST_CASE("identities have distinct names and name the functions they use") {
  std::set<std::string_view> names;
  for (const Identity& identity : identities()) {
    CHECK(names.insert(identity.check).second);
    CHECK(identity.functions.size() >= 2);
  }
}

TEST_CASE("every balance vanishes for a right program, to 60 digits of its terms") {
  const System system = cart_pole_system();
  ExactValues at = at_random_state(system);
  for (const Identity& identity : identities()) {
    INFO(identity.check);
    const auto figure = identity.balance(at).figure(at.floor());
    REQUIRE(figure);
    CHECK(*figure < 1e-60);
  }
  for (const OutputIdentity& identity : output_identities()) {
    INFO(identity.check);
    CHECK(identity.balance(at, 0).figure(at.floor()).value() < 1e-60);
  }
}

TEST_CASE("parts that the program lacks come from the oracle") {
  System system = cart_pole_system();
  auto& functions = system.program.functions;
  functions.erase(std::remove_if(functions.begin(), functions.end(),
                                 [](const Function& f) {
                                   return f.kind == OutputKind::dissipation ||
                                          f.kind == OutputKind::input_matrix;
                                 }),
                  functions.end());
  ExactValues at = at_random_state(system);
  for (const Identity& identity : identities()) {
    INFO(identity.check);
    // The oracle's numbers have 60 digits.
    CHECK(identity.balance(at).figure(at.floor()).value() < 1e-55);
  }
}
