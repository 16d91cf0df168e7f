// Articulated bodies agree with elimination of M. The method does not apply to every system.
#include "derive/tree/articulated.hpp"

#include <catch2/catch.hpp>

#include "derive/outputs/outputs.hpp"
#include "framed.hpp"
#include "support/links.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// A boom on a turntable, a carriage on a parabolic rail of the boom, and a reel that has an
/// armature and rotates about an oblique axis. Also a spring, damping, and a lamp on its own limb.
const std::string& crane_text() {
  static const std::string text = frame_model("crane", "q r s p", R"toml(
[[input]]
name = "u"
[[frame]]
name = "table"
parent = "world"
rotate = [["z", "Omega*t"]]
[[frame]]
name = "boom"
parent = "table"
translate = ["l/2", "l/7", "t*l/9"]
rotate = [["x", "pi/2"], ["z", "2*q"]]
[[frame]]
name = "carriage"
parent = "boom"
translate = ["r", "r^2/3", "l"]
[[frame]]
name = "reel"
parent = "carriage"
translate = ["l/5", "0", "l/3"]
rotate = [["x", "pi/3"], [["1", "2", "2"], "s"]]
[[frame]]
name = "lamp"
parent = "boom"
translate = ["l/5", "l/6", "0"]
rotate = [["y", "p + t/3"]]
[[body]]
name = "boom_body"
frame = "boom"
mass = "m1"
com = ["l/6", "l/5", "l/4"]
inertia = ["A", "B", "C", "D", "E", "F"]
[[body]]
name = "carriage_body"
frame = "carriage"
mass = "m2"
com = ["l/9", "l/8", "-l/4"]
[[body]]
name = "reel_body"
frame = "reel"
mass = "m2"
com = ["l/9", "l/8", "-l/4"]
inertia = ["C", "B", "A", "F", "D", "E"]
[[body]]
name = "lamp_body"
frame = "lamp"
mass = "m1/3"
com = ["l/4", "0", "-l/9"]
inertia = ["A", "A", "B", "0", "E", "0"]
inertia_about = "origin"
[[force]]
frame = "reel"
from = "boom"
value = ["u", "l", "-u"]
[energy]
T = "(A + B*q^2)*dot(q)^2/2 + C*dot(s)^2 + D*dot(p)"
V = "C*(q - s)^2/2 + D*r^2*p"
D = "C*(dot(q) - dot(p))^2/2"
)toml");
  return text;
}

/// A free body with two arms: one rotates and slides, the other only rotates.
const std::string& flyer_text() {
  static const std::string text = model_text("flyer", R"toml(
[[coordinate]]
name = "x"
[[coordinate]]
name = "y"
[[coordinate]]
name = "z"
[[coordinate]]
name = "e"
kind = "rotation"
[[coordinate]]
name = "q"
[[coordinate]]
name = "s"
[[coordinate]]
name = "p"
)toml" + frame_parameters() + R"toml(
[[frame]]
name = "hull"
parent = "world"
translate = ["x", "y", "z + x/5"]
rotation = "e"
[[frame]]
name = "arm"
parent = "hull"
translate = ["l", "l/2", "0"]
rotate = [["y", "q"]]
[[frame]]
name = "hand"
parent = "arm"
translate = ["0", "l/2 + s", "s/3"]
[[frame]]
name = "rotor"
parent = "hull"
translate = ["-l", "l/5", "0"]
rotate = [["z", "p"]]
[[body]]
name = "hull_body"
frame = "hull"
mass = "m1"
com = ["l/9", "l/8", "l/7"]
inertia = ["A", "B", "C", "D", "E", "F"]
[[body]]
name = "arm_body"
frame = "arm"
mass = "m2"
com = ["l/6", "l/5", "l/4"]
inertia = ["B", "B", "C"]
[[body]]
name = "hand_body"
frame = "hand"
mass = "m2/2"
com = ["l/6", "0", "l/4"]
inertia = ["C", "B", "B"]
[[body]]
name = "rotor_body"
frame = "rotor"
mass = "m2/5"
com = ["l/8", "0", "0"]
inertia = ["A", "A", "B"]
[[input]]
name = "u"
on = "p"
)toml");
  return text;
}

