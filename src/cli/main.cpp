// elgen: the command line. Words -> options; every command lives in a file of its own.
#include <fmt/format.h>

#include <new>

#include "cli/command_line.hpp"
#include "cli/options.hpp"
#include "cli/resources.hpp"

namespace elgen::cli {

namespace {

ExitCode run_command(const CommandLine& line) {
  switch (line.command) {
    case Command::generate:
      return generate(line.global, line.generate);
    case Command::show:
      return show(line.global, line.show);
    case Command::verify:
      return verify_inputs(line.global, line.verify);
    case Command::import:
      return import_file(line.global, line.import_options);
    case Command::explain:
      return explain(line.global, line.name);
    case Command::none:
      return print(line.global, line.answer);
  }
  return ExitCode::internal;
}

/// `global` is what is known of the command line when something is thrown.
ExitCode run_words(const std::vector<std::string>& words, GlobalOptions& global) {
  const auto line = read_command_line(words);
  if (!line) {
    global.style = style_of_mistakes(words);
    return report(global, line.diagnostics);
  }
  global = line->global;
  set_resource_limits(global.limits, global.style);
  return run_command(*line);
}

ExitCode run(int count, char** words) {
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

int main(int argc, char** argv) { return static_cast<int>(elgen::cli::run(argc, argv)); }
