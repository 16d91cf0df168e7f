// The choice table: the permitted words of keys, and the words of former versions.
#include <algorithm>
#include <array>

#include "elgen/syntax.hpp"

namespace elgen {

namespace {

constexpr std::string_view trigonometry_entry = "scene.numeric.trigonometry";

constexpr auto choice_rows = std::to_array<ChoiceRow>({
    {trigonometry_entry, "scalar", "in-line"},
    {trigonometry_entry, "scalar", "library"},
    {"coordinate", "kind", "scalar"},
    {"coordinate", "kind", "rotation"},
    {"frame.dh", "convention", "standard"},
    {"frame.dh", "convention", "modified"},
    {"parameters.*", "assume", "positive"},
    {"parameters.*", "assume", "nonnegative"},
    {"body", "inertia_about", "com"},
    {"body", "inertia_about", "origin"},
    {"point", "as", "rod"},
    {"point", "as", "spring"},
    {"constraint", "kind", "position"},
    {"constraint", "kind", "velocity"},
    {"scene.numeric", "scalar", "float"},
    {"scene.numeric", "scalar", "double"},
    {"scene.numeric", "scalar", "long double"},
    {"scene.numeric", "inner", "double"},
    {"scene.numeric", "inner", "long double"},
    {"scene.numeric", "inner", "double-double"},
    {"scene.numeric", "inner", "float"},
    {"scene.numeric", "form", "closed"},
    {"scene.numeric", "form", "recursive"},
    {"scene.numeric", "prefer", "balanced"},
    {"scene.numeric", "prefer", "speed"},
    {"scene.outputs.*", "form", "closed"},
    {"scene.outputs.*", "form", "recursive"},
    {"scene.emit", "storage", "row-major"},
    {"scene.emit", "storage", "column-major"},
    {"scene.emit", "files", "header"},
    {"scene.emit", "files", "equations"},
    {"scene.emit", "files", "page"},
#define ELGEN_LANGUAGE(id, name, ...) {"scene.emit", "language", name},
#include "elgen/languages.def"
#undef ELGEN_LANGUAGE
});

/// A former word of a choice, and the hint on its replacement.
struct FormerChoice {
  ChoiceRow choice;
  std::string_view hint;
};

constexpr std::array former_choices{
    FormerChoice{{"scene.numeric", "prefer", "accuracy"},
                 "`inner = \"double-double\"` adds functions that compute in more digits"}};

}  // namespace

std::span<const ChoiceRow> choice_table() { return choice_rows; }

std::vector<std::string_view> choice_words(const KeyRow& row) {
  std::vector<std::string_view> words;
  for (const ChoiceRow& each : choice_rows) {
    if (each.entry == row.entry && each.key == row.key) words.push_back(each.word);
  }
  return words;
}

std::string_view former_choice_hint(const KeyRow& row, std::string_view word) {
  for (const auto& [choice, hint] : former_choices) {
    if (choice.entry == row.entry && choice.key == row.key && choice.word == word) return hint;
  }
  return {};
}

}  // namespace elgen
