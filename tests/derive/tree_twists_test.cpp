// Momenta and kinetic energies by twists against the oracle, which sees bodies in the world.
#include "derive/tree/tree_twists.hpp"

#include <catch2/catch.hpp>

#include "framed.hpp"

using namespace elgen;
using namespace elgen::test;

TEST_CASE("momenta and kinetic energies of frames", "[frames]") {
  for (const auto& [name, text] : frame_systems()) {
    Framed system(text);
    for (const char* output :
         {"momentum", "position_gradient", "kinetic_energy", "energy_function"}) {
      INFO(name << " " << output);
      CHECK(system.agrees(output));
    }
  }
}

namespace {

/// A flying body, its centre of mass off the origin; and one with an arm of a turn and a slide.
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

/// The largest |momentum - M v|, and |tau(a) - tau(0) - M a|, with quaternions of length 1.1.
double off_the_sphere(const std::string& text) {
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

TEST_CASE("off the unit sphere T, momentum, forces and M are one function still", "[frames]") {
  CHECK(off_the_sphere(flying(hull)) < 1e-40);
  CHECK(off_the_sphere(flying(hull + R"toml([[frame]]
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
}

TEST_CASE("and so they are with joints behind the rotation", "[frames]") {
  CHECK(off_the_sphere(flying("[[coordinate]]\nname = \"y\"\n" + hull + R"toml([[frame]]
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
