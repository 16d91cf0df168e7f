// elgen: the command line. Words -> options; every command lives in a file of its own.
#include <fmt/format.h>

#include <new>

#include "cli/command_line.hpp"
#include "cli/process/resources.hpp"

namespace elgen::cli {

namespace {

/// `global` is what is known of the command line when something is thrown.
ExitCode run_words(const std::vector<std::string>& words, GlobalOptions& global) {
  const auto line = read_command_line(words);
  if (!line) {
    global.style = style_of_mistakes(words);
    return report(global, line.diagnostics);
  }
  global = line->global;
  set_resource_limits(global.limits, global.style);
  return line->action ? line->action(global) : print(global, line->answer);
}

/// Whatever happens becomes a diagnostic.
ExitCode run_program(int count, char** words) {
  GlobalOptions global;
  try {
    return run_words({words, words + count}, global);
  } catch (const std::bad_alloc&) {
    return report(global, {out_of_memory(global.limits)});
  } catch (const std::exception& mistake) {
    return report(global, {{Code::E912, {}, fmt::format("internal error: {}", mistake.what())}});
  }
}

}  // namespace

}  // namespace elgen::cli

int main(int argc, char** argv) { return static_cast<int>(elgen::cli::run_program(argc, argv)); }
