// The force on what is locked: by hand, and definitions that stay true.
#include "derive/outputs/reaction.hpp"

#include <catch2/catch.hpp>

#include "derive/outputs/forces.hpp"
#include "elgen/specialise.hpp"
#include "formulate/print.hpp"
#include "support/systems.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// Definitions written out; for small systems only.
GiNaC::ex whole(const Definitions& definitions, GiNaC::ex value) {
  for (std::size_t i = definitions.list.size(); i-- > 0;) {
    value = value.subs(definitions.list[i].symbol == definitions.list[i].value);
  }
  return value.expand();
}

}  // namespace

TEST_CASE("the force that holds a cart is that of the swinging bob") {
  const CheckedModel checked =
      checked_scene(cart_pole_text(), "[lock]\nx = { value = 0, reaction = true }\n");
  Derivation d(*specialise(*formulate(checked.model), checked));
  const Vector before = gravity(d);
  const Vector force = reaction(d);
  const Vector after = gravity(d);
  REQUIRE(force.size() == 1);
  const auto& [theta, omega, alpha] = std::tie(d.symbols.q[0], d.symbols.v[0], d.symbols.a[0]);
  const GiNaC::ex m = d.symbols.parameters[1];
  const GiNaC::ex l = d.symbols.parameters[2];
  // m l (cos(theta) theta'' - sin(theta) theta'^2) - u
  const GiNaC::ex expected =
      m * l * (cos(theta) * alpha - sin(theta) * omega * omega) - d.symbols.u[0];
  CHECK((whole(d.definitions, force[0]) - expected).expand().is_zero());
  CHECK((whole(d.definitions, before[0]) - whole(d.definitions, after[0])).is_zero());
}
