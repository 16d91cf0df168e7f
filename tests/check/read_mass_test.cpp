// Points and bodies: components, masses, inertias and what belongs together.
#include <catch2/catch.hpp>
#include <utility>

#include "check_testing.hpp"

namespace elgen::test {
namespace {

std::string with_J(const std::string& entries) {
  return block(
             "[parameters.J]\nvalue = 1\nunit = \"kg*m^2\"\n[[coordinate]]\nname = \"q\"\n"
             "unit = \"rad\"\narmature = \"J\"\n") +
         entries;
}

TEST_CASE("points are padded to three components") {
  const Model model =
      checked(with_J("[[point]]\nname = \"p\"\nat = [\"x\", \"0\"]\nmass = \"m\"\n")).model;
  CHECK(model.points[0].dimension == 2);
  CHECK(to_string(model, model.points[0].at[2]) == "0");
  REQUIRE(model.points[0].mass);
}

TEST_CASE("bodies are planar with one number, spatial with three or six") {
  const Model planar = checked(with_J("[[body]]\nname = \"b\"\nmass = \"m\"\ncom = [\"x\", \"0\"]\n"
                                      "spin = \"dot(q)\"\ninertia = \"J\"\n"))
                           .model;
  CHECK(planar.bodies[0].dimension == 2);
  CHECK(planar.bodies[0].inertia.size() == 1);
  const Model spatial =
      checked(with_J("[[body]]\nname = \"b\"\nspin = [\"0\", \"dot(q)\", \"0\"]\n"
                     "inertia = [\"J\", \"J\", \"J\"]\ninertia_about = \"com\"\n"))
          .model;
  CHECK(spatial.bodies[0].dimension == 3);
  REQUIRE(spatial.bodies[0].inertia.size() == 6);
  CHECK(to_string(spatial, spatial.bodies[0].inertia[5]) == "0");
  CHECK_FALSE(spatial.bodies[0].mass);
}

TEST_CASE("what masses may not be") {
  const std::vector<std::pair<std::string, std::string>> rows{
      {"[[point]]\nname = \"p\"\nat = [\"x\"]\n",
       "E104 21:6 1 component, but a vector has 2 or 3\n"},
      {"[[point]]\nname = \"p\"\nat = [\"dot(x)\", \"0\"]\n",
       "E319 21:8 `dot(x)` is a rate, and a position takes none\n"},
      {"[[point]]\nname = \"p\"\nat = [\"x\", \"q\"]\n",
       "E403 21:13 `q` is in 1, but a position is in m\n"},
      {"[[point]]\nname = \"p\"\nat = [\"x\", \"0\"]\nmass = \"m*t\"\n",
       "E506 22:11 `t` is time, and a mass takes none | what varies is written out in `[energy] "
       "T`\n"},
      {"[[point]]\nname = \"p\"\nat = [\"x\", \"0\"]\n[[point]]\nname = \"r\"\nat = [\"x\", \"0\", "
       "\"0\"]\n",
       "E516 24:6 3 components, but other vectors of this model have 2\n"},
      {"[[body]]\nname = \"b\"\nspin = \"dot(q)\"\ninertia = \"J\"\ninertia_about = \"origin\"\n",
       "E112 23:1 without a `frame` the body has no origin for its inertia to be about | give the "
       "inertia about the centre of mass, or the body a frame; of a body that turns about a fixed "
       "point, give no mass here and its weight in `[energy] V`\n"},
      {"[[body]]\nname = \"b\"\nmass = \"m\"\n", "E105 19:1 `b` has `mass` but no `com`\n"},
      {"[[body]]\nname = \"b\"\ninertia = \"J\"\n", "E105 19:1 `b` has `inertia` but no `spin`\n"},
      {"[[body]]\nname = \"b\"\nspin = \"dot(q)\"\n",
       "E105 19:1 `b` has `spin` but no `inertia`\n"},
      {"[[body]]\nname = \"b\"\nspin = \"dot(q)\"\ninertia = [\"J\", \"J\", \"J\"]\n",
       "E516 22:11 3 moments of inertia for a planar body | planar bodies have 1, spatial ones 3 "
       "or "
       "6: "
       "xx yy zz xy xz yz\n"},
      {"[[body]]\nname = \"b\"\nspin = [\"dot(q)\", \"0\"]\ninertia = [\"J\", \"J\", \"J\"]\n",
       "E104 21:8 2 components, but a spin has 1 or 3\n"},
      {"[[body]]\nname = \"b\"\nmass = \"m\"\ncom = [\"x\", \"0\", \"0\"]\nspin = "
       "\"dot(q)\"\ninertia = \"J\"\n",
       "E516 23:9 a planar spin, but the centre of mass has 3 components\n"},
      {"[[body]]\nname = \"b\"\nspin = \"dot(x)\"\ninertia = \"J\"\n",
       "E403 21:9 `dot(x)` is in m/s, but a spin is in 1/s\n"},
      {"[[body]]\nname = \"b\"\nspin = \"dot(q)\"\ninertia = \"m\"\n",
       "E403 22:12 `m` is in kg, but an inertia is in kg*m^2\n"},
  };
  for (const auto& [entries, expected] : rows) {
    INFO(entries);
    CHECK(messages(with_J(entries)) == expected);
  }
}

}  // namespace
}  // namespace elgen::test
