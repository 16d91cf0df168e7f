// elgen schema NAME: the JSON Schema of model or scene files.
#include "cli/commands.hpp"
#include "elgen/syntax.hpp"

namespace elgen::cli {

namespace {

ExitCode print_schema(const GlobalOptions& global, const std::string& name) {
  return print(global, file_schema(name == "scene" ? FileKind::scene : FileKind::model));
}

}  // namespace

void add_schema(CLI::App& app, Action& action) {
  CLI::App* command =
      app.add_subcommand("schema", "print the JSON Schema of models or scenes for editors");
  const auto name = std::make_shared<std::string>();
  command->add_option("name", *name, "model or scene")
      ->required()
      ->check(CLI::IsMember({"model", "scene"}));
  set_action(*command, action, name, &print_schema);
}

}  // namespace elgen::cli
