// Mechanics: degrees of energies, what has kinetic energy, and where time matters.
#include "check/judge/mechanics.hpp"

#include <catch2/catch.hpp>
#include <utility>

#include "check_testing.hpp"

namespace elgen::test {
namespace {

/// A model of two coordinates without any energy.
std::string bare(const std::string& entries) {
  return "format = 1\n[model]\nname = \"a\"\n[[coordinate]]\nname = \"x\"\nunit = \"m\"\n"
         "[[coordinate]]\nname = \"y\"\nunit = \"m\"\n[parameters]\n"
         "m = { value = 1, unit = \"kg\" }\nc = { value = 1, unit = \"m/s\" }\n" +
         entries;
}

TEST_CASE("degrees of the energies in the rates") {
  const std::vector<std::pair<std::string, std::string>> rows{
      {"T = \"m*dot(x)^2 + m*dot(y)^2 + m*c*dot(x) + m*c^2\"\n", ""},
      {"T = \"m*dot(x)^2 + m*dot(y)^3/c\"\n",
       "E504 14:6 `m*dot(x)^2 + m*dot(y)^3/c` is of degree 3 or more in the rates, or no "
       "polynomial in them, not at most quadratic\n"},
      {"T = \"m*dot(x)^2 + m*c*dot(y)*dot(x)/c\"\nV = \"m*c*dot(x)\"\n", ""},
      {"T = \"m*dot(x)^2 + m*dot(y)^2\"\nV = \"m*dot(x)^2\"\n",
       "E503 15:6 `m*dot(x)^2` is of degree 2 in the rates, not at most linear\n"},
  };
  for (const auto& [energies, expected] : rows) {
    INFO(energies);
    CHECK(messages(bare("[energy]\n" + energies)) == expected);
  }
}

TEST_CASE("a spin is linear in the rates") {
  const auto turning = [](const std::string& spin) {
    return messages(
        bare("J = { value = 1, unit = \"kg*m^2\" }\n[energy]\n"
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

TEST_CASE("a Lagrangian given whole may have any degree, and says which") {
  const std::string quadratic = bare("[energy]\nL = \"m*dot(x)^2 + m*dot(y)^2\"\n");
  CHECK(messages(quadratic).empty());
  CHECK(dumped(quadratic, "quadratic") == "quadratic yes\n");
  const std::string other = bare("[energy]\nL = \"-m*c^2*sqrt(1 - (dot(x)^2 + dot(y)^2)/c^2)\"\n");
  CHECK(messages(other).empty());
  CHECK(dumped(other, "quadratic") == "quadratic no\n");
}

TEST_CASE("a Lagrangian is given once, and there is one") {
  const std::vector<std::pair<std::string, std::string>> rows{
      {"",
       "E514 2:1 `a` has no kinetic energy | give a point or body a mass, or write `[energy] T`\n"},
      {"[[point]]\nname = \"p\"\nat = [\"x\", \"y\"]\n",
       "E514 2:1 `a` has no kinetic energy | give a point or body a mass, or write `[energy] T`\n"},
      {"[energy]\nL = \"m*dot(x)^2 + m*dot(y)^2\"\nV = \"0\"\n",
       "E515 14:1 `L` is given beside T or V\n"},
      {"[energy]\nL = \"m*dot(x)^2 + m*dot(y)^2\"\n[[point]]\nname = \"p\"\nat = [\"x\", "
       "\"y\"]\nmass = \"m\"\n",
       "E515 14:1 `L` is given beside the mass of an entry\n"},
  };
  for (const auto& [entries, expected] : rows) {
    INFO(entries);
    CHECK(messages(bare(entries)) == expected);
  }
}

TEST_CASE("every coordinate moves something") {
  CHECK(messages(bare("[energy]\nT = \"m*dot(x)^2 + y*m*c*dot(x)/(1*x)\"\n")) ==
        "E513 8:9 the rate of `y` is in no energy, so nothing determines its motion\n");
}

TEST_CASE("drift is there where T or V are not of one degree in the rates") {
  const std::string energy = "[energy]\nT = \"m*dot(x)^2 + m*dot(y)^2\"\n";
  const std::string body = "J = { value = 1, unit = \"kg*m^2\" }\n" + energy +
                           "[[body]]\nname = \"b\"\ninertia = \"J\"\nspin = ";
  CHECK(dumped(bare(energy), "drift") == "drift no\n");
  CHECK(dumped(bare(body + "\"dot(x)/x + 0*c/x\"\n"), "drift") == "drift no\n");
  CHECK(dumped(bare(body + "\"dot(x)/x + c/x\"\n"), "drift") == "drift yes\n");
  CHECK(dumped(bare(energy + "V = \"m*c^2*x/y\"\n"), "drift") == "drift no\n");
  CHECK(dumped(bare(energy + "V = \"m*c*dot(x)\"\n"), "drift") == "drift yes\n");
  CHECK(dumped(bare("[energy]\nT = \"m*dot(x)^2 + m*dot(y)^2 + m*c*dot(x)\"\n"), "drift") ==
        "drift yes\n");
  CHECK(dumped(bare("[energy]\nL = \"m*dot(x)^2 + m*dot(y)^2\"\n"), "drift") == "drift yes\n");
}

TEST_CASE("time matters where it reaches an equation") {
  const std::string energy = "[energy]\nT = \"m*dot(x)^2 + m*dot(y)^2\"\n";
  const std::string moving_point = "[[point]]\nname = \"p\"\nat = [\"x + c*t\", \"y\"]\n";
  CHECK(dumped(bare(energy + moving_point), "time") == "time no\n");
  CHECK(dumped(bare(energy + moving_point + "mass = \"m\"\n"), "time") == "time yes\n");
  CHECK(
      dumped(bare(energy + moving_point + "[[force]]\nat = \"p\"\nvalue = [\"m*c^2/x\", \"0\"]\n"),
             "time") == "time yes\n");
  CHECK(dumped(bare(energy + moving_point + "[[output]]\nname = \"o\"\nvalue = \"x(p)\"\n"),
               "time") == "time yes\n");
  CHECK(dumped(bare(energy + "V = \"m*c^2*cos(c*t/x)\"\n"), "time") == "time yes\n");
  CHECK(dumped(bare(energy + "[gravity]\nvector = [\"0\", \"c/t\"]\n"), "time") == "time yes\n");
}

TEST_CASE("time matters where it turns what a torque acts on") {
  const std::string energy = "[energy]\nT = \"m*dot(x)^2 + m*dot(y)^2\"\n";
  const auto frame = [](const std::string& name, const std::string& turn) {
    return "[[frame]]\nname = \"" + name + "\"\nparent = \"world\"\nrotate = [[\"x\", \"x/y\"]" +
           turn + "]\n";
  };
  const std::string frames = energy + frame("A", "") + frame("B", ", [\"z\", \"c*t/x\"]");
  const auto torque = [](const std::string& keys) {
    return "[[force]]\nvalue = [\"m*c^2\", \"0\", \"0\"]\n" + keys;
  };
  CHECK(dumped(bare(frames), "time") == "time no\n");
  CHECK(dumped(bare(frames + torque("frame = \"A\"\n")), "time") == "time no\n");
  CHECK(dumped(bare(frames + torque("frame = \"B\"\n")), "time") == "time yes\n");
  CHECK(dumped(bare(frames + torque("frame = \"A\"\nfrom = \"B\"\n")), "time") == "time yes\n");
}

}  // namespace
}  // namespace elgen::test
