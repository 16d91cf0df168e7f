// Changes of the interface of generated code, as callers see them.
#include <catch2/catch.hpp>

#include "diff/versions.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// One line for each change, such as "word: text".
std::string interface_text(const std::string& before, const std::string& after,
                           const std::string& old_scene = {}, const std::string& new_scene = {},
                           const Renames& renames = {}) {
  const LoweredVersion old = lowered(before, old_scene);
  const LoweredVersion now = lowered(after, new_scene);
  std::string text;
  for (const InterfaceChange& change : interface_changes(old.version(), now.version(), renames)) {
    text += std::string(impact_row(change.impact).word) + ": " + change.text + "\n";
  }
  return text;
}

const std::string silent = "callers still compile but with another meaning\n";

}  // namespace

TEST_CASE("the same interface has no changes") {
  CHECK(interface_text(spring(), spring("k*x^4")).empty());
}

TEST_CASE("another order of members changes the meaning silently") {
  CHECK(interface_text(spring(),
                       replaced(replaced(spring(), "k = 3\n", ""), "m = {", "k = 3\nm = {")) ==
        "breaks: the members of Parameters changed their order: m, k -> k, m; " + silent);
}

TEST_CASE("new members extend if they come last") {
  const std::string more = spring("1/2*k*x^2 + c*x");
  CHECK(interface_text(spring(), replaced(more, "k = 3", "k = 3\nc = 0")) ==
        "extended: Parameters has new members: c\n");
  CHECK(interface_text(spring(), replaced(more, "k = 3", "c = 0\nk = 3")) ==
        "breaks: Parameters has new members, not all at the end: c; " + silent);
}

TEST_CASE("removed members do not compile") {
  CHECK(interface_text(replaced(spring("1/2*k*x^2 + c*x"), "k = 3", "k = 3\nc = 0"), spring()) ==
        "breaks: parameter `c` is removed\n");
}

TEST_CASE("unused and fixed parameters are no members") {
  CHECK(interface_text(spring(), replaced(spring(), "k = 3", "c = 0\nk = 3")).empty());
  const std::string reversed = replaced(replaced(spring(), "k = 3\n", ""), "m = {", "k = 3\nm = {");
  const std::string scene = "[outputs]\ngravity = true\n[parameters]\nfixed = { k = 3 }\n";
  CHECK(interface_text(spring(), reversed, scene, scene).empty());
}

TEST_CASE("removed or added pivots change the result of a function") {
  const std::string with = "[outputs]\nforward_dynamics = true\n";
  const std::string without = "[outputs]\nforward_dynamics = { pivots = false }\n";
  CHECK(interface_text(spring(), spring(), with, without) ==
        "breaks: `forward_dynamics` no longer returns relative pivots\n");
  CHECK(interface_text(spring(), spring(), without, with) ==
        "breaks: `forward_dynamics` now returns relative pivots\n");
  CHECK(interface_text(spring(), spring() + without, with, without) ==
        "breaks: `forward_dynamics` no longer returns relative pivots\n");
}

TEST_CASE("changed assumptions are reported, even if all entries are equal") {
  CHECK(interface_text(spring(), replaced(spring(), ", assume = \"positive\"", "")) ==
        "values: `m` is assumed to be any number (was positive)\n");
}

TEST_CASE("changed units and values are reported by name") {
  const std::string mass = "m = { value = 2, assume = \"positive\" }";
  CHECK(interface_text(replaced(spring(), mass, "m = { value = 2, unit = \"kg\" }"),
                       replaced(spring(), mass, "m = { value = 2, unit = \"1\" }")) ==
        "breaks: the unit of parameter `m` is 1 (was kg); " + silent);
  CHECK(interface_text(spring(), replaced(spring(), "k = 3", "k = 4")) ==
        "values: the value of `k` is 4 (was 3)\n");
}

TEST_CASE("if time occurs, it is an argument of every function") {
  CHECK(mentions(interface_text(spring(), spring("1/2*k*x^2 + x*sin(t)")),
                 "breaks: every function now takes t\n"));
}

TEST_CASE("added functions extend, removed functions break") {
  const std::string one = "[outputs]\nmass_matrix = true\ngravity = true\n";
  const std::string two = one + "bias = true\n";
  CHECK(interface_text(spring(), spring(), one, two) == "extended: function `bias` is new\n");
  CHECK(interface_text(spring(), spring(), two, one) == "breaks: function `bias` is removed\n");
}

