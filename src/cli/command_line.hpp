// The words of a command line -> options.
#pragma once

#include <string>
#include <vector>

#include "cli/commands.hpp"

namespace elgen::cli {

struct CommandLine {
  Action action = {};       ///< empty: --help, --version, --limits
  std::string answer = {};  ///< to these
  GlobalOptions global = {};
};

/// E913: words that are not understood, with what was probably meant.
[[nodiscard]] Result<CommandLine> read_command_line(const std::vector<std::string>& words);

/// How the diagnostics of read_command_line are wanted, as far as its words can be understood.
[[nodiscard]] DiagnosticStyle style_of_mistakes(const std::vector<std::string>& words);

}  // namespace elgen::cli
