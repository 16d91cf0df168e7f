// The options of the command line, and the functions that every command needs.
#pragma once

#include <string>
#include <vector>

#include "elgen/diagnostic.hpp"
#include "elgen/pipeline.hpp"

namespace elgen::cli {

/// Options of every command.
struct GlobalOptions {
  std::vector<std::string> words = {};  ///< of the command line, the program's name first
  DiagnosticStyle style = {};
  bool quiet = false;
  bool verbose = false;
  bool timings = false;
  std::string dump_stage = {};
  std::string stop_after = {};
  Limits limits = {};
};

/// Prints what was asked for on stdout, at once. E706 where that fails.
ExitCode print(const GlobalOptions& global, const std::string& asked_for);

/// Prints diagnostics on stderr (--quiet: without notes), and returns their exit code.
ExitCode report(const GlobalOptions& global, const Diagnostics& diagnostics);

/// Whether results are printed as JSON: what has no such form is refused.
[[nodiscard]] inline bool wants_json(const GlobalOptions& global) {
  return global.style.format == DiagnosticFormat::json;
}

/// A line for people on stderr, unless --quiet, or programs read all of it.
void tell(const GlobalOptions& global, const std::string& line);

void tell_times(const GlobalOptions& global, const Products& products);

}  // namespace elgen::cli
