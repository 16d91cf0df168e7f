// Dumps: one line per entry, the same in every process.
#include <catch2/catch.hpp>

#include "check_testing.hpp"

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
inertia_about = "origin"
)toml";
  CHECK(dumped(model, "coordinate") == "coordinate q, range 0 to 1, armature J, singular sin(q)\n");
  CHECK(dumped(model, "body") ==
        "body b, mass J, com [cos(q), sin(q)], inertia [J], spin [dot(q)], about origin\n");
}

TEST_CASE("a scene is dumped with what it wants") {
  Wanted wanted;
  wanted.outputs = {"bias"};
  wanted.fixed = {"k"};
  CHECK(dump(checked(block(), wanted).scene) ==
        "scene full\nbase name block\nnamespace block\nlanguage c++17, row-major\nfixed parameter "
        "1 = 2\noutput bias 1 1\n");
}

}  // namespace
}  // namespace elgen::test
