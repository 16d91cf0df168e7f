// command_list: reads the commands from CLI11. CLI11 stores the words of IsMember only in the text
// of a type, as "{a,b}".
#include "cli/help/command_list.hpp"

#include <algorithm>

namespace elgen::cli {

namespace {

/// Splits "TEXT:{auto,always,never}" into the type "TEXT" and the choices.
void parse_type(const std::string& text, ListedOption& option) {
  const std::size_t open = text.find('{');
  const std::size_t close = text.find('}');
  option.type = text.substr(0, std::min(text.find(':'), open));
  if (open == std::string::npos || close == std::string::npos) return;
  option.choices = CLI::detail::split(text.substr(open + 1, close - open - 1), ',');
}

ListedOption listed_option(const CLI::Option& option) {
  ListedOption result;
  for (const std::string& name : option.get_snames()) result.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) result.names.push_back("--" + name);
  result.is_positional = result.names.empty();
  if (result.is_positional) result.names.push_back(option.get_name());
  result.doc = option.get_description();
  result.takes_several = option.get_items_expected_max() > 1;
  const bool is_flag = option.get_items_expected_max() == 0;
  if (!is_flag) parse_type(option.get_type_name(), result);
  return result;
}

std::vector<ListedOption> options_of(const CLI::App& app) {
  std::vector<ListedOption> options;
  for (const CLI::Option* const option : app.get_options())
    options.push_back(listed_option(*option));
  return options;
}

bool is_help(const ListedOption& option) { return std::ranges::count(option.names, "--help") > 0; }

}  // namespace

CommandList command_list(const CLI::App& app) {
  CommandList list{app.get_description(), options_of(app)};
  for (const CLI::App* const command : app.get_subcommands({})) {
    ListedCommand& one = list.commands.emplace_back(
        ListedCommand{command->get_name(), command->get_description(), options_of(*command)});
    std::erase_if(one.options, is_help);
  }
  return list;
}

}  // namespace elgen::cli
