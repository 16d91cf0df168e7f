// generated_check: compares generated files for `generate --check`, and reports the differences.
#pragma once

#include <string>
#include <vector>

#include "cli/files/output_files.hpp"
#include "cli/options.hpp"
#include "elgen/scene.hpp"

namespace elgen::cli {

/// The files that `generate` would write, their folder and their sources.
struct GeneratedSystems {
  std::string directory = {};
  EmittedFiles files = {};
  std::vector<SourcePaths> sources = {};
  std::string repair = {};      ///< the command that writes the files
  std::string comparison = {};  ///< the command that compares the equations; "" if there is none
};

/// Prints the files that differ from the generated text; with -v also the first lines of each
/// difference. Then prints the commands that repair the files and the command that compares the
/// equations. If the format is not text, only reports E715 for each file.
[[nodiscard]] ExitCode check_generated(const GlobalOptions& global,
                                       const GeneratedSystems& systems);

}  // namespace elgen::cli
