// command_list: commands and their options as data, for completions and the manual.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace elgen::cli {

struct ListedOption {
  std::vector<std::string> names = {};    ///< "-q", "--quiet"; a positional argument has one name
  std::string type = {};                  ///< "DIR"; empty: a flag
  std::vector<std::string> choices = {};  ///< all allowed values, if these are words
  std::string doc = {};
  bool is_positional = false;
  bool takes_several = false;
};

struct ListedCommand {
  std::string name = {};
  std::string doc = {};
  std::vector<ListedOption> options = {};
};

/// The content of `--help`.
struct CommandList {
  std::string doc = {};                    ///< with the examples
  std::vector<ListedOption> options = {};  ///< global options
  std::vector<ListedCommand> commands = {};
};

[[nodiscard]] CommandList command_list(const CLI::App& app);

/// The shells for which completions exist.
[[nodiscard]] std::vector<std::string> completed_shells();

/// A script that completes commands, options, their values, and files. `shell` is one of
/// completed_shells().
[[nodiscard]] std::string completions(const CommandList& list, const std::string& shell);

/// elgen(1), for man and groff.
[[nodiscard]] std::string manual_page(const CommandList& list);

}  // namespace elgen::cli
