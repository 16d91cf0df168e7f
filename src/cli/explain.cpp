// elgen explain NAME: what an error code means and how to mend it, or the keys of an entry of model
// and scene files (`coordinate`, `scene.outputs`).
#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>

#include "base/diagnostic_words.hpp"
#include "cli/commands.hpp"
#include "elgen/syntax.hpp"
#include "elgen/wording.hpp"

namespace elgen::cli {
namespace {

/// In the order of KeyType.
constexpr std::array<std::string_view, 18> kinds{"expression",
                                                 "[expressions]",
                                                 "expression or list",
                                                 "expression or table",
                                                 "expression, list, matrix",
                                                 "name",
                                                 "text",
                                                 "one of",
                                                 "list of",
                                                 "unit",
                                                 "\"i in 1..n\"",
                                                 "integer",
                                                 "true or false",
                                                 "[low, high]",
                                                 "[[axis, angle], ...]",
                                                 "table",
                                                 "true or table",
                                                 "text or table"};
static_assert(kinds.size() == static_cast<std::size_t>(KeyType::text_or_table) + 1);

using Json = nlohmann::ordered_json;

std::vector<std::string_view> choices_of(const KeyRow& key) {
  std::vector<std::string_view> words;
  for (const ChoiceRow& choice : choice_table()) {
    if (choice.entry == key.entry && choice.key == key.key) words.push_back(choice.word);
  }
  return words;
}

std::string choices_text(const KeyRow& key) {
  const std::vector<std::string_view> words = choices_of(key);
  return words.empty() ? "" : fmt::format(" (\"{}\")", fmt::join(words, "\", \""));
}

Json json_of(const KeyRow& key) {
  Json json{{"entry", key.entry},
            {"key", key.key},
            {"type", kinds[static_cast<std::size_t>(key.type)]},
            {"doc", key.doc},
            {"required", key.required},
            {"supported", key.supported}};
  const std::vector<std::string_view> words = choices_of(key);
  if (!words.empty()) json["words"] = words;
  return json;
}

Json json_of(const CodeRow& row) {
  return {{"code", row.name},
          {"severity", severity_word(row.severity)},
          {"exit_code", static_cast<int>(row.exit_code)},
          {"title", row.title},
          {"explanation", row.explanation}};
}

std::string key_line(const KeyRow& key) {
  const std::string_view name = key.key == "*" ? "NAME" : key.key;
  return fmt::format("  {:<14} {:<24} {}{}{}{}\n", name, kinds[static_cast<std::size_t>(key.type)],
                     key.doc, choices_text(key), key.required ? "; required" : "",
                     key.supported ? "" : "; not yet supported");
}

/// `[[frame]]`, and `frame.dh` for a table inside it.
std::string header(const std::string& name) {
  for (const EntryRow& entry : entry_table()) {
    if (entry.entry != name) continue;
    const bool is_of_scene = name.rfind("scene.", 0) == 0;
    const std::string inner = is_of_scene ? name.substr(6) : name;
    return fmt::format("{}{}{}: {}\n", entry.repeated ? "[[" : "[", inner,
                       entry.repeated ? "]]" : "]", entry.doc);
  }
  return name + "\n";
}

/// Of an entry and of the tables inside it.
std::vector<KeyRow> keys_of_entry(const std::string& name) {
  std::vector<KeyRow> keys;
  for (const KeyRow& key : key_table()) {
    const bool is_inside = key.entry.substr(0, name.size() + 1) == name + ".";
    if (name.empty() || (key.entry != name && (!is_inside || name == "scene"))) continue;
    keys.push_back(key);
  }
  return keys;
}

std::string text_of(const std::vector<KeyRow>& keys) {
  std::string text;
  std::string_view last;
  for (const KeyRow& key : keys) {
    if (key.entry != last)
      text += (text.empty() ? "" : "\n") + header(std::string(key.entry)) + "\n";
    last = key.entry;
    text += key_line(key);
  }
  return text;
}

/// Every code, and every entry that stands in a file under a header of its own.
std::vector<std::string> known_names() {
  std::vector<std::string> names;
  for (const EntryRow& entry : entry_table()) names.emplace_back(entry.entry);
  for (const CodeRow& code : code_table()) names.emplace_back(code.name);
  return names;
}

ExitCode explain(const GlobalOptions& global, const std::string& name) {
  if (const CodeRow* row = find_code(name)) {
    return print(global, wants_json(global) ? json_of(*row).dump(2) + "\n"
                                            : fmt::format("{}: {}\n\n{}\n", row->name, row->title,
                                                          row->explanation));
  }
  const std::vector<KeyRow> keys = keys_of_entry(name);
  if (!keys.empty()) {
    Json list = Json::array();
    for (const KeyRow& key : keys) list.push_back(json_of(key));
    return print(global, wants_json(global) ? list.dump(2) + "\n" : text_of(keys));
  }
  return report(global, {{Code::E913,
                          {},
                          fmt::format("`{}` is neither an error code nor an entry", name),
                          suggestion(name, known_names())}});
}

}  // namespace

void add_explain(CLI::App& app, Action& action) {
  CLI::App* command =
      app.add_subcommand("explain", "what an error code or an entry of a model means");
  const auto name = std::make_shared<std::string>();
  command->add_option("name", *name, "E201, coordinate, scene.outputs")->required();
  set_action(*command, action, name, &explain);
}

}  // namespace elgen::cli