TEST_CASE("language, storage, namespace and Eigen header are part of the interface") {
  const std::string one = "[outputs]\nmass_matrix = true\n[emit]\n";
  CHECK(interface_text(spring(), spring(), one, one + "storage = \"column-major\"\n") ==
        "breaks: matrices are stored column-major (were row-major); " + silent);
  CHECK(mentions(interface_text(spring(), spring(), one, one + "language = \"c99\"\n"),
                 "breaks: the language of the code differs\n"));
  CHECK(interface_text(spring(), spring(), one, one + "namespace = \"other\"\n") ==
        "breaks: the namespace is `other` (was `spring_given`)\n");
  CHECK(interface_text(spring(), spring(), one + "eigen = true\n", one) ==
        "breaks: header NAME_eigen.hpp is removed\n");
}

TEST_CASE("a renamed parameter does not compile, a renamed coordinate does") {
  const std::string other = replaced(replaced(spring(), "k = 3", "c = 3"), "1/2*k", "1/2*c");
  CHECK(interface_text(spring(), other, {}, {}, {{"k", "c"}}) == "breaks: `k` is now called `c`\n");
}

TEST_CASE("another method or number of iterations of a step is a different function") {
  const auto step = [](const std::string& what) {
    return "[outputs]\nstep = { method = \"" + what + " }\n";
  };
  CHECK(interface_text(spring(), spring(), step("rk4\""), step("verlet\"")) ==
        "different: the method of `step` is verlet (was rk4)\n");
  CHECK(
      interface_text(spring(), spring(), step("midpoint\""), step("midpoint\", iterations = 3")) ==
      "different: `step` has 3 iterations (had 8)\n");
  CHECK(interface_text(spring(), spring(), step("verlet\", order = 8"), step("verlet\"")) ==
        "different: `step` is of order 2 (was 8)\n");
  const std::string held = spring() + "[[constraint]]\nname = \"wall\"\nequation = \"x = 0\"\n";
  CHECK(interface_text(held, held, step("rk4\""), step("rk4\", projected = true")) ==
        "different: `step` ends on the constraints (drifted off before)\n");
}

TEST_CASE("an output of another shape does not compile") {
  const std::string tip = spring() + "[[output]]\nname = \"tip\"\nvalue = [\"x\", \"x^2\"]\n";
  CHECK(interface_text(tip, replaced(tip, "\"x^2\"]", "\"x^2\", \"x^3\"]")) ==
        "breaks: `tip` is 3 x 1 (was 2 x 1)\n");
  CHECK(interface_text(replaced(tip, "[\"x\", \"x^2\"]", "\"x\""), tip) ==
        "breaks: `tip` is 2 x 1 (was 1 x 1)\n");
}

TEST_CASE("rad equals 1 in a unit, so adding it changes only the text") {
  const std::string before = model_text(
      "damped",
      "[[coordinate]]\nname = \"q\"\nunit = \"rad\"\n[parameters]\nJ = { value = 1, unit = "
      "\"kg*m^2\" }\nd = { value = 2, unit = \"N*m*s/rad\" }\n[energy]\n"
      "T = \"1/2*J*dot(q)^2\"\nD = \"1/2*d*dot(q)^2\"\n");
  CHECK(interface_text(before, replaced(before, "N*m*s/rad", "N*m*s")) ==
        "values: the unit of parameter `d` is N*m*s (was N*m*s/rad)\n");
}

TEST_CASE("another error bound of sines and cosines is a change of values") {
  const auto scene = [](const char* error) {
    return "[numeric]\ntrigonometry = { max_error = " + std::string(error) +
           " }\n[emit]\nbatch = true\n";
  };
  CHECK(interface_text(spring(), spring(), scene("1e-7"), scene("1e-5")) ==
        "values: the allowed error of sines and cosines differs\n");
}

TEST_CASE("sines of the library instead of in-line sines are a change of values") {
  const auto scene = [](const std::string& sines) {
    return "[numeric]\ntrigonometry = { scalar = \"" + sines + "\" }\n";
  };
  CHECK(interface_text(spring(), spring(), scene("in-line"), scene("library")) ==
        "values: sines and cosines outside batches are from the library (were in line)\n");
}

TEST_CASE("another promised error is a change of values") {
  const std::string promise = "[numeric]\nmax_error = ";
  CHECK(interface_text(spring(), spring(), promise + "1e-7\n", promise + "1e-5\n") ==
        "values: the error bound that the scene promises for its outputs differs\n");
}

