// models/REFERENCE.md: a section for each entry, with a table of its keys and their details.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <concepts>
#include <variant>

#include "elgen/syntax.hpp"
#include "elgen/wording.hpp"

namespace elgen {
namespace {

/// The words for the type of a value, in the order of KeyType.
constexpr std::array<std::string_view, 24> type_words{"expression",
                                                      "[expressions]",
                                                      "expression or list",
                                                      "expression or table",
                                                      "expression, list, matrix",
                                                      "name",
                                                      "text",
                                                      "one of",
                                                      "word, or list of",
                                                      "unit",
                                                      "\"i in 1..n\"",
                                                      "\"a > b\"",
                                                      "\"a = b\", or list of such",
                                                      "integer",
                                                      "true or false",
                                                      "[low, high]",
                                                      "[[axis, angle], ...]",
                                                      "table",
                                                      "value or table",
                                                      "true, word or table",
                                                      "true or expression",
                                                      "text or table",
                                                      "text, list or table",
                                                      "symbol"};
static_assert(type_words.size() == static_cast<std::size_t>(KeyType::latex_symbol) + 1);

constexpr std::string_view introduction = R"(# Reference of model and scene files

All entries and their keys. [README.md](README.md) is the guide, with examples. `elgen explain ENTRY` prints the
same texts, and `elgen schema` gives them to editors. The CMake target `reference` writes this page from the
[key table](../src/parse/key_table.cpp).

A key of a table inside an entry is written with a dot: `start.value` of `start = { value = 1 }`. NAME is a name
that the file chooses or refers to. Codes such as E112 are explained by `elgen explain E112`.
)";

/// Lines of the page have 120 characters, 2 of them the indent of a list.
constexpr std::size_t page_width = 118;

/// True if `entry` stands for the top-level keys of model or scene files. The section of `entry`
/// then does not include the keys of tables.
bool is_top_level(std::string_view entry) { return entry.empty() || entry == "scene"; }

bool belongs_to_entry(const KeyRow& key, std::string_view entry) {
  if (key.entry == entry) return true;
  return !is_top_level(entry) && key.entry.starts_with(fmt::format("{}.", entry));
}

/// The path of a key within `entry`: "start.value" for the key `value` of "coordinate.start" within
/// "coordinate". "NAME" replaces "*".
std::string path_in_entry(const KeyRow& key, std::string_view entry) {
  std::string path = fmt::format("{}.{}", key.entry, key.key);
  path.erase(0, entry.size() + 1);
  const std::size_t star = path.find('*');
  return star == std::string::npos ? path : path.replace(star, 1, "NAME");
}

std::string type_cell(const KeyRow& key) {
  const std::vector<std::string_view> words = choice_words(key);
  if (words.empty()) return std::string(type_text(key.type));
  return fmt::format("{} `\"{}\"`", type_text(key.type), fmt::join(words, "\"`, `\""));
}

std::string default_cell(const KeyRow& key) {
  if (key.required) return "required";
  const bool is_worded = std::holds_alternative<DefaultInWords>(key.default_value);
  const std::string text = default_text(key);
  return is_worded || text.empty() ? text : fmt::format("`{}`", text);
}

std::string entry_section(const std::string& heading, const EntryRow& entry) {
  std::string rows;
  std::string details;
  for (const KeyRow& key : key_table()) {
    if (!key.supported || !belongs_to_entry(key, entry.entry)) continue;
    const std::string path = path_in_entry(key, entry.entry);
    rows +=
        fmt::format("| `{}` | {} | {} | {} |\n", path, type_cell(key), default_cell(key), key.doc);
    if (key.details.empty()) continue;
    details += break_lines(fmt::format("- `{}`: {}", path, key.details), page_width, "  ") + "\n";
  }
  std::string doc = fmt::format("{}. {}", entry.doc, entry.details);
  if (doc[0] >= 'a' && doc[0] <= 'z') doc[0] = static_cast<char>(doc[0] - 'a' + 'A');
  if (doc.ends_with(' ')) doc.pop_back();
  const std::string text =
      fmt::format("\n### {}\n\n{}\n", heading, break_lines(doc, page_width, ""));
  if (rows.empty()) return text;
  return fmt::format("{}\n| key | type | default | meaning |\n|---|---|---|---|\n{}{}{}", text,
                     rows, details.empty() ? "" : "\n", details);
}

}  // namespace

std::string_view type_text(KeyType type) { return type_words[static_cast<std::size_t>(type)]; }

std::string default_text(const KeyRow& row) {
  return std::visit(
      []<class Value>(const Value& value) -> std::string {
        if constexpr (std::same_as<Value, std::monostate>) {
          return {};
        } else if constexpr (std::same_as<Value, DefaultInWords>) {
          return std::string(value.text);
        } else if constexpr (std::same_as<Value, std::string_view>) {
          return fmt::format("\"{}\"", value);
        } else {
          return fmt::to_string(value);
        }
      },
      row.default_value);
}

std::string header_text(const EntryRow& row) {
  const std::string_view scene = "scene.";
  const bool is_of_scene = row.entry.starts_with(scene);
  return fmt::format(fmt::runtime(row.repeated ? "[[{}]]" : "[{}]"),
                     row.entry.substr(is_of_scene ? scene.size() : 0));
}

std::string reference_page() {
  std::string page(introduction);
  page +=
      "\n## Model files\n" +
      entry_section("Top of a model file", {.entry = "", .doc = "keys before the first header"});
  bool is_model = true;
  for (const EntryRow& row : entry_table()) {
    const bool is_of_scene = row.entry.starts_with("scene.");
    if (is_model && is_of_scene) {
      page += "\n## Scene files\n" +
              entry_section("Top of a scene file",
                            {.entry = "scene", .doc = "keys before the first header"});
      is_model = false;
    }
    page += entry_section(fmt::format("`{}`{}", header_text(row), is_of_scene ? " of a scene" : ""),
                          row);
  }
  return page;
}

}  // namespace elgen
