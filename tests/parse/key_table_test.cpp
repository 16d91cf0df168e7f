// Rules of the key table: no duplicate rows, an entry for each row, words for each choice. The text
// of a syntax tree contains every key with its value.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <set>
#include <vector>

#include "elgen/syntax.hpp"
#include "parse_testing.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

bool is_choice(const KeyRow& row) {
  return row.type == KeyType::choice || row.type == KeyType::choice_list;
}

using Lines = std::vector<std::string>;

std::string assigned(const KeyRow& row, const std::string& value) {
  return (row.key == "*" ? "n" : std::string(row.key)) + " = " + value;
}

Lines words_of(const KeyRow& row) {
  Lines words;
  for (const ChoiceRow& choice : choice_table()) {
    if (choice.entry == row.entry && choice.key == row.key) {
      words.push_back('"' + std::string(choice.word) + '"');
    }
  }
  return words;
}

std::string inside(const KeyRow& row) { return fmt::format("{}.{}", row.entry, row.key); }

std::string table_of(const KeyRow& row, bool has_more);

/// One of two different values of the key's type, selected by `which`.
std::string value_of(const KeyRow& row, std::size_t which) {
  const auto either = [which](const char* first, const char* second) {
    return std::string(which == 0 ? first : second);
  };
  switch (row.type) {
    case KeyType::expression:
    case KeyType::expression_or_list:
    case KeyType::value_or_table:
    case KeyType::expression_or_table:
    case KeyType::closed_form:
      return either("1", "\"x + 1\"");
    case KeyType::integer:
      return either("1", "2");
    case KeyType::expression_list:
      return either("[1]", "[1, 2]");
    case KeyType::name:
    case KeyType::text:
    case KeyType::latex_symbol:
    case KeyType::unit:
    case KeyType::text_or_table:
    case KeyType::names_or_table:
      return either("\"m\"", "\"s\"");
    case KeyType::choice:
      return words_of(row).at(which);
    case KeyType::choice_list:
      return "[" + words_of(row).at(which) + "]";
    case KeyType::repetition:
      return either("\"i in 1..2\"", "\"i in 1..3\"");
    case KeyType::equations:
      return either("\"x = 1\"", "[\"x = 1\", \"y = 2\"]");
    case KeyType::condition:
      return either("\"x > 1\"", "\"x < 1\"");
    case KeyType::boolean:
    case KeyType::boolean_or_expression:
    case KeyType::output_request:
      return either("true", "false");
    case KeyType::range:
      return either("[0, 1]", "[0, 2]");
    case KeyType::turns:
      return either("[[\"x\", 1]]", "[[\"x\", 2]]");
    case KeyType::table:
      return table_of(row, which == 1);
  }
  return {};
}

/// The required keys of `entry`; `text` replaces the key of `row`, and "" leaves this key out.
Lines keys_of(std::string_view entry, const KeyRow& row, const std::string& text) {
  Lines keys;
  for (const KeyRow& other : key_table()) {
    if (&other == &row && !text.empty()) keys.push_back(text);
    if (&other == &row || other.entry != entry || !other.required) continue;
    keys.push_back(assigned(other, value_of(other, 0)));
  }
  return keys;
}

std::string table_of(const KeyRow& row, bool has_more) {
  const std::string entry = inside(row);
  Lines keys = keys_of(entry, row, "");
  for (const KeyRow& key : key_table()) {
    if (!has_more || key.entry != entry || key.required) continue;
    keys.push_back(assigned(key, value_of(key, 0)));
  }
  return fmt::format("{{{}}}", fmt::join(keys, ", "));
}

std::string section(const EntryRow& entry, const std::string& name, const Lines& keys) {
  return fmt::format(fmt::runtime(entry.repeated ? "[[{}]]\n{}\n" : "[{}]\n{}\n"), name,
                     fmt::join(keys, "\n"));
}

/// The smallest file in which the key of `row` is set by `text`, possibly in an inline table.
std::string file_with(const KeyRow& row, const std::string& text) {
  for (const KeyRow& outer : key_table()) {
    if (inside(outer) != row.entry) continue;
    const Lines keys = keys_of(row.entry, row, text);
    return file_with(outer, assigned(outer, fmt::format("{{{}}}", fmt::join(keys, ", "))));
  }
  const bool is_scene = row.entry.starts_with("scene");
  std::string file =
      fmt::format("{}\n", fmt::join(keys_of(is_scene ? "scene" : "", row, ""), "\n"));
  if (row.entry.empty() || row.entry == "scene") file += text + "\n";
  for (const EntryRow& entry : entry_table()) {
    const bool is_needed = entry.required && !is_scene;
    if (!is_needed && entry.entry != row.entry) continue;
    const std::string name(entry.entry.substr(is_scene ? 6 : 0));
    file += section(entry, name, keys_of(entry.entry, row, entry.entry == row.entry ? text : ""));
  }
  return file;
}

std::string dumped(const KeyRow& row, const std::string& file) {
  const bool is_scene = row.entry.starts_with("scene");
  std::string text = is_scene ? scene_answer(file) : model_answer(file);
  INFO(file);
  CHECK(text.starts_with("[]"));
  return text;
}

std::string with_blanks(const std::string& file) {
  std::string text = "# nothing\n\n";
  for (const char c : file)
    text += c == '\n' ? "  # a comment\n\n" : c == '=' ? " = " : std::string(1, c);
  return text;
}

}  // namespace