TEST_CASE("number and order of open values are part of the interface") {
  const auto plane = [](const std::string& functions) {
    return model_text("plane", "[[coordinate]]\nname = \"x\"\n[[coordinate]]\nname = \"y\"\n" +
                                   functions +
                                   "[energy]\nT = \"dot(x)^2 + dot(y)^2\"\nV = \"V\"\n");
  };
  const std::string one = "[[function]]\nname = \"V\"\nof = [\"x\"]\n";
  const std::string other = "[[function]]\nname = \"W\"\nof = [\"x\"]\n";
  CHECK(interface_text(plane(one), plane("[[function]]\nname = \"V\"\nof = [\"x\", \"y\"]\n")) ==
        "breaks: 6 open values (was 3): V, V_1, V_11 -> V, V_1, V_2, V_11, V_12, V_22\n");
  CHECK(interface_text(plane(one + other), plane(other + one)) ==
        "breaks: the open values or their order changed: V, V_1, V_11, W, W_1, W_11 -> "
        "W, W_1, W_11, V, V_1, V_11; " +
            silent);
}

TEST_CASE("an added or removed constraint does not compile") {
  const std::string more = interface_text(held_plane(""), held_plane(held_rod));
  CHECK(mentions(more, "breaks: 1 constraint (was 0):  -> rod\n"));
  CHECK(mentions(more, "extended: function `constraint_jacobian` is new\n"));
  const std::string fewer = interface_text(held_plane(held_rod), held_plane(""));
  CHECK(mentions(fewer, "breaks: 0 constraints (was 1): rod -> \n"));
  CHECK(mentions(fewer, "breaks: function `constraint_jacobian` is removed\n"));
}

TEST_CASE("reordered constraints change the meaning, another kind does not compile") {
  CHECK(interface_text(held_plane(held_rod + held_slot), held_plane(held_slot + held_rod)) ==
        "breaks: the constraints or their order changed: rod, slot -> slot, rod; " + silent);
  const std::string rates =
      replaced(held_slot, "z = y", "dot(z) = dot(y)") + "kind = \"velocity\"\n";
  CHECK(interface_text(held_plane(held_rod + held_slot), held_plane(held_rod + rates)) ==
        "breaks: `constraint_residual` is 1 x 1, 2 x 1 (was 2 x 1, 2 x 1)\n");
}

TEST_CASE("the rows of reaction are identified by locked coordinates, whatever their number") {
  // The weights along x and y are equal, so the entries of `reaction` have the same text.
  const std::string space = model_text("space", R"toml([[coordinate]]
name = "x"
[[coordinate]]
name = "y"
[[coordinate]]
name = "z"
[energy]
T = "dot(x)^2 + dot(y)^2 + dot(z)^2"
V = "x + y"
)toml");
  const auto held = [](const std::string& locks) {
    return "[outputs]\nreaction = true\n[lock]\n" + locks;
  };
  const std::string of_x = held("x = { value = 0, reaction = true }\ny = { value = 0 }\n");
  const std::string of_y = held("x = { value = 0 }\ny = { value = 0, reaction = true }\n");
  const std::string of_both =
      held("x = { value = 0, reaction = true }\ny = { value = 0, reaction = true }\n");
  CHECK(interface_text(space, space, of_x, of_x).empty());
  CHECK(interface_text(space, space, of_x, of_y) ==
        "breaks: the rows of `reaction` are y (were x); " + silent);
  CHECK(interface_text(space, space, of_x, of_both) ==
        "breaks: the rows of `reaction` are x, y (were x); " + silent);
}

TEST_CASE("reordered columns of the regressor and rows of its parameters are reported") {
  const auto point = [](const std::string& name, const std::string& at) {
    return "[[point]]\nname = \"" + name + "\"\nat = [\"" + at + "\", 0]\nmass = \"m\"\n";
  };
  const std::string start = model_text("pair", R"toml([[coordinate]]
name = "x"
unit = "m"
[[coordinate]]
name = "y"
unit = "m"
[parameters]
m = { value = 1, unit = "kg" }
)toml");
  const std::string old = start + point("a", "x") + point("b", "y");
  const std::string now = start + point("b", "y") + point("a", "x");
  const std::string scene = "[outputs]\nregressor = true\nregressor_parameters = true\n";
  CHECK(interface_text(old, old, scene, scene).empty());
  CHECK(interface_text(old, now, scene, scene) ==
        "breaks: the columns of `regressor.matrix` are b.m, a.m (were a.m, b.m); " + silent +
            "breaks: the rows of `regressor_parameters` are b.m, a.m (were a.m, b.m); " + silent);
  const std::string other = start + point("c", "x") + point("b", "y");
  CHECK(interface_text(old, other, scene, scene, {{"a", "c"}}) ==
        "values: `a` is now called `c`\n");
}
