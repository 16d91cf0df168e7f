// Changed keys and their positions, edits that change no key, and parsed files with renamed
// entries.
#include <catch2/catch.hpp>

#include "diff/renamed.hpp"
#include "diff/versions.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// One line for each change, such as "[gravity] vector[2]: -g -> g".
std::string key_changes(const std::string& before, const std::string& after,
                        const Renames& renames = {}) {
  const auto syntax = [](const std::string& text) {
    const Result<FileSyntax> parsed = parse_model(make_source("model.toml", text), {});
    INFO(format(parsed.diagnostics));
    REQUIRE(parsed);
    return *parsed;
  };
  const FileSyntax old = syntax(before);
  const FileSyntax now = syntax(after);
  std::string text;
  for (const KeyChange& change : changed_keys(old, now, renames)) {
    const std::string key = change.is_reordering ? "order" : text_of(change.path);
    text += change.entry + (key.empty() ? "" : " " + key) + ": " + change.before + " -> " +
            change.after + "\n";
  }
  return text;
}

}  // namespace

TEST_CASE("one item of a list is one change at its position") {
  const std::string after = replaced(cart, "\"-g\"", "\"g\"");
  CHECK(key_changes(cart, after) == "[gravity] vector[2]: -g -> g\n");
  const FileSyntax old = *parse_model(make_source("a.toml", cart), {});
  const FileSyntax now = *parse_model(make_source("b.toml", after), {});
  const KeyChange change = changed_keys(old, now).at(0);
  CHECK(line_column(*change.new_span.source, change.new_span.begin).line == 56);
  CHECK(line_column(*change.new_span.source, change.new_span.begin).column == 17);
}

TEST_CASE("blanks, comments, brackets and the order of keys are no change") {
  CHECK(key_changes(cart, cart + "# more\n").empty());
  CHECK(key_changes(spring("1/2*k*x^2"), spring("(1/2*k) * x^2")) ==
        "[energy] V: 1/2*k*x^2 -> (1/2*k) * x^2\n");
  CHECK(key_changes(spring("1/2*k*x^2"), spring(" 1/2 * k*(x)^2 ")).empty());
  CHECK(key_changes(spring(), replaced(spring(), "k = 3", "k = { value = 3 }")).empty());
}

TEST_CASE("entries are matched by name, and a new or removed entry is one change") {
  const std::string point =
      "[[point]]\nname = \"bob\"\nat   = [\"x + l*sin(theta)\", "
      "\"l*cos(theta)\"]\nmass = \"m\"\njoined_to = \"cart\"\n";
  const std::string without = replaced(cart, point, "");
  CHECK(key_changes(cart, without) ==
        "[[point]] bob: { name = bob, at = [x + l*sin(theta), l*cos(theta)], mass = m, joined_to = "
        "cart } -> \n");
  CHECK(key_changes(without, cart) ==
        "[[point]] bob:  -> { name = bob, at = [x + l*sin(theta), l*cos(theta)], mass = m, "
        "joined_to = cart }\n");
}

TEST_CASE("forces without names are identified by their target, then by number") {
  const std::string force = "[[force]]\non = \"x\"\nvalue = \"-m*dot(x)\"\n";
  const std::string other = "[[force]]\non = \"x\"\nvalue = \"-2*m*dot(x)\"\n";
  CHECK(key_changes(spring() + force + force, spring() + force + other) ==
        "[[force]] on x #2 value: -m*dot(x) -> -2*m*dot(x)\n");
}

TEST_CASE("another order of coordinates or parameters is reported, of keys not") {
  CHECK(key_changes(spring(), replaced(replaced(spring(), "k = 3\n", ""), "m = {",
                                       "k = 3\nm = {")) == "[parameters] order: m, k -> k, m\n");
}

TEST_CASE("with a given renaming there are no changes") {
  std::string after = spring("1/2*c*x^2");
  after = replaced(after, "k = 3", "c = 3");
  CHECK(key_changes(spring(), after, {{"k", "c"}}).empty());
  CHECK(key_changes(spring(), after) ==
        "[parameters] c:  -> 3\n[parameters] k: 3 -> \n[energy] V: 1/2*k*x^2 -> 1/2*c*x^2\n");
}

TEST_CASE("names change at declarations and at uses") {
  const FileSyntax syntax = *parse_model(make_source("model.toml", spring()), {});
  const std::string text = dump(apply_renames(syntax, {{"x", "s"}, {"m", "mass"}}));
  CHECK(mentions(text, "dot(s)"));
  CHECK(mentions(text, "mass"));
  CHECK_FALSE(mentions(text, "dot(x)"));
  CHECK(dump(apply_renames(syntax, {})) == dump(syntax));
}

TEST_CASE("keys of a scene that are names are renamed, too") {
  const std::string scene =
      "format = 1\nmodel = \"m.toml\"\nname = \"fast\"\n[parameters]\n"
      "fixed = { m = 2 }\n[lock]\nx = { value = 0 }\n";
  const FileSyntax syntax = *parse_scene(make_source("a.scene.toml", scene), {});
  const FileSyntax now = apply_renames(syntax, {{"m", "mass"}, {"x", "s"}, {"value", "v"}});
  CHECK(mentions(dump(now), "mass"));
  CHECK(now.entries.back().keys.front().key == "s");
  CHECK(now.entries.back().keys.front().value.entries.front().key == "value");
}

TEST_CASE("changed equations are printed as written, and their order is reported") {
  const std::string one = held_plane(held_rod);
  CHECK(key_changes(one, replaced(one, "x^2 + y^2 = 1", "x^2 + 2*y^2 = 1")) ==
        "[[constraint]] rod equation: x^2 + y^2 = 1 -> x^2 + 2*y^2 = 1\n");
  CHECK(key_changes(one, replaced(one, "x^2 + y^2 = 1", "x^2+y^2 = 1")).empty());
  const std::string two = replaced(one, "\"x^2 + y^2 = 1\"", "[\"x^2 + y^2 = 1\", \"z = y\"]");
  CHECK(key_changes(two, replaced(two, "z = y", "z = x")) ==
        "[[constraint]] rod equation[2]: z = y -> z = x\n");
  CHECK(key_changes(held_plane(""), one) ==
        "[[constraint]] rod:  -> { name = rod, equation = x^2 + y^2 = 1 }\n");
  CHECK(key_changes(held_plane(held_rod + held_slot), held_plane(held_slot + held_rod)) ==
        "[[constraint]] order: rod, slot -> slot, rod\n");
}

TEST_CASE("a state of an expectation is compared key by key, and its rates are renamed") {
  const std::string text = spring() + "[[expect]]\nat = { x = 1, \"dot(x)\" = 2 }\ngravity = [3]\n";
  CHECK(key_changes(text, replaced(text, "{ x = 1", "{ x = 4")) == "[[expect]] #1 at.x: 1 -> 4\n");
  const FileSyntax syntax = *parse_model(make_source("model.toml", text), {});
  const FileSyntax now = apply_renames(syntax, {{"x", "s"}});
  const std::vector<KeySyntax>& at = now.entries.back().keys.front().value.entries;
  CHECK(at.front().key == "s");
  CHECK(at.back().key == "dot(s)");
}
