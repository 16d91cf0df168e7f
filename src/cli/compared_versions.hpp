// Two versions of models and scenes: read, lowered and compared.
#pragma once

#include <string>
#include <vector>

#include "cli/options.hpp"
#include "elgen/diff.hpp"

namespace elgen::cli {

/// Compares two files or two folders. Files of folders are paired by their relative paths, files
/// that moved by the names of their systems. In a folder every TOML file NAME.toml with a table
/// [model] is a model, and every file NAME.scene.toml is a scene. Errors of either version
/// accompany the report on the systems that can be compared.
[[nodiscard]] Result<DiffReport> compare_paths(const std::string& before, const std::string& after,
                                               const CompareOptions& options, const Limits& limits);

/// Compares files and folders (default: ".") with a revision of git. E713 if git does not know the
/// revision or cannot be run.
[[nodiscard]] Result<DiffReport> compare_with_revision(const std::string& name,
                                                       std::vector<std::string> paths,
                                                       const CompareOptions& options,
                                                       const Limits& limits);

}  // namespace elgen::cli