TEST_CASE("no key has two rows", "[parse]") {
  std::set<std::pair<std::string_view, std::string_view>> seen;
  for (const KeyRow& row : key_table()) {
    INFO(row.entry << "." << row.key);
    CHECK(seen.emplace(row.entry, row.key).second);
    CHECK_FALSE(row.doc.empty());
    CHECK((row.supported || !row.required));
    if (row.key != "*")
      CHECK(std::holds_alternative<std::monostate>(row.default_value) == row.required);
  }
}

TEST_CASE("the reference has a section for every entry and a row for every key", "[parse]") {
  const std::string reference = reference_page();
  for (const EntryRow& entry : entry_table()) {
    CHECK(mentions(reference, "\n### `" + header_text(entry) + "`"));
  }
  CHECK(mentions(reference, "\n| `start.rate` | expression or list | `0` | v_i at the start |\n"));
  CHECK(mentions(reference, "\n| `NAME.value` | expression or list | required | "));
  CHECK_FALSE(mentions(reference, "\n- `zeta`"));  // its path is `stabilise.zeta`
}

TEST_CASE("every row belongs to an entry or to a key that is a table", "[parse]") {
  for (const KeyRow& row : key_table()) {
    INFO(row.entry << "." << row.key);
    const bool top = row.entry.empty() || row.entry == "scene";
    const bool entry = std::any_of(entry_table().begin(), entry_table().end(),
                                   [&](const EntryRow& e) { return e.entry == row.entry; });
    const bool key = std::any_of(key_table().begin(), key_table().end(), [&](const KeyRow& k) {
      return std::string(k.entry) + "." + std::string(k.key) == row.entry;
    });
    CHECK((top || entry || key));
  }
}

TEST_CASE("every supported entry has keys, and every choice has words", "[parse]") {
  for (const EntryRow& entry : entry_table()) {
    const std::string_view owner = entry_of_keys(entry.entry);
    const bool has_keys = std::any_of(key_table().begin(), key_table().end(),
                                      [&](const KeyRow& k) { return k.entry == owner; });
    INFO(entry.entry);
    CHECK(has_keys == entry.supported);
  }
  for (const KeyRow& row : key_table()) {
    const bool has_words =
        std::any_of(choice_table().begin(), choice_table().end(),
                    [&](const ChoiceRow& c) { return c.entry == row.entry && c.key == row.key; });
    INFO(row.entry << "." << row.key);
    CHECK(has_words == is_choice(row));
  }
}

TEST_CASE("an entry of scenes without keys has the keys of the entry of models", "[parse]") {
  CHECK(entry_of_keys("scene.frame") == "frame");
  CHECK(entry_of_keys("scene.outputs") == "scene.outputs");
  CHECK(entry_of_keys("frame") == "frame");
  CHECK(entry_of_keys("scene.coordinate") == "scene.coordinate");  // scenes have no such entry
  const std::string head = "format = 1\nmodel = \"m.toml\"\nname = \"s\"\n";
  CHECK(scene_answer(head + "[[frame]]\nname = \"f\"\nparent = \"g\"\nrpy = [0, 0, 1]\n") ==
        "[]\n  format = 1\n  model = \"m.toml\"\n  name = s\n"
        "[frame]\n  name = f\n  parent = g\n  rpy = [0, 0, 1]\n");
  CHECK(scene_answer(head + "[[frame]]\nname = \"f\"\nparent = \"g\"\nmass = 1\n") == "E103 7:1");
  CHECK(mentions(reference_page(), "\n### `[[frame]]` of a scene\n\nA tool, "));
}

TEST_CASE("a model prints in file order, whatever its white space", "[parse]") {
  CHECK(model_answer("format = 1\n\n[model]\nname = \"m\"\ntitle = \"a \\\"b\\\"\\nc\"\n"
                     "[[coordinate]]\nname = \"q[i]\"\nfor = \"i in 1..2\"\nwrap = true\n"
                     "start = {value = \"pi/4\"}\n") ==
        "[]\n  format = 1\n[model]\n  name = m\n  title = \"a \\\"b\\\" c\"\n"
        "[coordinate]\n  name = q[i]\n  for = [{index = i, low = 1, high = 2}]\n"
        "  wrap = true\n  start = {value = (pi / 4)}\n");
}

TEST_CASE("a scene prints in file order", "[parse]") {
  CHECK(scene_answer("format = 1\nmodel = \"../m.toml\"\nname = \"s\"\n[outputs]\n"
                     "bias = true\ngravity = {rename = \"g\"}\n[sizes]\nn = 3\n") ==
        "[]\n  format = 1\n  model = \"../m.toml\"\n  name = s\n[outputs]\n"
        "  bias = true\n  gravity = {rename = g}\n[sizes]\n  n = 3\n");
}

TEST_CASE("the text contains every key with its value, but no white space or comments") {
  for (const KeyRow& row : key_table()) {
    if (!row.supported || row.key == "format") continue;  // `format` has only one value
    INFO(inside(row));
    const std::string file = file_with(row, assigned(row, value_of(row, 0)));
    const std::string text = dumped(row, file);
    CHECK(text != dumped(row, file_with(row, assigned(row, value_of(row, 1)))));
    CHECK(text == dumped(row, with_blanks(file)));
    if (!row.required) CHECK(text != dumped(row, file_with(row, "")));
  }
}
