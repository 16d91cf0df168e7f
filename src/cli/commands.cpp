// Commands: options that several of them have.
#include "cli/commands.hpp"

namespace elgen::cli {

void add_sources(CLI::App& command, const std::string& name, const std::string& type,
                 std::vector<SourcePointer>& sources, const std::string& doc) {
  const auto read = [&sources](const std::vector<std::string>& values) {
    for (const std::string& value : values) sources.push_back(make_source("command line", value));
  };
  command.add_option_function<std::vector<std::string>>(name, read, doc)
      ->type_name(type)
      ->allow_extra_args(false);
}

void add_specialisation(CLI::App& command, SceneOptions& options) {
  add_sources(command, "--fix", "NAME[=VALUE]", options.fixed,
              "make a parameter a number: NAME, NAME=VALUE or all");
  add_sources(command, "--size", "NAME=N", options.sizes, "override a size of the model");
}

}  // namespace elgen::cli
