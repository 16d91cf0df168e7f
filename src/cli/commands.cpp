// Commands: options that several of them have.
#include "cli/commands.hpp"

namespace elgen::cli {

CLI::Option* add_sources(CLI::App& command, const std::string& name,
                         std::vector<SourcePointer>& sources, const std::string& doc) {
  const auto read = [&sources](const std::vector<std::string>& values) {
    for (const std::string& value : values) sources.push_back(make_source("command line", value));
  };
  return command.add_option_function<std::vector<std::string>>(name, read, doc);
}

void add_specialisation(CLI::App& command, SceneOptions& options) {
  add_sources(command, "--fix", options.fixed, "make a parameter a number: NAME, NAME=VALUE or all")
      ->type_name("NAME[=VALUE]")
      ->allow_extra_args(false);
  add_sources(command, "--size", options.sizes, "override a size of the model")
      ->type_name("NAME=N")
      ->allow_extra_args(false);
}

}  // namespace elgen::cli
