// Parsed trees with other names.
#include "diff/renamed.hpp"

#include <catch2/catch.hpp>

#include "diff/versions.hpp"

using namespace elgen;
using namespace elgen::test;

TEST_CASE("names change where they are declared and where they are used") {
  const FileSyntax syntax = *parse_model(make_source("model.toml", spring()), {});
  const std::string text = dump(renamed(syntax, {{"x", "s"}, {"m", "mass"}}));
  CHECK(mentions(text, "dot(s)"));
  CHECK(mentions(text, "mass"));
  CHECK_FALSE(mentions(text, "dot(x)"));
  CHECK(dump(renamed(syntax, {})) == dump(syntax));
}

TEST_CASE("keys of a scene that are names change, too") {
  const std::string scene =
      "format = 1\nmodel = \"m.toml\"\nname = \"fast\"\n[parameters]\n"
      "fixed = { m = 2 }\n[lock]\nx = { value = 0 }\n";
  const FileSyntax syntax = *parse_scene(make_source("a.scene.toml", scene), {});
  const FileSyntax now = renamed(syntax, {{"m", "mass"}, {"x", "s"}, {"value", "v"}});
  CHECK(mentions(dump(now), "mass"));
  CHECK(now.entries.back().keys.front().key == "s");
  CHECK(now.entries.back().keys.front().value.entries.front().key == "value");
}
