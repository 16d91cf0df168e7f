// Mechanics: degrees of energies in the rates, forces affine in inputs, and velocities with
// inertia.
#include <catch2/catch.hpp>

#include "check/judge/judge.hpp"
#include "check_testing.hpp"
#include "elgen/leaf_names.hpp"
#include "elgen/model.hpp"

namespace elgen::test {

namespace {

/// A model of two coordinates x and y without any energy.
std::string model_without_energy(const std::string& entries) {
  return "format = 1\n[model]\nname = \"a\"\n[[coordinate]]\nname = \"x\"\nunit = \"m\"\n"
         "[[coordinate]]\nname = \"y\"\nunit = \"m\"\n[parameters]\n"
         "m = { value = 1, unit = \"kg\" }\nc = { value = 1, unit = \"m/s\" }\n" +
         entries;
}

/// The coordinates among x, y and z whose rates occur in T, in L or in the motion of a mass, such
/// as "xz". Armatures let the model pass the check and are then removed.
std::string moving_names(const std::string& entries) {
  Model model = checked(
                    "format = 1\n[model]\nname = \"a\"\n[[coordinate]]\nname = \"x\"\n"
                    "armature = 1\n[[coordinate]]\nname = \"y\"\narmature = 1\n"
                    "[[coordinate]]\nname = \"z\"\narmature = 1\n" +
                    entries)
                    .model;
  for (Coordinate& coordinate : model.coordinates) {
    coordinate.armature.reset();
  }
  const std::vector<bool> found = velocities_with_energy(model);
  std::string names;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (found[i]) names += model.coordinates[i].name;
  }
  return names;
}

}  // namespace

TEST_CASE("degrees of energies in the rates") {
  const Rows rows{
      {"T = \"m*dot(x)^2 + m*dot(y)^2 + m*c*dot(x) + m*c^2\"\n", ""},
      {"T = \"m*dot(x)^2 + m*dot(y)^3/c\"\n",
       "E504 14:6 `m*dot(x)^2 + m*dot(y)^3/c` is of degree 3 or more in the rates, or no "
       "polynomial in them, not at most quadratic\n"},
      {"T = \"m*dot(x)^2 + m*c*dot(y)*dot(x)/c\"\nV = \"m*c*dot(x)\"\n", ""},
      {"T = \"m*dot(x)^2 + m*dot(y)^2\"\nV = \"m*dot(x)^2\"\n",
       "E503 15:6 `m*dot(x)^2` is of degree 2 in the rates, not at most linear\n"},
  };
  check_rows(rows, [&](const std::string& energies) {
    return messages(model_without_energy("[energy]\n" + energies));
  });
}

TEST_CASE("a spin is linear in the rates") {
  const auto turning = [](const std::string& spin) {
    return messages(
        model_without_energy("J = { value = 1, unit = \"kg*m^2\" }\n[energy]\n"
                             "T = \"m*dot(x)^2 + m*dot(y)^2\"\n[[body]]\nname = \"b\"\n"
                             "inertia = \"J\"\nspin = \"" +
                             spin + "\"\n"));
  };
  CHECK(turning("dot(x)/y + c/x").empty());
  CHECK(turning("dot(x)^2/(c*y)") ==
        "E504 19:9 `dot(x)^2/(c*y)` is of degree 2 in the rates, not at most linear\n");
  CHECK(
      turning("sqrt(dot(x)*dot(y))/x") ==
      "E504 19:9 `sqrt(dot(x)*dot(y))/x` is of degree 3 or more in the rates, or no polynomial in "
      "them, not at most linear\n");
}

TEST_CASE("a Lagrangian L may have any degree in the rates, and the model records it") {
  const std::string quadratic = model_without_energy("[energy]\nL = \"m*dot(x)^2 + m*dot(y)^2\"\n");
  CHECK(messages(quadratic).empty());
  CHECK(dump_lines(quadratic, "quadratic") == "quadratic yes\n");
  const std::string other =
      model_without_energy("[energy]\nL = \"-m*c^2*sqrt(1 - (dot(x)^2 + dot(y)^2)/c^2)\"\n");
  CHECK(messages(other).empty());
  CHECK(dump_lines(other, "quadratic") == "quadratic no\n");
}

TEST_CASE("a Lagrangian is given once, as L or by energies") {
  const Rows rows{
      {"",
       "E514 2:1 `a` has no kinetic energy | give a point or body a mass, or write `[energy] T`\n"},
      {"[[point]]\nname = \"p\"\nat = [\"x\", \"y\"]\n",
       "E514 2:1 `a` has no kinetic energy | give a point or body a mass, or write `[energy] T`\n"},
      {"[energy]\nL = \"m*dot(x)^2 + m*dot(y)^2\"\nV = \"0\"\n",
       "E515 14:1 `L` is given besides T or V\n"},
      {"[energy]\nL = \"m*dot(x)^2 + m*dot(y)^2\"\n[[point]]\nname = \"p\"\nat = [\"x\", "
       "\"y\"]\nmass = \"m\"\n",
       "E515 14:1 `L` is given besides the mass of an entry\n"},
  };
  check_rows(rows,
             [&](const std::string& entries) { return messages(model_without_energy(entries)); });
}

