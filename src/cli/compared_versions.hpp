// Two versions of models and scenes: read, lowered and compared.
#pragma once

#include <string>
#include <vector>

#include "cli/options.hpp"
#include "elgen/diff.hpp"

namespace elgen::cli {

/// Two files, or two folders whose files match by their paths in them; a file that moved matches by
/// the name of its system. A folder's models are the files NAME.toml that are TOML with a table
/// [model], its scenes are called NAME.scene.toml. Errors of either version stand beside the report
/// of what could be compared.
[[nodiscard]] Result<DiffReport> compared_paths(const std::string& before, const std::string& after,
                                                const CompareOptions& options,
                                                const Limits& limits);

/// Files and folders ("." where there is none) with what they were in a revision of git. E713: git
/// does not know it, or is not there.
[[nodiscard]] Result<DiffReport> compared_with_revision(const std::string& name,
                                                        std::vector<std::string> paths,
                                                        const CompareOptions& options,
                                                        const Limits& limits);

}  // namespace elgen::cli
