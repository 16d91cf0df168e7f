// Reads two versions of models and scenes, lowers their equations and compares them.
#pragma once

#include <string>
#include <vector>

#include "cli/options.hpp"
#include "elgen/diff.hpp"

namespace elgen::cli {

/// Compares two files or two folders. Files in folders are paired by their relative paths; moved
/// files by the names of their systems. In a folder, a file NAME.toml with a table [model] is a
/// model, and a file NAME.scene.toml is a scene. If systems have errors, the report contains the
/// systems without errors, and the errors are the result's diagnostics.
[[nodiscard]] Result<DiffReport> compare_paths(const std::string& before, const std::string& after,
                                               const CompareOptions& options, const Limits& limits);

/// Compares files and folders (default: ".") with their versions in the git revision `name`. E713
/// if git does not know this revision, or if git cannot be run.
[[nodiscard]] Result<DiffReport> compare_with_revision(const std::string& name,
                                                       std::vector<std::string> paths,
                                                       const CompareOptions& options,
                                                       const Limits& limits);

}  // namespace elgen::cli
