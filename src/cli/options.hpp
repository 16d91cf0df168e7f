// The global options, and the functions with which every command prints.
#pragma once

#include <string>
#include <vector>

#include "elgen/diagnostic.hpp"
#include "elgen/pipeline.hpp"

namespace elgen::cli {

/// The options that all commands have.
struct GlobalOptions {
  std::vector<std::string> words = {};  ///< the whole command line, including the program's name
  DiagnosticStyle style = {};
  bool quiet = false;
  bool verbose = false;
  bool timings = false;
  std::string dump_stage = {};
  std::string stop_after = {};
  Limits limits = {};
};

/// Prints a result on stdout, all bytes in one call. E706 if stdout cannot be written.
ExitCode print(const GlobalOptions& global, const std::string& result);

/// Prints diagnostics on stderr, without notes if --quiet is set, and returns their exit code.
ExitCode report(const GlobalOptions& global, const Diagnostics& diagnostics);

/// True if results are printed as JSON. Commands report an error for results without a JSON form.
[[nodiscard]] inline bool wants_json(const GlobalOptions& global) {
  return global.style.format == DiagnosticFormat::json;
}

/// Prints a line on stderr, unless --quiet is set or the format is JSON.
void print_message(const GlobalOptions& global, const std::string& line);

void print_stage_times(const GlobalOptions& global, const Products& products);

}  // namespace elgen::cli
