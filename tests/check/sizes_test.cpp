// Sizes: the model's, the scene's, the option's, the last one wins.
#include <catch2/catch.hpp>

#include "check_testing.hpp"

namespace elgen::test {
namespace {

const std::string free_masses = R"toml(format = 1
[model]
name = "masses"
[sizes]
n = 2
[[coordinate]]
for = "i in 1..n"
name = "x[i]"
[energy]
T = "sum(i, 1, n, dot(x[i])^2)"
)toml";

const std::string scene_head = "format = 1\nmodel = \"a.toml\"\nname = \"s\"\n";

std::size_t coordinates(const Wanted& wanted) {
  return checked(free_masses, wanted).model.coordinates.size();
}

TEST_CASE("a scene overrides sizes, an option overrides both") {
  Wanted wanted;
  CHECK(coordinates(wanted) == 2);
  wanted.scene = scene_head + "[sizes]\nn = 3\n";
  CHECK(coordinates(wanted) == 3);
  wanted.sizes = {"n=5"};
  CHECK(coordinates(wanted) == 5);
}

TEST_CASE("unknown sizes are reported where they are written") {
  Wanted wanted;
  wanted.scene = scene_head + "[sizes]\nm = 3\n";
  CHECK(messages(free_masses, wanted) == "E605 5:1 unknown size `m`\n");
  wanted.scene.clear();
  wanted.sizes = {"n=3, size=2"};
  CHECK(messages(free_masses, wanted) == "E605 1:6 unknown size `size`\n");
}

TEST_CASE("malformed sizes are reported") {
  for (const char* size : {"n", "n=", "n=x", "n=2.5"}) {
    Wanted wanted;
    wanted.sizes = {size};
    CHECK(messages(free_masses, wanted) ==
          "E606 1:1 `" + std::string(size) + "` is not of the form `n=20`\n");
  }
  Wanted wanted;
  for (const char* size : {"99999999999", "-99999999999"}) {
    wanted.sizes = {std::string("n=") + size};
    CHECK(messages(free_masses, wanted) ==
          "E606 1:3 `" + std::string(size) + "` is beyond 1000000000\n");
  }
}

TEST_CASE("a size may be too small for a repetition") {
  Wanted wanted;
  wanted.sizes = {"n=0"};
  CHECK(messages(free_masses, wanted) == "E209 7:8 from 1 to 0 there is no element\n");
}

TEST_CASE("a size is a name of the model") {
  CHECK(messages(free_masses + "[parameters]\nn = 3\n") ==
        "E203 12:1 `n` is already a size | first at line 5\n");
}

}  // namespace
}  // namespace elgen::test
