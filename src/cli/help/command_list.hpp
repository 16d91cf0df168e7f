// command_list: commands and their options as data, for completion scripts and the manual page.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace elgen::cli {

struct ListedOption {
  std::vector<std::string> names = {};    ///< "-q", "--quiet"; an argument has one name
  std::string type = {};                  ///< "DIR"; empty for a flag
  std::vector<std::string> choices = {};  ///< the allowed words; empty if other values are allowed
  std::string doc = {};
  bool is_positional = false;
  bool takes_several = false;
};

struct ListedCommand {
  std::string name = {};
  std::string doc = {};
  std::vector<ListedOption> options = {};
};

/// The global options and the commands, as `--help` lists them.
struct CommandList {
  std::string doc = {};                    ///< with examples
  std::vector<ListedOption> options = {};  ///< global options
  std::vector<ListedCommand> commands = {};
};

[[nodiscard]] CommandList command_list(const CLI::App& app);

/// The shells for which completions exist.
[[nodiscard]] std::vector<std::string> completion_shells();

/// A script that completes commands, options, options' arguments, and files. `shell` must be one of
/// completion_shells().
[[nodiscard]] std::string completion_script(const CommandList& list, const std::string& shell);

/// The manual page elgen(1), in the troff macros of man.
[[nodiscard]] std::string manual_page(const CommandList& list);

}  // namespace elgen::cli
