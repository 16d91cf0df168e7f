// generated_check: what `generate --check` says.
#pragma once

#include <string>
#include <vector>

#include "cli/files/output_files.hpp"
#include "cli/options.hpp"
#include "elgen/scene.hpp"

namespace elgen::cli {

/// The files that would be written, and their folder.
struct GeneratedSystems {
  std::string directory = {};
  EmittedFiles files = {};
  std::vector<SourcePaths> sources = {};
  std::string repair = {};      ///< the command that writes them
  std::string comparison = {};  ///< the command that compares the equations; "" where there is none
};

/// The files that are not as they would be written, with -v the first lines that differ; then the
/// commands that repair them and that compare the equations. E715 for each file where diagnostics
/// are not text.
[[nodiscard]] ExitCode check_generated(const GlobalOptions& global,
                                       const GeneratedSystems& systems);

}  // namespace elgen::cli
