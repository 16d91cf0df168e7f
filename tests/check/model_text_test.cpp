// Texts of models and scenes: one line per entry, the same in every process.
#include <catch2/catch.hpp>

#include "check_testing.hpp"
#include "model_text.hpp"

namespace elgen::test {
namespace {

TEST_CASE("a model is dumped entry by entry") {
  CHECK(
      dump(checked(
               block("V = \"1/2*k*x^2\"\nD = \"0\"\n[gravity]\nvector = [\"0\", \"0\"]\n"
                     "[[input]]\nname = \"u\"\nunit = \"N\"\non = \"x\"\nlimits = [-1, \"1/2\"]\n"))
               .model) ==
      "model block\n"
      "coordinate x [m]\n"
      "parameter m = 1 [kg]\n"
      "parameter k = 2 [kg/s^2]\n"
      "input u [N], limits -1 to 1/2, on x\n"
      "gravity [0, 0, 0]\n"
      "energy T = 1/2*m*dot(x)^2\n"
      "energy V = 1/2*k*x^2\n"
      "energy D = 0\n"
      "quadratic yes\n"
      "time no\n"
      "drift no\n");
}

TEST_CASE("bodies, armatures and singular charts are dumped") {
  const std::string model = R"toml(format = 1
[model]
name = "a"
[[coordinate]]
name = "q"
armature = "J"
singular = "sin(q)"
range = [0, 1]
[parameters]
J = 1
[[body]]
name = "b"
mass = "J"
com = ["cos(q)", "sin(q)"]
spin = "dot(q)"
inertia = "J"
)toml";
  CHECK(dumped(model, "coordinate") == "coordinate q, range 0 to 1, armature J, singular sin(q)\n");
  CHECK(dumped(model, "body") ==
        "body b, mass J, com [cos(q), sin(q)], inertia [J], spin [dot(q)]\n");
}

TEST_CASE("frames, rotations and torques are dumped") {
  const std::string model = R"toml(format = 1
[model]
name = "a"
[[coordinate]]
name = "q"
unit = "rad"
[[coordinate]]
name = "attitude"
kind = "rotation"
[parameters]
J = { value = 1, unit = "kg*m^2", assume = "positive", min = 0, max = 2 }
l = { value = 2, unit = "m" }
[[frame]]
name = "A"
parent = "world"
translate = ["l", "0", "0"]
rotate = [["z", "q"]]
[[frame]]
name = "B"
parent = "A"
rotation = "attitude"
[[frame]]
name = "C"
parent = "B"
quaternion = ["cos(q/2)", "0", "sin(q/2)", "0"]
[[body]]
name = "b"
frame = "C"
inertia = ["J", "J", "J"]
[energy]
T = "1/2*J*dot(q)^2"
[[force]]
frame = "B"
from = "A"
in = "B"
value = ["J*dot(q)^2", "0", "0"]
[[output]]
name = "pose"
frame = "A"
axes = "A"
)toml";
  CHECK(dumped(model, "rotation") == "rotation attitude\n");
  CHECK(dumped(model, "parameter J") == "parameter J = 1 [kg*m^2], range 0 to 2, positive\n");
  CHECK(dumped(model, "frame") ==
        "frame A on world, moved by [l, 0, 0], turned by q about [0, 0, 1]\n"
        "frame B on A, turned by attitude\n"
        "frame C on B, turned by [cos(q/2), 0, sin(q/2), 0]\n");
  CHECK(dumped(model, "force") == "force  on B from A = [J*dot(q)^2, 0, 0]\n");
  CHECK(dumped(model, "output").rfind("output pose of A = [", 0) == 0);
  CHECK(dumped(model, "output").find(", in its axes\n") != std::string::npos);
}

TEST_CASE("what a scene holds and expands is dumped with the model") {
  const std::string two = block("[[coordinate]]\nname = \"y\"\nunit = \"m\"\narmature = \"m\"\n");
  Wanted wanted;
  wanted.scene =
      "format = 1\nmodel = \"block.toml\"\nname = \"held\"\n"
      "[lock]\nx = { value = \"0.1*sin(t)\", reaction = true }\n";
  CHECK(dumped(two, "lock", wanted) == "lock x = 1/10*sin(t), reaction\n");
  wanted.scene =
      "format = 1\nmodel = \"block.toml\"\nname = \"near\"\n"
      "[approximate]\norder = 2\nabout = { y = 0 }\n";
  CHECK(dumped(two, "approximate", wanted) == "approximate order 2 about y = 0 with y small\n");
}

TEST_CASE("a scene is dumped with what it wants") {
  Wanted wanted;
  wanted.outputs = {"bias"};
  wanted.fixed = {"k"};
  CHECK(dump(checked(block(), wanted).scene) ==
        "scene full\nbase name block\nnamespace block\nlanguage c++17, row-major\nfixed parameter "
        "1 = 2\noutput bias 1 1\nscalar double\n");
  wanted.scene =
      "format = 1\nmodel = \"block.toml\"\nname = \"fast\"\n"
      "[numeric]\nscalar = [\"float\", \"double\"]\nform = \"closed\"\n";
  const std::string text = dump(checked(block(), wanted).scene);
  CHECK(text.find("output bias 1 1, closed\nscalar float\nscalar double\n") != std::string::npos);
}

TEST_CASE("what a scene does without is dumped with the reason") {
  const std::string text =
      dump(checked(block("[[force]]\non = \"x\"\nvalue = \"-k*abs(x)\"\n")).scene);
  CHECK(text.find("left out linearization, kinked force\n") != std::string::npos);
  CHECK(text.find("left out mass_matrix") == std::string::npos);
}

}  // namespace
}  // namespace elgen::test