TEST_CASE("an input acts by its `on` or through a force, not both") {
  const std::string energy = "[energy]\nT = \"m*dot(x)^2 + m*dot(y)^2\"\n";
  const std::string input = "[[input]]\nname = \"u\"\nunit = \"N\"\n";
  const std::string acting = input + "on = \"x\"\n";
  const std::string force = "[[force]]\non = \"y\"\nvalue = ";
  const std::string twice =
      "` acts on `x` by its `on`, but a force also contains it | without `on`, an input acts "
      "through the force that contains it\n";
  const Rows rows{
      {input + force + "\"2*u\"\n", ""},
      {acting + force + "\"m*c^2/x\"\n", ""},
      {acting + force + "\"2*u\"\n", "E112 21:12 `u" + twice},
      {acting + "[define]\ndrive = \"2*u\"\n" + force + "\"drive\"\n", "E112 20:12 `u" + twice},
      {"[[input]]\nname = \"w[i]\"\nfor = \"i in 1..2\"\nunit = \"N\"\non = \"x\"\n" + force +
           "\"w[2]\"\n",
       "E112 22:10 `w[2]" + twice},
      {acting + "[[point]]\nname = \"p\"\nat = [\"x\", \"y\"]\n[[force]]\nat = \"p\"\n" +
           "value = [\"u\", \"0\"]\n",
       "E112 24:11 `u" + twice},
  };
  check_rows(rows, [&](const std::string& entries) {
    return messages(model_without_energy(energy + entries));
  });
}

TEST_CASE("a coordinate whose rate is in no energy is an error") {
  CHECK(messages(model_without_energy("[energy]\nT = \"m*dot(x)^2 + y*m*c*dot(x)/(1*x)\"\n")) ==
        "E513 8:9 the rate of `y` is in no energy, so nothing determines its motion\n");
}

TEST_CASE("drift is non-zero if T or V is not homogeneous in the rates") {
  const std::string energy = "[energy]\nT = \"m*dot(x)^2 + m*dot(y)^2\"\n";
  const std::string body = "J = { value = 1, unit = \"kg*m^2\" }\n" + energy +
                           "[[body]]\nname = \"b\"\ninertia = \"J\"\nspin = ";
  CHECK(dump_lines(model_without_energy(energy), "drift") == "drift no\n");
  CHECK(dump_lines(model_without_energy(body + "\"dot(x)/x + 0*c/x\"\n"), "drift") == "drift no\n");
  CHECK(dump_lines(model_without_energy(body + "\"dot(x)/x + c/x\"\n"), "drift") == "drift yes\n");
  CHECK(dump_lines(model_without_energy(energy + "V = \"m*c^2*x/y\"\n"), "drift") == "drift no\n");
  CHECK(dump_lines(model_without_energy(energy + "V = \"m*c*dot(x)\"\n"), "drift") ==
        "drift yes\n");
  CHECK(dump_lines(model_without_energy("[energy]\nT = \"m*dot(x)^2 + m*dot(y)^2 + m*c*dot(x)\"\n"),
                   "drift") == "drift yes\n");
  CHECK(dump_lines(model_without_energy("[energy]\nL = \"m*dot(x)^2 + m*dot(y)^2\"\n"), "drift") ==
        "drift yes\n");
}

TEST_CASE("a model uses time if time occurs in an equation of motion") {
  const std::string energy = "[energy]\nT = \"m*dot(x)^2 + m*dot(y)^2\"\n";
  const std::string moving_point = "[[point]]\nname = \"p\"\nat = [\"x + c*t\", \"y\"]\n";
  CHECK(dump_lines(model_without_energy(energy + moving_point), "time") == "time no\n");
  CHECK(dump_lines(model_without_energy(energy + moving_point + "mass = \"m\"\n"), "time") ==
        "time yes\n");
  CHECK(dump_lines(model_without_energy(energy + moving_point +
                                        "[[force]]\nat = \"p\"\nvalue = [\"m*c^2/x\", \"0\"]\n"),
                   "time") == "time yes\n");
  CHECK(dump_lines(model_without_energy(energy + moving_point +
                                        "[[output]]\nname = \"o\"\nvalue = \"x(p)\"\n"),
                   "time") == "time yes\n");
  CHECK(dump_lines(model_without_energy(energy + "V = \"m*c^2*cos(c*t/x)\"\n"), "time") ==
        "time yes\n");
  CHECK(dump_lines(model_without_energy(energy + "[gravity]\nvector = [\"0\", \"c/t\"]\n"),
                   "time") == "time yes\n");
}

