// Regrouping makes some numeric inertias 0, and leaves the outputs the same functions of the state.
// T, momentum, forces and M stay consistent for quaternions of any length.
#include <catch2/catch.hpp>

#include "derive/tree/tree.hpp"
#include "framed.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

SceneOptions all_fixed() {
  SceneOptions options;
  options.fixed = {make_source("--fix", "all")};
  return options;
}

/// q1 about z, then q2 about x at (1, 0, 2); both links have general inertias.
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

/// A model with a coordinate x and a rotation e; `more` has parameters, frames and bodies.
std::string flying(const std::string& more) {
  return model_text("flying", R"toml([[coordinate]]
name = "x"
[[coordinate]]
name = "e"
kind = "rotation"
)toml" + more);
}

const std::string hull = R"toml([parameters]
m = 2
b = 1
c = "1/3"
J = "1/5"
[[frame]]
name = "hull"
parent = "world"
translate = ["x", "b", "x/2"]
rotation = "e"
[[body]]
name = "hull"
frame = "hull"
mass = "m"
com = ["c", "b/2", "-c"]
inertia = ["J", "2*J", "5/2*J"]
)toml";

/// The largest error of p = M v, tau(a) - tau(0) = M a and p v = 2 T; p is the momentum. The
/// quaternions of the state do not have length 1.
double error_off_sphere(const std::string& text) {
  Framed system(text);
  State state = some_state(system.checked, 1);
  for (const Rotation& rotation : system.checked.model.rotations) {
    for (std::uint32_t i = 0; i < quaternion_size; ++i) {
      cln::cl_R& e = state.q[rotation.first_coordinate + i];
      e = e * cln::cl_RA(11) / 10;
    }
  }
  const std::size_t n = system.size();
  const Reals mass = system.derived("mass_matrix", state);
  const Reals momentum = system.derived("momentum", state);
  const Reals kinetic = system.derived("kinetic_energy", state);
  const Reals force = system.derived("inverse_dynamics", state);
  State at_rest = state;
  for (cln::cl_R& a : at_rest.a) a = 0;
  const Reals bias = system.derived("inverse_dynamics", at_rest);
  cln::cl_R worst = 0;
  cln::cl_R twice = 0;
  for (std::size_t i = 0; i < n; ++i) {
    cln::cl_R of_rate = momentum[i];
    cln::cl_R of_acceleration = force[i] - bias[i];
    for (std::size_t j = 0; j < n; ++j) {
      of_rate = of_rate - mass[i * n + j] * state.v[j];
      of_acceleration = of_acceleration - mass[i * n + j] * state.a[j];
    }
    twice = twice + momentum[i] * state.v[i];
    worst = cln::max(worst, cln::max(cln::abs(of_rate), cln::abs(of_acceleration)));
  }
  worst = cln::max(worst, cln::abs(twice - 2 * kinetic[0]));
  return cln::double_approx(worst);
}

}  // namespace

TEST_CASE("every output of every system of frames agrees with all parameters fixed", "[regroup]") {
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

TEST_CASE("inertia that acts equally on the parent of a rotation moves to the parent",
          "[regroup]") {
  Framed system(model_text("two_links", two_links));
  Derivation derivation(system.lagrangian);
  std::vector<RigidBody> bodies = tree_of(derivation).bodies();
  // bodies[0] is the world, which does not move; the mass 3 + 5 of the world has only a weight.
  REQUIRE(bodies.size() == 3);
  CHECK_FALSE(bodies[0].transform.has_value());
  CHECK(bodies[0].mass.is_equal(8));
  const RigidBody& first = bodies[1];
  CHECK(first.mass.is_zero());
  CHECK((*first.moment)[2].is_zero());
  const RigidBody& second = bodies[2];
  CHECK(second.mass.is_zero());
  CHECK((*second.moment)[0].is_zero());
  CHECK((*second.moment)[1].is_equal(10));
  CHECK((*second.moment)[2].is_equal(15));
  // The axis is x: regrouping subtracts 70 from Izz = 70 and from Iyy = 80.
  CHECK(second.inertia[0].is_equal(90));
  CHECK(second.inertia[1].is_equal(10));
  CHECK(second.inertia[2].is_zero());
  for (const char* output : {"kinetic_energy", "mass_matrix", "inverse_dynamics"}) {
    CHECK(system.agrees(output));
  }
}

TEST_CASE("bodies with symbolic inertias are not regrouped", "[regroup]") {
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

TEST_CASE("for quaternions of any length T, momentum, forces and M stay consistent", "[frames]") {
  CHECK(error_off_sphere(flying(hull)) < 1e-40);
  CHECK(error_off_sphere(flying(hull + R"toml([[frame]]
name = "mount"
parent = "hull"
translate = ["c", "0", "b"]
[[body]]
name = "load"
frame = "mount"
mass = "3*m"
com = ["0", "c", "0"]
inertia = ["J", "J", "J"]
)toml")) < 1e-40);
  // A joint follows the rotation.
  CHECK(error_off_sphere(flying("[[coordinate]]\nname = \"y\"\n" + hull + R"toml([[frame]]
name = "arm"
parent = "hull"
translate = ["c", "0", "b"]
rotate = [["y", "y"]]
[[body]]
name = "load"
frame = "arm"
mass = "3*m"
com = ["0", "c", "0"]
inertia = ["J", "J", "J"]
)toml")) < 1e-40);
}
