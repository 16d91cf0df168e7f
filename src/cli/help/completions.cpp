// completions: one list of commands, a template for each shell.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "cli/help/command_list.hpp"
#include "render/fill_template.hpp"

namespace elgen::cli {

namespace {

using List = TemplateData::type;

struct ShellRow {
  std::string_view shell;
  std::string_view path;
};

constexpr std::array shells{ShellRow{"bash", "shells/bash.bash.mustache"},
                            ShellRow{"zsh", "shells/zsh.zsh.mustache"},
                            ShellRow{"fish", "shells/fish.fish.mustache"}};

std::string spaced(const std::vector<std::string>& words) {
  return fmt::format("{}", fmt::join(words, " "));
}

std::vector<std::string> names_of(const std::vector<ListedCommand>& commands) {
  std::vector<std::string> names;
  for (const ListedCommand& command : commands) names.push_back(command.name);
  return names;
}

/// Of options, not of positionals.
std::vector<std::string> names_of(const std::vector<ListedOption>& options) {
  std::vector<std::string> names;
  for (const ListedOption& option : options) {
    if (!option.is_positional) names.insert(names.end(), option.names.begin(), option.names.end());
  }
  return names;
}

/// Inside of '…', for all three shells.
std::string in_single_quotes(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '\'' ? "'\\''" : std::string(1, c);
  return result;
}

/// Before and inside of the brackets of _arguments.
std::string zsh_text(const std::string& text) {
  std::string result;
  for (const char c : in_single_quotes(text)) {
    if (c == '[' || c == ']' || c == ':') result += '\\';
    result += c;
  }
  return result;
}

/// '--as[doc]:TEXT:(text json)'
std::string zsh_spec(const ListedOption& option, const std::string& name) {
  const std::string words =
      option.choices.empty() ? "_files" : fmt::format("({})", spaced(option.choices));
  if (option.is_positional) {
    return fmt::format("'{}:{}:{}'", option.takes_several ? "*" : "1", name, words);
  }
  const std::string value = option.type.empty() ? "" : fmt::format(":{}:{}", option.type, words);
  return fmt::format("'{}[{}]{}'", name, zsh_text(option.doc), value);
}

TemplateData zsh_specs(const std::vector<ListedOption>& options) {
  std::vector<std::string> lines;
  for (const ListedOption& option : options) {
    for (const std::string& name : option.names) lines.push_back(zsh_spec(option, name));
  }
  return lines_data(lines);
}

/// " -n '…' -l as -x -a 'text json' -d 'doc'"; `command` is empty where it may stand anywhere.
std::string fish_option(const std::string& command, const ListedOption& option) {
  std::string line;
  if (!command.empty()) line += fmt::format(" -n '__fish_seen_subcommand_from {}'", command);
  for (const std::string& name : option.names) {
    if (option.is_positional) continue;
    const bool is_long = name.starts_with("--");
    line += fmt::format(" -{} {}", is_long ? "l" : "s", name.substr(is_long ? 2 : 1));
  }
  if (!option.choices.empty()) {
    line += fmt::format(" -{} -a '{}'", option.is_positional ? "f" : "x", spaced(option.choices));
  } else if (!option.type.empty()) {
    line += " -r";
  }
  return line + fmt::format(" -d '{}'", in_single_quotes(option.doc));
}

void add_fish_options(std::vector<std::string>& lines, const std::string& command,
                      const std::vector<ListedOption>& options) {
  for (const ListedOption& option : options) {
    const bool is_file = option.is_positional && option.choices.empty();
    if (!is_file) lines.push_back(fish_option(command, option));
  }
}

TemplateData choices_row(const std::string& command, const std::string& name,
                         const ListedOption& option) {
  TemplateData row;
  row.set("command", command);
  row.set("name", name);
  row.set("words", spaced(option.choices));
  return row;
}

struct BashChoices {
  TemplateData options{List::list};
  TemplateData positionals{List::list};

  void add(const std::string& command, const std::vector<ListedOption>& of) {
    for (const ListedOption& option : of) {
      if (option.choices.empty()) continue;
      for (const std::string& name : option.names) {
        TemplateData& list = option.is_positional ? positionals : options;
        list << choices_row(command, name, option);
      }
    }
  }
};

TemplateData command_row(const ListedCommand& command) {
  TemplateData row;
  row.set("name", command.name);
  row.set("quoted_doc", in_single_quotes(command.doc));
  row.set("option_names", spaced(names_of(command.options)));
  row.set("specs", zsh_specs(command.options));
  return row;
}

}  // namespace

std::vector<std::string> completed_shells() {
  std::vector<std::string> names;
  for (const ShellRow& row : shells) names.emplace_back(row.shell);
  return names;
}

std::string completions(const CommandList& list, const std::string& shell) {
  TemplateData commands(List::list);
  BashChoices choices;
  std::vector<std::string> fish_options;
  choices.add("*", list.options);
  add_fish_options(fish_options, "", list.options);
  for (const ListedCommand& command : list.commands) {
    commands << command_row(command);
    choices.add(command.name, command.options);
    add_fish_options(fish_options, command.name, command.options);
  }
  TemplateData data;
  data.set("commands", commands);
  data.set("choices", choices.options);
  data.set("positionals", choices.positionals);
  data.set("command_pattern", fmt::format("{}", fmt::join(names_of(list.commands), " | ")));
  data.set("command_names", spaced(names_of(list.commands)));
  data.set("global_names", spaced(names_of(list.options)));
  data.set("global_specs", zsh_specs(list.options));
  data.set("fish_options", lines_data(fish_options));
  return fill_template(std::ranges::find(shells, shell, &ShellRow::shell)->path, data);
}

}  // namespace elgen::cli
