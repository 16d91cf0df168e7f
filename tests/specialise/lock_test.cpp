// Locked variables leave every part of a Lagrangian.
#include "specialise/lock.hpp"

#include <catch2/catch.hpp>

#include "elgen/specialise.hpp"
#include "support/systems.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

Lagrangian locked(const std::string& text, const std::string& scene) {
  const CheckedModel checked = checked_scene(text, scene);
  return *specialise(*formulate(checked.model), checked);
}

}  // namespace

TEST_CASE("the coordinate, its velocity and its force are gone") {
  const Lagrangian l = locked(cart_pole_text(), "[lock]\nx = { value = \"2*t\" }\n");
  REQUIRE(l.symbols.q.size() == 1);
  CHECK(l.symbols.v.size() == 1);
  CHECK(l.symbols.a.size() == 1);
  CHECK(l.symbols.q_rates.size() == 1);
  CHECK(l.forces.size() == 1);
  CHECK(l.leaves.q == std::vector<std::string>{"theta"});
  CHECK(l.leaves.uses_time);
  CHECK(l.locked.empty());
  CHECK_FALSE(l.holding.has_value());
}

TEST_CASE("positions are those at the function of time") {
  const Lagrangian l = locked(cart_pole_text(), "[lock]\nx = { value = \"2*t\" }\n");
  const GiNaC::ex& x = l.masses[1].position[0];
  const Definition& bob = l.definitions.list[l.definitions.places.at(x).index];
  CHECK(bob.depends.has_any(Opcode::time));
  CHECK(bob.depends.has_any(Opcode::coordinate));
}

TEST_CASE("a wanted reaction keeps the whole Lagrangian") {
  const Lagrangian l = locked(cart_pole_text(), "[lock]\ntheta = { value = 0, reaction = true }\n");
  REQUIRE(l.holding.has_value());
  CHECK(l.holding->velocities == std::vector<std::uint32_t>{1});
  CHECK(l.holding->whole->symbols.q.size() == 2);
  CHECK(l.holding->whole->definitions.list.empty());
  CHECK(l.holding->values.at(l.holding->whole->symbols.v[1]).is_zero());
}

TEST_CASE("parameters fixed and coordinates locked in one scene") {
  const Lagrangian l = locked(cart_pole_text(),
                              "[parameters]\nfixed = { l = \"1/3\" }\n"
                              "[lock]\ntheta = { value = \"l*t\" }\n");
  LeafSet depends;
  for (const PointMass& mass : l.masses) {
    for (const GiNaC::ex& x : mass.position) depends |= dependence(l.definitions, x);
  }
  CHECK_FALSE(depends.has_any(Opcode::parameter));
  CHECK(depends.has_any(Opcode::time));
}
