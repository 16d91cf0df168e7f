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

CLI::Option* add_shard(CLI::App& command, std::optional<Shard>& shard, const std::string& doc) {
  const auto read = [&shard](const std::string& text) {
    shard = parse_shard(text);
    if (!shard) throw CLI::ValidationError("--shard", "not i/N with 1 <= i <= N: " + text);
  };
  return command.add_option_function<std::string>("--shard", read, doc)->type_name("i/N");
}

void add_specialisation(CLI::App& command, SceneOptions& options) {
  add_sources(command, "--fix", "NAME[=VALUE]", options.fixed,
              "make a parameter a number: NAME, NAME=VALUE or all");
  add_sources(command, "--size", "NAME=N", options.sizes, "override a size of the model");
}

}  // namespace elgen::cli
