// Entries that a scene adds to a model are changes of the scene.
#include <algorithm>
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

TEST_CASE("the components of a renamed wrench keep their meaning") {
  const auto has_other_inputs = [](const Renames& renames) {
    const LoweredVersion old = lowered(cart, "[[input]]\nname = \"f\"\nat = \"bob\"\n" + chosen);
    const LoweredVersion now = lowered(cart, "[[input]]\nname = \"pull\"\nat = \"bob\"\n" + chosen);
    const SystemChange system = compare(old.version(), now.version(), {.renames = renames});
    return std::ranges::any_of(system.interface, [](const InterfaceChange& change) {
      return mentions(change.text,
                      "the inputs or their order changed: u, f_fx, f_fy -> u, pull_fx, pull_fy");
    });
  };
  CHECK(has_other_inputs({}));
  CHECK_FALSE(has_other_inputs({{"f", "pull"}}));
}

TEST_CASE("the order of inputs in a scene is compared") {
  const auto inputs = [](const std::string& first, const std::string& second) {
    return "[[input]]\nname = \"" + first + "\"\nat = \"bob\"\n[[input]]\nname = \"" + second +
           "\"\nat = \"bob\"\n" + chosen;
  };
  const LoweredVersion old = lowered(cart, inputs("f", "pull"));
  const LoweredVersion now = lowered(cart, inputs("pull", "f"));
  CHECK(breaks_silently(compare(old.version(), now.version())));
}

TEST_CASE("a renamed coordinate is renamed in additions") {
  const SourcePointer source = make_source("a.scene.toml",
                                           "format = 1\nmodel = \"m.toml\"\nname = \"far\"\n"
                                           "[[output]]\nname = \"reach\"\nvalue = \"x + l\"\n");
  const FileSyntax renamed = apply_renames(*parse_scene(source, {}), {{"x", "s"}});
  CHECK(mentions(dump(renamed), "  value = (s + l)\n"));
}
