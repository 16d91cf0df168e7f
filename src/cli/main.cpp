// elgen: the command line. Words -> options; every command lives in a file of its own.
#include <fmt/format.h>

#include <new>

#include "command_line.hpp"
#include "options.hpp"
#include "resources.hpp"

namespace elgen::cli {

namespace {

ExitCode run_command(const CommandLine& line) {
  set_resource_limits(line.global.limits, line.global.style);
  try {
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
  } catch (const std::bad_alloc&) {
    return report(line.global, {out_of_memory(line.global.limits)});
  } catch (const std::exception& mistake) {
    return report(line.global,
                  {{Code::E912, {}, fmt::format("internal error: {}", mistake.what())}});
  }
}

}  // namespace

}  // namespace elgen::cli

int main(int argc, char** argv) {
  using namespace elgen::cli;
  const std::vector<std::string> words{argv, argv + argc};
  const auto line = read_command_line(words);
  if (!line.value) {
    GlobalOptions global;
    global.style = style_of_mistakes(words);
    return static_cast<int>(report(global, line.diagnostics));
  }
  return static_cast<int>(run_command(*line.value));
}
