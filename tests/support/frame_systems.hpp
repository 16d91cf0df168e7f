// Small systems of frames that together cover every kind of step, of body and of load.
#pragma once

#include "support/arms.hpp"

namespace elgen::test {

/// A carriage on a slanted rail with a rotating arm. Masses slide in frames, and forces act on
/// sliding points.
inline const std::string& sliders_text() {
  static const std::string text = frame_model("sliders", "x q s", R"toml(
[[frame]]
name = "carriage"
parent = "world"
rpy = ["0.1", "-0.2", "0.3"]
[[frame]]
name = "cabin"
parent = "carriage"
translate = ["x", "x/3", "l"]
[[frame]]
name = "arm"
parent = "cabin"
translate = ["0", "l/2", "l/4"]
rotate = [["y", "q"]]
[[body]]
name = "hull"
frame = "cabin"
mass = "m1"
com = ["l/5", "0", "l/7"]
inertia = ["A", "B", "C", "D", "E", "F"]
[[body]]
name = "boom"
frame = "arm"
mass = "m2"
com = ["l/2", "l/8", "l/5"]
inertia = ["A", "B", "C", "E", "D", "F"]
[[point]]
name = "bead"
frame = "arm"
at = ["s", "s^2/3", "l/8"]
mass = "m2/3"
[[point]]
name = "nozzle"
frame = "arm"
at = ["2*s", "l/6", "s*q"]
[[point]]
name = "hook"
frame = "cabin"
at = ["l", "l/3", "0"]
[[point]]
name = "pendant"
at = ["x(nozzle) + l", "y(hook)*q", "z(nozzle)"]
mass = "m1/4"
[[input]]
name = "u"
[[force]]
at = "nozzle"
from = "hook"
in = "arm"
value = ["u", "2*u", "l - u/2"]
[[force]]
at = "hook"
value = ["u", "l", "dot(q)"]
[[force]]
on = "q"
value = "-dot(q)/3"
[[output]]
name = "where"
value = ["x(bead)", "y(nozzle)*s", "z(pendant)"]
jacobian = true
)toml");
  return text;
}

/// A table that rotates at a prescribed rate, an oblique constant axis, and an angle that is a sum.
inline const std::string& turntable_text() {
  static const std::string text = frame_model("turntable", "q1 q2", R"toml(
[[frame]]
name = "fork"
parent = "disc"
translate = ["l/2", "l/7", "t*l/9"]
rotate = [[["1", "2", "2"], "q1"]]
[[frame]]
name = "disc"
parent = "world"
rotate = [["z", "Omega*t"]]
[[frame]]
name = "rotor"
parent = "fork"
translate = ["l/5", "0", "l/3"]
rotate = [["x", "pi/3"], [["-1", "0", "1"], "2*q1 + q2"]]
[[body]]
name = "fork_body"
frame = "fork"
mass = "m1"
com = ["l/6", "l/5", "l/4"]
inertia = ["A", "B", "C", "D", "E", "F"]
[[body]]
name = "rotor_body"
frame = "rotor"
mass = "m2"
com = ["l/9", "l/8", "-l/4"]
inertia = ["C", "B", "A", "F", "D", "E"]
[[output]]
name = "eye"
frame = "rotor"
jacobian = true
[[output]]
name = "eye_own"
frame = "rotor"
axes = "rotor"
jacobian = true
)toml");
  return text;
}

/// A quaternion of any length that depends on coordinates, a constant quaternion, and nonlinear
/// angles.
inline const std::string& quaternion_text() {
  static const std::string text = frame_model("quaternion", "q1 q2 q3", R"toml(
[[frame]]
name = "ship"
parent = "world"
translate = ["0", "q1", "l"]
quaternion = ["1", "q1", "q2 + t/5", "0.3"]
[[frame]]
name = "mast"
parent = "ship"
translate = ["l/5", "0", "l/3"]
quaternion = ["2", "1", "-1", "0.5"]
[[frame]]
name = "yard"
parent = "mast"
translate = ["sin(q2)", "0", "l"]
rotate = [["x", "q3*q2"], ["z", "q3"]]
[[body]]
name = "hull"
frame = "ship"
mass = "m1"
com = ["l/6", "l/5", "l/4"]
inertia = ["A", "B", "C", "D", "E", "F"]
[[body]]
name = "boom"
frame = "yard"
mass = "m2"
com = ["l/9", "l/8", "-l/4"]
inertia = ["C", "B", "A", "F", "D", "E"]
[[input]]
name = "u"
[[force]]
frame = "yard"
from = "ship"
value = ["u", "l", "-u"]
[[output]]
name = "top"
frame = "yard"
axes = "yard"
jacobian = true
)toml");
  return text;
}

/// A rigid body with a unit quaternion as attitude and an input force along x.
inline const std::string& tumbler_text() {
  static const std::string text = model_text("tumbler", R"toml(
[[coordinate]]
name = "x"
[[coordinate]]
name = "attitude"
kind = "rotation"
[parameters]
m = 2
A = 3
B = 4
C = 5
[[frame]]
name = "body"
parent = "world"
translate = ["x", "0", "0"]
rotation = "attitude"
[[body]]
name = "stone"
frame = "body"
mass = "m"
inertia = ["A", "B", "C"]
[[input]]
name = "u"
on = "x"
)toml");
  return text;
}

/// A frame and a body attached at a point of another frame, which nothing else uses.
inline const std::string& hung_text() {
  static const std::string text = frame_model("hung", "q r", R"toml(
[[frame]]
name = "arm"
parent = "world"
rotate = [["z", "q"]]
[[point]]
name = "tip"
frame = "arm"
at = ["l", "l/3", "0"]
[[point]]
name = "elbow"
frame = "arm"
at = ["l/2", "0", "l/5"]
[[frame]]
name = "rope"
parent = "world"
translate = ["x(tip)", "y(tip)", "l"]
rotate = [["x", "r"]]
[[body]]
name = "bucket"
frame = "rope"
mass = "m1"
com = ["l/9", "0", "-l"]
inertia = ["A", "B", "C"]
[[body]]
name = "lamp"
mass = "m2"
com = ["x(elbow)", "y(elbow) + r", "z(elbow)"]
inertia = ["A", "B", "C"]
spin = ["dot(q)*x(elbow)", "dot(r)", "dot(q)"]
[[output]]
name = "bottom"
frame = "rope"
jacobian = true
)toml");
  return text;
}

inline const std::vector<NamedText>& frame_systems() {
  static const std::vector<NamedText> all{
      {"two_turns", two_turns_text()},   {"three_turns", three_turns_text()},
      {"sliders", sliders_text()},       {"turntable", turntable_text()},
      {"quaternion", quaternion_text()}, {"two_arms", two_arms_text()},
      {"planar", planar_text()},         {"hung", hung_text()}};
  return all;
}

}  // namespace elgen::test
