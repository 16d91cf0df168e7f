// The words of a command line -> options.
#pragma once

#include <string>
#include <vector>

#include "cli/options.hpp"

namespace elgen::cli {

enum class Command : unsigned char { none, generate, show, verify, import, explain };

struct CommandLine {
  Command command = Command::none;  ///< none: --help, --version, --limits
  std::string answer = {};          ///< to these
  GlobalOptions global = {};
  GenerateOptions generate = {};
  ShowOptions show = {};
  VerifyCommandOptions verify = {};
  ImportOptions import_options = {};
  std::string name = {};
};

/// E913: words that are not understood, with what was probably meant.
[[nodiscard]] Result<CommandLine> read_command_line(const std::vector<std::string>& words);

/// How the diagnostics of read_command_line are wanted, as far as its words can be understood.
[[nodiscard]] DiagnosticStyle style_of_mistakes(const std::vector<std::string>& words);

}  // namespace elgen::cli
