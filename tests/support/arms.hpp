// Arms of frames with consecutive rotations: in space, in the plane, and on a common base.
#pragma once

#include "support/systems.hpp"

namespace elgen::test {

/// Parameters without units that several arms share.
inline const std::string& frame_parameters() {
  static const std::string text = R"toml(
[parameters]
m1 = 2
m2 = "3/2"
l = "7/10"
A = "3/10"
B = "2/5"
C = "1/2"
D = "1/20"
E = "3/100"
F = "-1/50"
Omega = "2/5"
g = 9.81
[gravity]
vector = ["g/10", "-g/7", "-g"]
)toml";
  return text;
}

inline std::string frame_model(const std::string& name, const std::string& coordinates,
                               const std::string& rest) {
  std::string text;
  std::string word;
  for (const char letter : coordinates + " ") {
    if (letter != ' ') {
      word += letter;
      continue;
    }
    text += "[[coordinate]]\nname = \"" + word + "\"\n";
    word.clear();
  }
  return model_text(name, text + frame_parameters() + rest);
}

/// Two rotations about crossed axes with offsets; bodies with general inertia, one of them about
/// its origin.
inline const std::string& two_turns_text() {
  static const std::string text = frame_model("two_turns", "q1 q2", R"toml(
[[frame]]
name = "upper"
parent = "world"
translate = ["l/3", "l/5", "l"]
rotate = [["z", "q1"], ["x", "pi/2"]]
[[frame]]
name = "lower"
parent = "upper"
translate = ["l", "l/7", "-l/4"]
rotate = [["z", "q2"]]
[[body]]
name = "arm"
frame = "upper"
mass = "m1"
com = ["l/2", "l/9", "l/8"]
inertia = ["A", "B", "C", "D", "E", "F"]
[[body]]
name = "hand"
frame = "lower"
mass = "m2"
com = ["l/6", "-l/9", "l/4"]
inertia = ["2*A", "2*B", "2*C", "E", "F", "D"]
inertia_about = "origin"
[[output]]
name = "tool"
frame = "lower"
jacobian = true
[[output]]
name = "tool_own"
frame = "lower"
axes = "lower"
jacobian = true
)toml");
  return text;
}

/// Three rotations by Denavit-Hartenberg parameters, with torques between neighbours.
inline const std::string& three_turns_text() {
  static const std::string text = frame_model("three_turns", "q1 q2 q3", R"toml(
[[frame]]
name = "link1"
parent = "world"
dh = { convention = "modified", d = "l", theta = "q1" }
[[frame]]
name = "link2"
parent = "link1"
dh = { convention = "modified", a = "l/5", alpha = "-pi/2", d = "l/9", theta = "q2" }
[[frame]]
name = "link3"
parent = "link2"
dh = { convention = "standard", a = "l/3", alpha = "0.3", d = "l/6", theta = "q3 + pi/2" }
[[body]]
name = "body1"
frame = "link1"
mass = "m1"
com = ["l/9", "0", "-l/5"]
inertia = ["A", "B", "C"]
[[body]]
name = "body2"
frame = "link2"
mass = "m2"
com = ["l/2", "l/8", "0"]
inertia = ["A", "A", "B", "D", "0", "F"]
[[body]]
name = "body3"
frame = "link3"
mass = "m2"
com = ["-l/2", "l/8", "l/7"]
inertia = ["C", "A", "B", "D", "E", "F"]
[[input]]
name = "u1"
[[input]]
name = "u2"
[[force]]
frame = "link2"
from = "link1"
value = ["0", "0", "u1"]
[[force]]
frame = "link3"
from = "link2"
in = "world"
value = ["u2", "u1/3", "l"]
[[output]]
name = "tool"
frame = "link3"
jacobian = true
)toml");
  return text;
}

/// Two arms with two rotations each on a sliding base; a spring given as an energy, and a body
/// without a frame.
inline const std::string& two_arms_text() {
  static const std::string text = frame_model("two_arms", "x a1 a2 b1 b2", R"toml(
[[frame]]
name = "base"
parent = "world"
translate = ["x", "0", "0"]
[[frame]]
for = "i in 1..2"
name = "a[i]"
parent = "base"
translate = ["0", "i*l", "0"]
rotate = [["z", "a1 + (i-1)*a2"]]
[[frame]]
name = "left"
parent = "base"
translate = ["l/3", "l/5", "l/4"]
rotate = [["z", "b1"]]
[[frame]]
name = "left_hand"
parent = "left"
translate = ["l", "0", "l/4"]
rotate = [["y", "b2"]]
[[body]]
name = "trunk"
frame = "base"
mass = "m1"
com = ["l/9", "0", "l/8"]
[[body]]
for = "i in 1..2"
name = "right[i]"
frame = "a[i]"
mass = "m1"
com = ["l/3", "l/9", "0"]
inertia = ["A", "B", "C", "D", "E", "F"]
[[body]]
name = "left_body"
frame = "left"
mass = "m2"
com = ["l/3", "l/9", "0"]
inertia = ["A", "B", "C"]
[[body]]
name = "left_hand_body"
frame = "left_hand"
mass = "m2"
com = ["l/3", "l/9", "l/7"]
inertia = ["A", "C", "C", "D", "0", "0"]
[[point]]
name = "weight"
at = ["x + l*sin(a2)", "l*cos(b2)", "x*a1"]
mass = "m2"
[energy]
T = "A*dot(a1)*dot(b2)/9"
V = "C*(a1 - b1)^2/2"
D = "C*dot(a1)^2/2"
)toml");
  return text;
}

/// A planar model: vectors have two components, and frames rotate about z.
inline const std::string& planar_text() {
  static const std::string text = model_text("planar", R"toml(
[[coordinate]]
name = "q1"
[[coordinate]]
name = "q2"
[parameters]
m = 2
l = "7/10"
J = "3/10"
g = 9.81
[gravity]
vector = ["0", "-g"]
[[frame]]
name = "upper"
parent = "world"
rotate = [["z", "q1"]]
[[frame]]
name = "lower"
parent = "upper"
translate = ["l", "l/9"]
rotate = [["z", "q2"]]
[[body]]
name = "arm"
frame = "upper"
mass = "m"
com = ["l/2", "l/7"]
inertia = "J"
inertia_about = "origin"
[[body]]
name = "hand"
frame = "lower"
mass = "m/3"
com = ["l/3", "0"]
inertia = "J/2"
[[input]]
name = "u"
[[force]]
frame = "lower"
from = "upper"
value = "u"
[[point]]
name = "tip"
frame = "lower"
at = ["l", "q2"]
[[force]]
at = "tip"
in = "lower"
value = ["1", "u"]
[[output]]
name = "tool"
frame = "lower"
jacobian = true
)toml");
  return text;
}

}  // namespace elgen::test
