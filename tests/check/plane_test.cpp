// Frames of planar models stay in the plane.
#include "check/entries/plane.hpp"

#include <catch2/catch.hpp>
#include <utility>

#include "check_testing.hpp"
#include "model_numbers.hpp"

namespace elgen::test {
namespace {

/// A planar point, and a frame whose keys start on line 22.
std::string planar(const std::string& keys) {
  return with_frames(
      "[[point]]\nname = \"p\"\nat = [\"s\", \"0\"]\n"
      "[[frame]]\nname = \"f\"\nparent = \"world\"\n" +
      keys);
}

TEST_CASE("turns about z and shifts in the plane stay there", "[frames]") {
  for (const char* keys :
       {"translate = [\"l\", \"s\"]\nrotate = [[\"z\", \"q\"]]\n",
        "rotate = [[[\"0\", \"0\", \"-2\"], \"q\"], [\"x\", \"0\"], [\"y\", \"sin(pi)\"]]\n",
        "rpy = [\"0\", \"0\", \"q\"]\n", "quaternion = [\"1\", \"0\", \"0\", \"q\"]\n",
        "dh = { convention = \"standard\", theta = \"q\", a = \"l\" }\n"}) {
    INFO(keys);
    CHECK(messages(planar(keys)) == "");
  }
}

TEST_CASE("what leaves the plane is refused where it does", "[frames]") {
  const std::vector<std::pair<std::string, std::string>> rows{
      {"rotate = [[\"z\", \"q\"], [\"x\", \"2*q\"]]\n",
       "E516 22:30 `2*q` turns out of the plane of a model whose vectors have 2 components\n"},
      {"rotate = [[[\"0\", \"1\", \"1\"], \"q\"]]\n",
       "E516 22:30 `q` turns out of the plane of a model whose vectors have 2 components\n"},
      {"rpy = [\"0\", \"pi\", \"q\"]\n",
       "E516 22:14 `pi` turns out of the plane of a model whose vectors have 2 components\n"},
      {"quaternion = [\"1\", \"0\", \"q\", \"0\"]\n",
       "E516 22:26 `q` turns out of the plane of a model whose vectors have 2 components\n"},
      {"dh = { convention = \"modified\", theta = \"q\", d = \"l\" }\n",
       "E516 22:51 `l` shifts out of the plane of a model whose vectors have 2 components\n"},
      {"translate = [\"l\", \"0\", \"0\"]\n",
       "E516 18:6 2 components, but other vectors of this model have 3\n"},
  };
  for (const auto& [keys, expected] : rows) {
    INFO(keys);
    CHECK(messages(planar(keys)) == expected);
  }
}

TEST_CASE("models in space turn as they like", "[frames]") {
  CHECK(messages(with_frames("[[frame]]\nname = \"f\"\nparent = \"world\"\n"
                             "translate = [\"l\", \"0\", \"0\"]\nrpy = [\"q\", \"q\", \"q\"]\n")) ==
        "");
}

}  // namespace
}  // namespace elgen::test
