// Prints results on stdout, and everything else on stderr.
#include <fmt/format.h>

#include <cstdio>
#include <string>

#include "base/no_interrupts.hpp"
#include "base/utf8.hpp"
#include "cli/options.hpp"
#include "elgen/diagnostic.hpp"

namespace elgen::cli {
namespace {

/// Errors of fputs() are ignored, because only stderr could report them.
void write_stderr(const std::string& text) { std::fputs(text.c_str(), stderr); }

/// Prints all diagnostics. If a limit is exceeded meanwhile, the message of this limit follows.
void write_stderr(const Diagnostics& diagnostics, const DiagnosticStyle& style) {
  // All memory is allocated before the first byte is written. Signals are deferred until the last
  // byte is written.
  const std::string text = format(diagnostics, style);
  const SignalBlocker until_written;
  write_stderr(text);
}

Diagnostics without_notes(Diagnostics diagnostics) {
  std::erase_if(diagnostics, [](const Diagnostic& diagnostic) {
    return code_row(diagnostic.code).severity == Severity::note;
  });
  return diagnostics;
}

}  // namespace

ExitCode print(const GlobalOptions& global, const std::string& result) {
  const std::string text = wants_json(global) ? visible_json(result) : result;
  std::fwrite(text.data(), 1, text.size(), stdout);
  std::fflush(stdout);
  if (std::ferror(stdout) == 0) return ExitCode::success;
  return report(global, {{Code::E706, {}, "standard output could not be written"}});
}

ExitCode report(const GlobalOptions& global, const Diagnostics& diagnostics) {
  write_stderr(global.quiet ? without_notes(diagnostics) : diagnostics, global.style);
  return exit_code(diagnostics);
}

void print_message(const GlobalOptions& global, const std::string& line) {
  if (!global.quiet && !wants_json(global)) write_stderr(line + "\n");
}

void print_stage_times(const GlobalOptions& global, const Products& products) {
  if (!global.timings) return;
  const auto line = [](const std::string& name, double seconds) {
    write_stderr(fmt::format("{:>12} {:9.2f} ms\n", name, seconds * 1e3));
  };
  double sum = 0.0;
  for (const StageTime& time : products.times) {
    line(time.stage, time.seconds);
    sum += time.seconds;
  }
  line("sum", sum);
}

}  // namespace elgen::cli
