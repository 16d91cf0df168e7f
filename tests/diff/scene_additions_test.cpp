// Entries that a scene adds to a model are changes of the scene.
#include <catch2/catch.hpp>

#include "diff/renamed.hpp"
#include "diff/versions.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

const std::string chosen = "[outputs]\nbias = true\n";
const std::string height = "[[output]]\nname = \"height\"\nvalue = \"y(bob)\"\n";

}  // namespace

TEST_CASE("an output of a scene is a new function, at its place in the scene") {
  const LoweredVersion old = lowered(cart, chosen);
  const LoweredVersion now = lowered(cart, height + chosen);
  const SystemChange system = compare(old.version(), now.version());
  REQUIRE(system.keys.size() == 1);
  CHECK(system.keys[0].entry == "[[output]] height");
  CHECK(system.keys[0].new_span.source == now.scene->source.get());
  CHECK(system.impact == Impact::extended);
  CHECK(compare(now.version(), old.version()).impact == Impact::breaks);
}

TEST_CASE("a description in an addition changes no equation") {
  const LoweredVersion old = lowered(cart, height + chosen);
  const LoweredVersion now = lowered(cart, height + "doc = \"of the bob\"\n" + chosen);
  CHECK(compare(old.version(), now.version()).impact == Impact::values);
}

TEST_CASE("a renamed coordinate is renamed in additions") {
  const SourcePointer source = make_source("a.scene.toml",
                                           "format = 1\nmodel = \"m.toml\"\nname = \"far\"\n"
                                           "[[output]]\nname = \"reach\"\nvalue = \"x + l\"\n");
  const FileSyntax renamed = apply_renames(*parse_scene(source, {}), {{"x", "s"}});
  CHECK(mentions(dump(renamed), "  value = (s + l)\n"));
}
