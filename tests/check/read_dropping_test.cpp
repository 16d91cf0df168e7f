// drop_below of a scene: its value, its parts, and what it cannot reduce.
#include "check/scene/read_dropping.hpp"

#include <catch2/catch.hpp>

#include "check/check_testing.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

Wanted dropping_scene(const std::string& outputs, const std::string& share = "1e-3") {
  Wanted wanted;
  wanted.scene = "format = 1\nmodel = \"a.toml\"\nname = \"s\"\n[outputs]\n" + outputs +
                 "[approximate]\ndrop_below = " + share + "\n";
  return wanted;
}

std::string parts_of(const std::string& outputs, const std::string& more = {}) {
  std::string names;
  const Scene scene = checked(block(more), dropping_scene(outputs)).scene;
  for (const OutputRequest& part : scene.dropping.value().parts) {
    names += (names.empty() ? "" : " ") + part.name;
  }
  return names;
}

}  // namespace

TEST_CASE("the share is exact") {
  const Scene scene = checked(block(), dropping_scene("bias = true\n")).scene;
  REQUIRE(scene.dropping);
  CHECK(scene.dropping->below == cln::cl_RA(1) / 1000);
  CHECK_FALSE(checked(block()).scene.dropping);
}

TEST_CASE("outputs are reduced by their parts") {
  CHECK(parts_of("velocity_force = true\n") == "mass_matrix");
  CHECK(parts_of("gravity = true\n") == "gravity potential_energy");
  CHECK(parts_of("bias = true\nmomentum = true\n") ==
        "mass_matrix gravity potential_energy dissipation applied_force");
}

TEST_CASE("what cannot be reduced is refused") {
  CHECK(messages(block(), dropping_scene("forward_dynamics = true\n")).find("E617 5:1") == 0);
  CHECK(messages(block(), dropping_scene("bias = { form = \"recursive\" }\n")).find("E617 5:1") ==
        0);
  CHECK(messages(block(), dropping_scene("bias = true\n", "0")).find("E617 7:14") == 0);
  CHECK(messages(block(), dropping_scene("bias = true\n", "1")).find("E617 7:14") == 0);
  CHECK(messages(block(), dropping_scene("bias = true\n", "\"pi/4\"")).find("E617 7:15") == 0);
}
