// elgen explain NAME: explains an error code, an output, a function of the model language, a name
// in
// [[expect]], or a command. If NAME is an entry of model or scene files (`coordinate`,
// `scene.outputs`), lists its keys; if NAME is a key, lists this key of all entries.
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "base/diagnostic_words.hpp"
#include "base/json.hpp"
#include "base/reason.hpp"
#include "cli/commands.hpp"
#include "elgen/functions.hpp"
#include "elgen/outputs.hpp"
#include "elgen/syntax.hpp"
#include "elgen/wording.hpp"
#include "emit/interface/code_interface.hpp"

namespace elgen::cli {
namespace {

/// Lines of details break at this column, so that they stay readable on wide terminals.
constexpr std::size_t page_width = 100;

/// A name with one paragraph.
struct NameRow {
  std::string_view name;
  std::string_view noun;
  std::string_view doc;
};

/// Names that [[expect]] may use, although no model declares them, and the commands.
constexpr std::array name_table{
    NameRow{
        "E", "a name in [[expect]]",
        "In `conserved` of `[[expect]]` the energy function v dL/dv - L, unless the model declares "
        "a name `E`. `energy_function` is the same quantity in every model."},
    NameRow{"p", "a name in [[expect]]",
            "In `[[expect]]` `p(NAME)` is the momentum dL/d(dot(NAME)) of a coordinate. For a "
            "rotation `p(NAME[k])` is the momentum about axis k of the body. It is allowed in "
            "`conserved` and in outputs that take momenta. A name `p` of the model takes "
            "precedence."},
#define ELGEN_COMMAND(name) \
  NameRow{#name, "a command", "`elgen " #name " --help` lists its options."},
#include "cli/commands.def"
#undef ELGEN_COMMAND
};

std::string choices_text(const KeyRow& key) {
  const std::vector<std::string_view> words = choice_words(key);
  return words.empty() ? "" : fmt::format(" (\"{}\")", fmt::join(words, "\", \""));
}

Json json_of(const KeyRow& key) {
  Json json{{"entry", key.entry},           {"key", key.key},
            {"type", type_text(key.type)},  {"doc", key.doc},
            {"default", default_text(key)}, {"details", key.details},
            {"required", key.required},     {"supported", key.supported}};
  const std::vector<std::string_view> words = choice_words(key);
  if (!words.empty()) json["words"] = words;
  return json;
}

Json json_of(const CodeRow& row) {
  return {{"code", row.name},
          {"severity", severity_word(row.severity)},
          {"exit_code", static_cast<int>(row.exit_code)},
          {"title", row.title},
          {"explanation", row.explanation},
          {"reasons", reasons_of(row.code)}};
}

Json json_of(const OutputRow& row) {
  return {{"output", row.name}, {"doc", row.doc}, {"equation", row.equation.text}};
}

Json json_of(const FunctionRow& row) {
  return {{"function", row.name},
          {"arguments", row.arity},
          {"forces_only", row.use == FunctionUse::forces_only}};
}

Json json_of(const NameRow& row) { return {{"name", row.name}, {"doc", row.doc}}; }

Json json_of(const CallRow& row) {
  return {{"function", row.name}, {"usage", row.usage}, {"doc", row.doc}};
}

std::string text_of(const CodeRow& row) {
  const std::vector<std::string_view> reasons = reasons_of(row.code);
  std::string text = fmt::format("{}: {}\n\n{}\n", row.name, row.title,
                                 break_lines(row.explanation, page_width, ""));
  if (!reasons.empty()) text += "\nReasons:\n";
  for (const std::string_view reason : reasons) {
    text += "- " + break_lines(reason, page_width - 2, "  ") + "\n";
  }
  return text;
}

std::string text_of(const OutputRow& row) {
  const std::string equation =
      row.equation.text.empty() ? "" : fmt::format("\n  {}\n", row.equation.text);
  return fmt::format("{}: an output\n\n{}\n{}", row.name, row.doc, equation);
}

std::string text_of(const FunctionRow& row) {
  return fmt::format(
      "{}: a function of {}{}\n", row.name, count_text(row.arity, "argument"),
      row.use == FunctionUse::forces_only
          ? ", only allowed in forces because it has a kink; its argument may have a unit"
          : "");
}

std::string text_of(const NameRow& row) {
  return fmt::format("{}: {}\n\n{}\n", row.name, row.noun, row.doc);
}

std::string text_of(const CallRow& row) {
  return fmt::format("{}: a function of expressions\n\n{}: {}\n", row.name, row.usage, row.doc);
}

/// The details in lines that begin with `indent`; "" if there are no details.
std::string details_text(std::string_view details, const std::string& indent) {
  if (details.empty()) return {};
  return indent + break_lines(details, page_width - indent.size(), indent) + "\n";
}

std::string key_line(const KeyRow& key) {
  const std::string_view name = key.key == "*" ? "NAME" : key.key;
  const std::string value = default_text(key);
  const std::string otherwise = value.empty() ? "" : fmt::format("; default: {}", value);
  return fmt::format("  {:<14} {:<24} {}{}{}{}\n{}", name, type_text(key.type), key.doc,
                     choices_text(key), key.required ? "; required" : otherwise,
                     key.supported ? "" : "; not yet supported",
                     details_text(key.details, std::string(17, ' ')));
}

/// The header and the doc of an entry: "[[frame]]: ...". For a table inside an entry, only the name
/// of the table: "frame.dh".
std::string entry_header(const std::string& name) {
  for (const EntryRow& entry : entry_table()) {
    if (entry.entry != name) continue;
    return fmt::format("{}: {}\n{}", header_text(entry), entry.doc,
                       details_text(entry.details, "  "));
  }
  return name + "\n";
}

/// The keys of the entry `name` and of the tables inside this entry. If models have no entry
/// `name`, the keys of the entry of scenes: `routh` means `scene.routh`.
std::vector<KeyRow> keys_of_entry(const std::string& name) {
  std::vector<KeyRow> keys;
  for (const KeyRow& key : key_table()) {
    const bool is_inside = key.entry.substr(0, name.size() + 1) == name + ".";
    if (name.empty() || (key.entry != name && (!is_inside || name == "scene"))) continue;
    keys.push_back(key);
  }
  const bool is_of_scene = name.empty() || name.rfind("scene.", 0) == 0;
  return keys.empty() && !is_of_scene ? keys_of_entry("scene." + name) : keys;
}

std::string text_of(const std::vector<KeyRow>& keys) {
  std::string text;
  std::string_view last;
  for (const KeyRow& key : keys) {
    if (key.entry != last)
      text += (text.empty() ? "" : "\n") + entry_header(std::string(key.entry)) + "\n";
    last = key.entry;
    text += key_line(key);
  }
  return text;
}

/// All names that `explain` knows, except tables inside entries.
std::vector<std::string> known_names() {
  std::vector<std::string> names = column_words(entry_table(), &EntryRow::entry);
  for (const CodeRow& code : code_table()) names.emplace_back(code.name);
  for (const OutputRow& output : output_table()) {
    if (!output.is_user_output) names.emplace_back(output.name);
  }
  for (const FunctionRow& function : function_table()) names.emplace_back(function.name);
  for (const NameRow& word : name_table) names.emplace_back(word.name);
  for (const CallRow& call : call_table()) names.emplace_back(call.name);
  for (const KeyRow& key : key_table()) {
    if (key.key != "*") names.emplace_back(key.key);
  }
  return names;
}

template <class Row>
ExitCode print_row(const GlobalOptions& global, const Row& row) {
  return print(global, wants_json(global) ? json_of(row).dump(2) + "\n" : text_of(row));
}

ExitCode print_keys(const GlobalOptions& global, const std::vector<KeyRow>& keys,
                    const std::string& text) {
  Json list = Json::array();
  for (const KeyRow& key : keys) list.push_back(json_of(key));
  return print(global, wants_json(global) ? list.dump(2) + "\n" : text);
}

ExitCode explain(const GlobalOptions& global, const std::string& name) {
  if (const CodeRow* row = find_code(upper_case(name))) return print_row(global, *row);
  const std::string owner(entry_of_keys(name));
  const std::vector<KeyRow> keys = keys_of_entry(owner);
  const OutputRow* const output = find_output(name);
  if (!keys.empty()) {
    // If an entry and an output have the same name, such as `gravity`, both are printed.
    return print_keys(global, keys,
                      (owner == name ? "" : entry_header(name) + "\n") + text_of(keys) +
                          (output == nullptr ? "" : "\n" + text_of(*output)));
  }
  if (output != nullptr) return print_row(global, *output);
  if (const FunctionRow* row = find_function(name)) return print_row(global, *row);
  if (const CallRow* row = find_call(name)) return print_row(global, *row);
  const auto word = std::ranges::find(name_table, name, &NameRow::name);
  if (word != name_table.end()) return print_row(global, *word);
  std::vector<KeyRow> named(key_table().begin(), key_table().end());
  std::erase_if(named, [&name](const KeyRow& key) { return key.key != name || name == "*"; });
  if (!named.empty()) return print_keys(global, named, text_of(named));
  return report(global,
                {{Reason::nothing_to_explain,
                  {},
                  fmt::format("`{}` is no code, entry, key, output, function or command", name),
                  suggestion(name, known_names())}});
}

}  // namespace

void add_explain(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand(
      "explain", "explain an error code, entry, key, output, function or command");
  const auto name = std::make_shared<std::string>();
  command->add_option("name", *name, "E201, coordinate, scene.outputs, mass_matrix, sin")
      ->required();
  set_action(*command, action, name, &explain);
}

}  // namespace elgen::cli
