// Commands: the functions that add the commands to the command line, and the options that several
// commands share.
#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "cli/files/output_files.hpp"
#include "cli/options.hpp"

namespace elgen::cli {

/// Runs a command. The action contains the command's options; the argument has the global options.
using Action = std::function<ExitCode(const GlobalOptions&)>;

// Each function adds its command to `app`. If the command line names the command, parsing sets
// `action`.
#define ELGEN_COMMAND(name) void add_##name(CLI::App& app, Action& action);
#include "cli/commands.def"
#undef ELGEN_COMMAND

/// Registers a callback of CLI11: if the command line names `command`, `action` becomes a call of
/// `run` with the parsed `options`.
template <class Options>
void set_action(CLI::App& command, Action& action, const std::shared_ptr<Options>& options,
                ExitCode (*run)(const GlobalOptions&, const Options&)) {
  command.callback([&action, options, run] {
    action = [options, run](const GlobalOptions& global) { return run(global, *options); };
  });
}

/// Adds an option that may be repeated. Each value becomes a source, so that diagnostics can point
/// into the value.
inline void add_source_option(CLI::App& command, const std::string& name, const std::string& type,
                              std::vector<SourcePointer>& sources, const std::string& doc) {
  const auto read = [&sources](const std::vector<std::string>& values) {
    for (const std::string& value : values) sources.push_back(make_source("command line", value));
  };
  command.add_option_function<std::vector<std::string>>(name, read, doc)
      ->type_name(type)
      ->allow_extra_args(false);
}

/// The error if `word` is no whole number below 2^64; otherwise "". CLI11 itself would replace
/// negative and too large numbers by the largest number.
inline std::string number_error(const std::string& word) {
  std::uint64_t number = 0;
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, number);
  const bool is_read = error == std::errc() && stop == end;
  return is_read ? "" : "`" + word + "` is not a whole number below 2^64";
}

/// The error if `word` is a number with a unit, such as 10s; otherwise "".
inline std::string unit_error(const std::string& word) {
  const std::size_t end = word.find_first_not_of("0123456789.eE+-");
  if (end == std::string::npos || end == 0) return "";
  return "`" + word + "` is not a number: " +
         (word.substr(end) == "s" ? "write `" + word.substr(0, end) + "`" : "numbers have no unit");
}

/// Adds an option for a number to `command`. Without the option, `value` stays empty.
inline CLI::Option* add_number_option(CLI::App& command, const char* name,
                                      std::optional<double>& value, const char* doc) {
  return command
      .add_option_function<double>(
          name, [&value](double given) { value = given; }, doc)
      ->check(unit_error);
}

/// An output file. Only --force replaces an existing file, which the owner may have edited.
struct FileOption {
  std::string file = {};  ///< empty: no file
  bool force = false;
};

/// Adds -o and --force.
inline void add_file_options(CLI::App& command, FileOption& output, const std::string& doc) {
  command.add_option("-o,--output", output.file, doc)->type_name("FILE");
  command.add_flag("--force", output.force, "overwrite FILE if it exists");
}

/// The errors E703 and E708 that write_output() would report, for a check before a long
/// computation.
[[nodiscard]] inline Diagnostics check_output_path(const FileOption& output) {
  if (output.file.empty()) return {};
  return check_output_paths({{output.file, "", ReplacePolicy::never}}, output.force);
}

/// write_files() for one file; only --force replaces an existing file.
inline Result<std::vector<std::string>> write_output(const GlobalOptions& global,
                                                     const FileOption& output,
                                                     const std::string& text) {
  return write_files({{output.file, text, ReplacePolicy::never}},
                     {output.force, global.limits.seconds});
}

/// Adds --fix and --size.
inline void add_specialisation_options(CLI::App& command, SceneOptions& options) {
  add_source_option(command, "--fix", "NAME[=VALUE]", options.fixed,
                    "replace a parameter by a number: NAME, NAME=VALUE or all");
  add_source_option(command, "--size", "NAME=N", options.sizes, "override a size of the model");
}

/// Adds --language.
inline void add_language_option(CLI::App& command, std::optional<LanguageId>& language) {
  std::vector<std::string> names;
  for (const LanguageRow& row : language_table) names.emplace_back(row.name);
  const auto set = [&language](const std::string& name) {
    language = std::ranges::find(language_table, name, &LanguageRow::name)->id;
  };
  command
      .add_option_function<std::string>("--language", set,
                                        "language of the code; overrides the scene")
      ->check(CLI::IsMember(names))
      ->type_name("LANGUAGE");
}

}  // namespace elgen::cli
