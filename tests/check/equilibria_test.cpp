// Declared equilibria of a model: their data in the Model, refusals, and scenes that expand about
// an equilibrium by its name.
#include <catch2/catch.hpp>

#include "check_testing.hpp"

namespace elgen::test {

namespace {

/// A model without units; `more` are keys of the equilibrium `rest`.
std::string sliding(const std::string& more) {
  return R"toml(format = 1
[model]
name = "sliding"
[[coordinate]]
name = "x"
[[coordinate]]
name = "angle"
[parameters]
m = 1
g = 2
R = 3
[energy]
T = "1/2*m*(dot(x)^2 + dot(angle)^2)"
[[input]]
name = "u"
on = "x"
[[equilibrium]]
name = "rest"
)toml" + more;
}

std::string equilibrium_of(const std::string& more) {
  return dump_lines(sliding(more), "equilibrium");
}

CheckOptions about_rest(const std::string& more = {}) {
  CheckOptions wanted;
  wanted.scene =
      "format = 1\nmodel = \"sliding.toml\"\nname = \"near\"\n[approximate]\norder = 1\n"
      "about = \"rest\"\n" +
      more;
  return wanted;
}

/// The messages about an equilibrium in a model with units; `more` starts on line 19.
std::string equilibrium_messages(const std::string& more) {
  return messages(block("V = \"1/2*k*x^2\"\n[[input]]\nname = \"u\"\nunit = \"N\"\non = \"x\"\n"
                        "[[equilibrium]]\nname = \"rest\"\n") +
                  more);
}

}  // namespace

TEST_CASE("an equilibrium has a point, a condition and squared frequencies") {
  CHECK(equilibrium_of("at = { angle = \"acos(g/R)\" }\nwhen = \"g < R\"\n"
                       "inputs = { u = \"m*g\" }\nfrequencies_squared = [\"0\", \"g/R\"]\n") ==
        "equilibrium rest at angle = acos(g/R), u = m*g where R - g > 0, [0, g/R]\n");
  CHECK(equilibrium_of("at = { x = 0, angle = \"pi\" }\nwhen = \"g >= 2*R\"\n") ==
        "equilibrium rest at x = 0, angle = pi where g - 2*R >= 0, []\n");
  const Model model = checked(sliding("at = {}\nwhen = \" m  >g\"\ndoc = \"anywhere\"\n")).model;
  REQUIRE(model.equilibria.size() == 1);
  CHECK(model.equilibria[0].coordinates.size() == 2);
  CHECK(model.equilibria[0].inputs.size() == 1);
  CHECK(model.equilibria[0].condition->text == "m >g");
  CHECK(model.equilibria[0].doc == "anywhere");
  CHECK(covered_text(model.equilibria[0].span) == "rest");
}

TEST_CASE("names of equilibria are unique") {
  const std::string another = "at = {}\n[[equilibrium]]\nname = \"x\"\nat = { x = 1 }\n";
  CHECK(equilibrium_of(another) == "equilibrium rest at , []\nequilibrium x at x = 1, []\n");
}

TEST_CASE("refused equilibria") {
  check_rows(
      {
          {"at = { y = 0 }\n", "E612 19:8 `y` is no coordinate\n"},
          {"at = { u = 0 }\n", "E612 19:8 `u` is no coordinate\n"},
          {"at = {}\ninputs = { x = 0 }\n", "E201 20:12 `x` is no input\n"},
          {"at = { x = \"x\" }\n",
           "E319 19:13 `x` is a coordinate, but a value of `at` takes none\n"},
          {"at = { x = \"m\" }\n", "E403 19:13 `m` is in kg, but a value of `at` is in m\n"},
          {"at = {}\nwhen = \"k > m\"\n", "E401 20:13 `m` is in kg, but the sum is in kg/s^2\n"},
          {"at = {}\nwhen = \"t > 0\"\n", "E319 20:9 `t` is time, but a condition takes none\n"},
          {"at = {}\nfrequencies_squared = [\"k\"]\n",
           "E403 20:25 `k` is in kg/s^2, but a squared frequency is in 1/s^2\n"},
          {"at = {}\nfrequencies_squared = [\"k/m\", \"k/m\"]\n",
           "E517 20:23 2 values, but the model has 1 velocity\n"},
      },
      equilibrium_messages);
}

TEST_CASE("a scene expands about an equilibrium by its name") {
  const std::string tilted =
      sliding("at = { angle = \"acos(g/R)\" }\ninputs = { u = 1 }\nwhen = \"R > g\"\n");
  CHECK(dump_lines(tilted, "approximate", about_rest()) ==
        "approximate order 1 about angle = acos(g/R), u = 1 where R - g > 0 with angle small\n");
}

TEST_CASE(
    "locked coordinates keep the value of the lock, and equilibria belong to the whole model") {
  const std::string still = sliding("at = { x = 0, angle = 0 }\n");
  const CheckOptions wanted = about_rest("[lock]\nx = { value = 1 }\n");
  CHECK(dump_lines(still, "approximate", wanted) ==
        "approximate order 1 about angle = 0 with angle small\n");
  CHECK(checked(still, wanted).model.equilibria.empty());
}

}  // namespace elgen::test
