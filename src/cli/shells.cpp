// elgen completions, elgen man: prints a completion script or the manual page.
#include "base/reason.hpp"
#include "cli/commands.hpp"
#include "cli/help/command_list.hpp"

namespace elgen::cli {

namespace {

/// Sets an action that prints `text`. The text is made during parsing, because the list of commands
/// exists only then.
void set_print_action(Action& action, std::string text) {
  action = [text = std::move(text)](const GlobalOptions& global) {
    if (!wants_json(global)) return print(global, text);
    return report(
        global,
        {{Reason::not_as_json, {}, "completions and manual pages are not printed as json"}});
  };
}

}  // namespace

void add_completions(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("completions", "print a completion script for a shell");
  const auto shell = std::make_shared<std::string>();
  command->add_option("shell", *shell, "bash, zsh or fish")
      ->required()
      ->check(CLI::IsMember(completion_shells()));
  command->callback([&app, &action, shell] {
    set_print_action(action, completion_script(command_list(app), *shell));
  });
}

void add_man(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("man", "print the manual page elgen(1)");
  command->callback([&app, &action] { set_print_action(action, manual_page(command_list(app))); });
}

}  // namespace elgen::cli
