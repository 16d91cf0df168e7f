// generated_check: the report of `generate --check`.
#pragma once

#include <string>
#include <vector>

#include "cli/files/output_files.hpp"
#include "cli/options.hpp"
#include "elgen/scene.hpp"

namespace elgen::cli {

/// The files that `generate` would write, and their folder.
struct GeneratedSystems {
  std::string directory = {};
  EmittedFiles files = {};
  std::vector<SourcePaths> sources = {};
  std::string repair = {};      ///< the command that writes them
  std::string comparison = {};  ///< the command that compares the equations; "": none
};

/// Prints the files that differ from the generated ones, with -v their first lines that differ,
/// then the commands that repair them and compare the equations. In formats other than text: E715
/// for each file.
[[nodiscard]] ExitCode check_generated(const GlobalOptions& global,
                                       const GeneratedSystems& systems);

}  // namespace elgen::cli
