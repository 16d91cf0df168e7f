// EmittedFiles -> disk: all of them or none, never over a file that is not ours.
#pragma once

#include <string>

#include "elgen/emitted_files.hpp"

namespace elgen::cli {

/// Writes every file to a temporary name beside its place, then renames them. On failure nothing is
/// changed. E703: a file exists without our marker (unless `force`); E706: could not write.
[[nodiscard]] Diagnostics write_files(const std::string& directory, const EmittedFiles& files,
                                      bool force);

/// What differs between `files` and the disk, as text for people (short unified diffs, hand edits,
/// orphans); empty where nothing does.
[[nodiscard]] std::string compare_files(const std::string& directory, const EmittedFiles& files);

}  // namespace elgen::cli