Lagrangian limbs_first(const std::string& text) {
  Lagrangian lagrangian = Framed(text).lagrangian;
  lagrangian.eliminates_last_first = true;
  return lagrangian;
}

/// A state with unit quaternions.
State normalised_state(const CheckedModel& checked, int sample) {
  State state = some_state(checked, sample);
  for (const Rotation& rotation : checked.model.rotations) {
    for (std::uint32_t i = 0; i < quaternion_size; ++i) {
      state.q[rotation.first_coordinate + i] = cln::cl_RA(i == 0 ? 1 : 1 << ((i + 1) / 2)) / 5;
    }
  }
  return state;
}

bool applies(const std::string& text) {
  Derivation derivation(limbs_first(text));
  return articulated_dynamics(derivation).has_value();
}

std::size_t definitions_of_chain(int links) {
  Derivation derivation(limbs_first(links_text(links)));
  REQUIRE(articulated_dynamics(derivation));
  return derivation.definitions.list.size();
}

}  // namespace

TEST_CASE("articulated bodies give the solution and pivots of elimination", "[frames]") {
  for (const std::string& text :
       {read_model("two_turns"), read_model("three_turns"), read_model("tumbler"), crane_text(),
        flyer_text(), links_text(5)}) {
    const Framed system(text);
    INFO(system.checked.model.name);
    Derivation derivation(limbs_first(text));
    const ForwardDynamics expected = forward_dynamics(derivation);
    const auto found = articulated_dynamics(derivation);
    REQUIRE(found);
    for (const int sample : {1, 2}) {
      const NumbersAt at(derivation.symbols, derivation.definitions,
                         normalised_state(system.checked, sample));
      CHECK(nearly_equal(at(found->solution.acceleration), at(expected.acceleration)));
      CHECK(nearly_equal(at(found->solution.relative_pivots), at(expected.relative_pivots)));
      CHECK(nearly_equal(at(found->solution.diagonal), at(expected.diagonal)));
    }
    CHECK(found->solution.multipliers.empty());
  }
}

TEST_CASE("the pivot of the last joint is exactly 1", "[frames]") {
  for (const std::string& text : {read_model("two_turns"), links_text(3), crane_text()}) {
    Derivation derivation(limbs_first(text));
    CHECK(articulated_dynamics(derivation)->solution.relative_pivots.back().is_equal(1));
  }
}

TEST_CASE("articulated bodies do not apply to every Lagrangian", "[frames]") {
  CHECK_FALSE(applies(read_model("quaternion")));  // a rotation by a quaternion of coordinates
  CHECK_FALSE(applies(read_model("turntable")));   // q1 rotates two frames
  CHECK_FALSE(
      applies(read_model("two_arms")));         // T couples rates, and a mass is outside the frames
  CHECK_FALSE(applies(read_model("sliders")));  // a mass is outside the frames
  // M of this model is eliminated first to last; articulated bodies have pivots from last to first.
  Derivation derivation(Framed(read_model("three_turns")).lagrangian);
  CHECK_FALSE(articulated_dynamics(derivation));
}

TEST_CASE("the joints of a tree must come after the joints that carry them", "[frames]") {
  Derivation derivation(Framed(links_text(2)).lagrangian);
  const auto joints = tree_joints(tree_of(derivation));
  REQUIRE(joints);
  CHECK(joints->at(0).transform < joints->at(1).transform);
  Derivation other(Framed(links_text(2, true)).lagrangian);
  CHECK_FALSE(tree_joints(tree_of(other)));
}

TEST_CASE("the number of definitions of articulated bodies is linear in the length of a chain",
          "[frames]") {
  const std::size_t few = definitions_of_chain(10);
  const std::size_t more = definitions_of_chain(20);
  const std::size_t many = definitions_of_chain(40);
  // 5 % margin above linear growth, because the first links have fewer degrees of freedom.
  CHECK(20 * (many - more) <= 42 * (more - few));
}

TEST_CASE("the factorisation of a chain takes d (d + 2) operations for each joint with d carriers",
          "[frames]") {
  Derivation derivation(limbs_first(links_text(4)));
  KinematicTree& tree = tree_of(derivation);
  CHECK(count_factorisation_operations(tree, *tree_joints(tree)) == 3 + 8 + 15);
}