TEST_CASE("a model uses time if time rotates a frame on which a torque acts") {
  const std::string energy = "[energy]\nT = \"m*dot(x)^2 + m*dot(y)^2\"\n";
  const auto frame = [](const std::string& name, const std::string& turn) {
    return "[[frame]]\nname = \"" + name + "\"\nparent = \"world\"\nrotate = [[\"x\", \"x/y\"]" +
           turn + "]\n";
  };
  const std::string frames = energy + frame("A", "") + frame("B", ", [\"z\", \"c*t/x\"]");
  const auto torque = [](const std::string& keys) {
    return "[[force]]\nvalue = [\"m*c^2\", \"0\", \"0\"]\n" + keys;
  };
  CHECK(dump_lines(model_without_energy(frames), "time") == "time no\n");
  CHECK(dump_lines(model_without_energy(frames + torque("frame = \"A\"\n")), "time") ==
        "time no\n");
  CHECK(dump_lines(model_without_energy(frames + torque("frame = \"B\"\n")), "time") ==
        "time yes\n");
  CHECK(dump_lines(model_without_energy(frames + torque("frame = \"A\"\nfrom = \"B\"\n")),
                   "time") == "time yes\n");
}

TEST_CASE("rates are found through definitions, points and derivatives") {
  const Rows rows{
      {"", ""},
      {"[energy]\nT = \"dot(x)^2\"\n", "x"},
      {"[energy]\nT = \"y*dot(x)^2\"\nV = \"z\"\n", "x"},
      {"[energy]\nT = \"s^2\"\n[define]\ns = \"dot(x) + dot(z)\"\n", "xz"},
      {"[energy]\nT = \"dot(s)^2\"\n[define]\ns = \"x*y\"\n", "xy"},
      {"[energy]\nT = \"dot(s)^2 + s\"\n[define]\ns = \"x*y\"\n", "xy"},
      {"[energy]\nT = \"v2(p)\"\n[[point]]\nname = \"p\"\nat = [\"x\", \"y(r)\"]\n"
       "[[point]]\nname = \"r\"\nat = [\"0\", \"z\"]\n",
       "xz"},
      {"[energy]\nT = \"x(p)\"\n[[point]]\nname = \"p\"\nat = [\"x\", \"y\"]\n", ""},
      {"[[point]]\nname = \"p\"\nat = [\"x\", \"y\"]\n", ""},
      {"[[point]]\nname = \"p\"\nat = [\"x\", \"y\"]\nmass = 1\n", "xy"},
      {"[[body]]\nname = \"b\"\nspin = \"z*dot(y)\"\ninertia = 1\n", "y"},
      {"[[body]]\nname = \"b\"\nmass = 1\ncom = [\"x\", \"0\"]\nspin = \"dot(y)\"\ninertia = 1\n",
       "xy"},
      {"[energy]\nL = \"sqrt(1 - dot(y)^2)\"\n", ""},
  };
  for (const auto& [entries, names] : rows) {
    INFO(entries);
    if (!mentions(entries, "L = ")) {
      CHECK(moving_names(entries) == names);
    }
  }
}

TEST_CASE("an armature gives its coordinate inertia") {
  const Model model = checked(
                          "format = 1\n[model]\nname = \"a\"\n[[coordinate]]\nname = \"x\"\n"
                          "armature = 1\n")
                          .model;
  CHECK(velocities_with_energy(model) == std::vector<bool>{true});
}

TEST_CASE("a coordinate is appended together with its rate") {
  Model model;
  Coordinate plain;
  plain.name = "s[2]";
  plain.identifier = "s_2";
  plain.unit = find_unit("m");
  plain.unit_text = "m";
  CHECK(append_coordinate(model, {}) == 0);
  CHECK(append_coordinate(model, plain) == 1);
  REQUIRE(model.velocities.size() == 2);
  CHECK(model.coordinates[1].velocity == 1);
  const Velocity& rate = model.velocities[1];
  CHECK(rate.name == "s[2]");
  CHECK(rate.identifier == "s_2");
  CHECK(rate.coordinate == 1);
  CHECK(rate.unit == *find_unit("m") / *find_unit("s"));
  CHECK_FALSE(model.velocities[0].unit);
  CHECK(leaf_count(model, Opcode::acceleration) == 2);
  CHECK(leaf_names(model).v == std::vector<std::string>{"", "s[2]"});
}

}  // namespace elgen::test
