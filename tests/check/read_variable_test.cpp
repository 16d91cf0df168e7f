// Coordinates, inputs and prescribed functions.
#include <catch2/catch.hpp>
#include <utility>

#include "check_testing.hpp"

namespace elgen::test {
namespace {

TEST_CASE("a coordinate keeps what is said of it") {
  const Model model = checked(R"toml(format = 1
[model]
name = "a"
[[coordinate]]
name = "q"
unit = "rad"
range = ["-pi", "pi"]
rate_range = [-5, 5]
start = { value = 0.1, rate = "1/3" }
armature = "J"
singular = "sin(q)"
latex = '\theta'
doc = "an angle"
[parameters]
J = { value = 1, unit = "kg*m^2" }
)toml")
                          .model;
  const Coordinate& q = model.coordinates.front();
  CHECK(q.unit == Unit{});
  CHECK(q.unit_text == "rad");
  const Velocity& rate = model.velocities[q.velocity];
  CHECK(rate.name == "q");
  CHECK(rate.unit == power(*find_unit("s"), {-1, 1}));
  REQUIRE(rate.rate_range);
  CHECK(rate.rate_range->low == -5);
  CHECK(q.start_value == cln::cl_RA(1) / 10);
  CHECK(rate.start_rate == cln::cl_RA(1) / 3);
  CHECK(q.latex == "\\theta");
  CHECK(q.doc == "an angle");
  REQUIRE(q.armature);
  CHECK(to_string(model, *q.armature) == "J");
  REQUIRE(q.singular);
  CHECK(to_string(model, *q.singular) == "sin(q)");
}

TEST_CASE("what variables may not say") {
  const std::vector<std::pair<std::string, std::string>> rows{
      {"[[input]]\nname = \"u\"\nunit = \"N*m\"\non = \"x\"\n",
       "E403 14:9 `u` is in J, but a force on `x` is in N\n"},
      {"[[input]]\nname = \"u\"\nunit = \"N\"\non = \"xx\"\n",
       "E201 15:7 unknown coordinate `xx` | did you mean `x`? (coordinate, line 5)\n"},
      {"[[input]]\nname = \"u\"\nunit = \"N\"\nlimits = [1, 1]\n",
       "E112 15:10 `1` is not below `1`\n"},
      {"[[input]]\nname = \"u\"\nunit = \"N\"\nlimits = [\"m\", 1]\n",
       "E319 15:12 `m` is not a constant number\n"},
      {"[[prescribed]]\nname = \"h\"\nunit = \"m\"\nvalue = \"x\"\n",
       "E319 15:10 `x` is a coordinate, and a prescribed function takes none\n"},
      {"[[prescribed]]\nname = \"h\"\nunit = \"m\"\nvalue = \"t\"\n",
       "E403 15:10 `t` is in s, but a prescribed function is in m\n"},
      {"[[coordinate]]\nname = \"y\"\nunit = \"m\"\narmature = \"x*m\"\n",
       "E506 15:13 `x` is a coordinate, and an armature takes none | what varies is written out in "
       "`[energy] T`\n"},
      {"[[coordinate]]\nname = \"y\"\nunit = \"m\"\narmature = \"m\"\nsingular = \"dot(y)\"\n",
       "E319 16:13 `dot(y)` is a rate, and a singular configuration takes none\n"},
  };
  for (const auto& [entries, expected] : rows) {
    INFO(entries);
    CHECK(messages(block(entries)) == expected);
  }
}

TEST_CASE("prescribed functions may move what they move") {
  const std::string model = block(
      "V = \"1/2*k*(x - h)^2\"\n[[prescribed]]\nname = \"h\"\nvalue = \"A*sin(w*t)\"\n"
      "[parameters.A]\nvalue = 1\nunit = \"m\"\n[parameters.w]\nvalue = 1\nunit = \"rad/s\"\n");
  CHECK(messages(model).empty());
  CHECK(dumped(model, "prescribed") == "prescribed h = A*sin(w*t)\n");
  CHECK(dumped(model, "time") == "time yes\n");
}

TEST_CASE("an angle wraps, also in a model in which all units are 1") {
  const auto turned = [](const std::string& unit, const std::string& parameter) {
    return "format = 1\n[model]\nname = \"turned\"\n[[coordinate]]\nname = \"q\"\nunit = \"" +
           unit + "\"\nwrap = true\n[parameters]\nJ = { value = 1" + parameter +
           " }\n[energy]\nT = \"1/2*J*dot(q)^2\"\n";
  };
  CHECK(checked(turned("rad", "")).model.coordinates.front().wrap);
  CHECK(checked(turned("rad", ", unit = \"kg*m^2\"")).model.coordinates.front().wrap);
  CHECK(messages(turned("m", ", unit = \"kg\"")).find("E528") == 0);
}

}  // namespace
}  // namespace elgen::test
