// [approximate]: names, orders and values.
#include <catch2/catch.hpp>

#include "check/scene/scene.hpp"
#include "check_testing.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

const std::string two_angles = R"toml(format = 1
[model]
name = "two"
[[coordinate]]
for = "i in 1..2"
name = "q[i]"
unit = "rad"
[[coordinate]]
name = "x"
unit = "m"
[parameters]
m = { value = 1, unit = "kg" }
h = { value = 1, unit = "m" }
[energy]
T = "1/2*m*(dot(x)^2 + h^2*(dot(q[1])^2 + dot(q[2])^2))"
[[input]]
name = "F"
unit = "N"
on = "x"
)toml";

Wanted near(const std::string& lines) {
  Wanted wanted;
  wanted.scene =
      "format = 1\nmodel = \"two.toml\"\nname = \"near\"\n[approximate]\n" + lines + "\n";
  return wanted;
}

std::string said(const std::string& lines) {
  std::string text = messages(two_angles, near(lines));
  if (!text.empty()) text.pop_back();  // the last end of line
  return text;
}

std::string approximation(const std::string& lines) {
  return dumped(two_angles, "approximate", near(lines));
}

}  // namespace

TEST_CASE("a whole array, an element, a coordinate and an input may be given") {
  CHECK(approximation("order = 2\nabout = { q = 0, x = \"h/2\", F = 3 }") ==
        "approximate order 2 about q[1] = 0, q[2] = 0, x = h/2, F = 3 with q[1], q[2], x small\n");
  CHECK(approximation("order = 1\nabout = { \"q[2]\" = \"pi\" }") ==
        "approximate order 1 about q[2] = pi with q[2] small\n");
  CHECK(approximation("order = 1\nabout = { x = 0, q = 0 }\nsmall = [\"q[1]\"]") ==
        "approximate order 1 about q[1] = 0, q[2] = 0, x = 0 with q[1] small\n");
}

TEST_CASE("inputs are small where every coordinate is") {
  CHECK(checked(two_angles, near("order = 1\nabout = { q = 0, x = 0 }"))
            .model.approximation->small_inputs);
  CHECK_FALSE(
      checked(two_angles, near("order = 1\nabout = { q = 0 }")).model.approximation->small_inputs);
}

TEST_CASE("orders are 1 to 5") {
  CHECK(said("order = 0\nabout = { x = 0 }") == "E614 5:9 order `0` is not one of 1 to 5");
  CHECK(said("order = 6\nabout = { x = 0 }") == "E614 5:9 order `6` is not one of 1 to 5");
}

TEST_CASE("what is small is a coordinate with a value") {
  CHECK(said("order = 1\nabout = { y = 0 }") == "E614 6:11 `y` is no coordinate or input");
  CHECK(said("order = 1\nabout = { x = 0 }\nsmall = [\"q[1]\"]") ==
        "E614 7:11 `q[1]` is small, but about what? | give its value in `about`");
  CHECK(said("order = 1\nabout = { F = 0 }") ==
        "E614 6:1 no coordinate is small | `about` gives the coordinates that are");
}

TEST_CASE("values are made of parameters, with the unit of what they are values of") {
  CHECK(said("order = 1\nabout = { x = \"t\" }").substr(0, 9) == "E319 6:16");
  CHECK(said("order = 1\nabout = { x = \"m\" }").substr(0, 9) == "E403 6:16");
}
