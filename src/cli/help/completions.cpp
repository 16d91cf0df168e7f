// completions: fills the template of a shell from the list of commands.
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "base/fill_template.hpp"
#include "cli/help/command_list.hpp"
#include "elgen/wording.hpp"

namespace elgen::cli {

namespace {

struct ShellRow {
  std::string_view shell;
  std::string_view path;
};

constexpr std::array shells{ShellRow{"bash", "shells/bash.bash.mustache"},
                            ShellRow{"zsh", "shells/zsh.zsh.mustache"},
                            ShellRow{"fish", "shells/fish.fish.mustache"}};

std::string join_with_spaces(const std::vector<std::string>& words) {
  return fmt::format("{}", fmt::join(words, " "));
}

/// The names of all options, without positional arguments.
std::vector<std::string> names_of(const std::vector<ListedOption>& options) {
  std::vector<std::string> names;
  for (const ListedOption& option : options) {
    if (!option.is_positional) names.insert(names.end(), option.names.begin(), option.names.end());
  }
  return names;
}

/// Escapes a text for single quotes, in all three shells.
std::string escape_single_quotes(const std::string& text) {
  return escape_markup(text, {{'\'', "'\\''"}});
}

/// Escapes a text for the option specifications of zsh's _arguments.
std::string escape_for_zsh(const std::string& text) {
  return escape_markup(escape_single_quotes(text), {{'[', "\\["}, {']', "\\]"}, {':', "\\:"}});
}

/// An option for zsh's _arguments: '--as[doc]:TEXT:(text json)'.
std::string zsh_spec(const ListedOption& option, const std::string& name) {
  const std::string words =
      option.choices.empty() ? "_files" : fmt::format("({})", join_with_spaces(option.choices));
  if (option.is_positional) {
    return fmt::format("'{}:{}:{}'", option.takes_several ? "*" : "1", name, words);
  }
  const std::string value = option.type.empty() ? "" : fmt::format(":{}:{}", option.type, words);
  return fmt::format("'{}[{}]{}'", name, escape_for_zsh(option.doc), value);
}

TemplateData zsh_specs(const std::vector<ListedOption>& options) {
  std::vector<std::string> lines;
  for (const ListedOption& option : options) {
    for (const std::string& name : option.names) lines.push_back(zsh_spec(option, name));
  }
  return lines_section(lines);
}

/// The options of fish's `complete`: " -n '…' -l as -x -a 'text json' -d 'doc'". `command` is empty
/// for global options.
std::string fish_option(const std::string& command, const ListedOption& option) {
  std::string line;
  if (!command.empty()) line += fmt::format(" -n '__fish_seen_subcommand_from {}'", command);
  for (const std::string& name : option.names) {
    if (option.is_positional) continue;
    const bool is_long = name.starts_with("--");
    line += fmt::format(" -{} {}", is_long ? "l" : "s", name.substr(is_long ? 2 : 1));
  }
  if (!option.choices.empty()) {
    line += fmt::format(" -{} -a '{}'", option.is_positional ? "f" : "x",
                        join_with_spaces(option.choices));
  } else if (!option.type.empty()) {
    line += " -r";
  }
  return line + fmt::format(" -d '{}'", escape_single_quotes(option.doc));
}

void add_fish_options(std::vector<std::string>& lines, const std::string& command,
                      const std::vector<ListedOption>& options) {
  for (const ListedOption& option : options) {
    const bool is_file = option.is_positional && option.choices.empty();
    if (!is_file) lines.push_back(fish_option(command, option));
  }
}

struct BashChoices {
  TemplateData options{TemplateData::type::list};
  TemplateData positionals{TemplateData::type::list};

  void add_options(const std::string& command, const std::vector<ListedOption>& options_list) {
    for (const ListedOption& option : options_list) {
      if (option.choices.empty()) continue;
      for (const std::string& name : option.names) {
        TemplateData& list = option.is_positional ? positionals : options;
        list << TemplateRow{
            {"command", command}, {"name", name}, {"words", join_with_spaces(option.choices)}};
      }
    }
  }
};

TemplateData command_row(const ListedCommand& command) {
  return TemplateRow{{"name", command.name},
                     {"quoted_doc", escape_single_quotes(command.doc)},
                     {"option_names", join_with_spaces(names_of(command.options))},
                     {"specs", zsh_specs(command.options)}};
}

}  // namespace

std::vector<std::string> completion_shells() { return column_words(shells, &ShellRow::shell); }

std::string completion_script(const CommandList& list, const std::string& shell) {
  BashChoices choices;
  std::vector<std::string> fish_options;
  choices.add_options("*", list.options);
  add_fish_options(fish_options, "", list.options);
  for (const ListedCommand& command : list.commands) {
    choices.add_options(command.name, command.options);
    add_fish_options(fish_options, command.name, command.options);
  }
  const std::vector<std::string> names = column_words(list.commands, &ListedCommand::name);
  return fill_template(std::ranges::find(shells, shell, &ShellRow::shell)->path,
                       TemplateRow{{"commands", repeated_section(list.commands, command_row)},
                                   {"choices", choices.options},
                                   {"positionals", choices.positionals},
                                   {"command_pattern", fmt::format("{}", fmt::join(names, " | "))},
                                   {"command_names", join_with_spaces(names)},
                                   {"global_names", join_with_spaces(names_of(list.options))},
                                   {"global_specs", zsh_specs(list.options)},
                                   {"fish_options", lines_section(fish_options)}});
}

}  // namespace elgen::cli
