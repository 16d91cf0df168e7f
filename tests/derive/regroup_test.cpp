// Regrouped numbers: the same functions of the state, in fewer of them.
#include "derive/tree/regroup.hpp"

#include <catch2/catch.hpp>

#include "framed.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

SceneOptions all_fixed() {
  SceneOptions options;
  options.fixed = {make_source("--fix", "all")};
  return options;
}

/// q1 about z, then q2 about x at (1, 0, 2); both links of general inertia.
const char* const two_links = R"toml(
[[coordinate]]
name = "q1"
[[coordinate]]
name = "q2"
[[frame]]
name = "upper"
parent = "world"
rotate = [["z", "q1"]]
[[frame]]
name = "lower"
parent = "upper"
translate = [1, 0, 2]
rotate = [["x", "q2"]]
[[body]]
name = "first"
frame = "upper"
mass = 3
com = [1, 2, 3]
inertia = [70, 60, 50, 1, 2, 3]
inertia_about = "origin"
[[body]]
name = "second"
frame = "lower"
mass = 5
com = [1, 2, 3]
inertia = [90, 80, 70, 1, 2, 3]
inertia_about = "origin"
)toml";

}  // namespace

TEST_CASE("every output of every system of frames, all parameters fixed", "[regroup]") {
  for (const auto& [name, text] : frame_systems()) {
    Framed system(text, all_fixed());
    for (const char* output :
         {"kinetic_energy", "total_energy", "energy_function", "momentum", "gravity", "mass_matrix",
          "coriolis_matrix", "bias", "inverse_dynamics", "forward_dynamics"}) {
      INFO(name << " " << output);
      CHECK(system.agrees(output));
    }
  }
}

TEST_CASE("what a turn cannot tell from its parent moves there", "[regroup]") {
  Framed system(model_text("two_links", two_links));
  Derivation derivation(system.lagrangian);
  std::vector<RigidBody> bodies = tree_of(derivation).bodies();
  // The world's part first: a body that does not move has a weight only.
  REQUIRE(bodies.size() == 3);
  CHECK_FALSE(bodies[0].step.has_value());
  CHECK(bodies[0].mass.is_equal(8));
  const RigidBody& first = bodies[1];
  CHECK(first.mass.is_zero());
  CHECK((*first.moment)[2].is_zero());
  const RigidBody& second = bodies[2];
  CHECK(second.mass.is_zero());
  CHECK((*second.moment)[0].is_zero());
  CHECK((*second.moment)[1].is_equal(10));
  CHECK((*second.moment)[2].is_equal(15));
  // About x: Izz = 70 goes, and with it as much of Iyy.
  CHECK(second.inertia[0].is_equal(90));
  CHECK(second.inertia[1].is_equal(10));
  CHECK(second.inertia[2].is_zero());
  for (const char* output : {"kinetic_energy", "mass_matrix", "inverse_dynamics"}) {
    CHECK(system.agrees(output));
  }
}

TEST_CASE("symbolic bodies stay as they are", "[regroup]") {
  for (const auto& [name, text] : frame_systems()) {
    INFO(name);
    Framed system(text);
    Derivation derivation(system.lagrangian);
    const auto& before = system.lagrangian.tree.bodies;
    const std::vector<RigidBody>& after = tree_of(derivation).bodies();
    std::size_t symbolic = 0;
    for (const RigidBody& body : before) {
      symbolic += GiNaC::is_a<GiNaC::numeric>(body.mass) ? 0U : 1U;
    }
    std::size_t kept = 0;
    for (const RigidBody& body : after) kept += body.moment ? 0U : 1U;
    CHECK(kept >= symbolic);
  }
}
