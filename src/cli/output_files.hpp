// EmittedFiles -> disk: all of them or none, never over a file that is not ours.
#pragma once

#include <string>
#include <vector>

#include "elgen/emitted_files.hpp"

namespace elgen::cli {

/// A file that bears no marker, because other programs read it or people edit it.
struct PlainFile {
  std::string path;
  std::string text;
};

/// Writes every file to a temporary name beside its place, and renames them when all are complete;
/// interrupts wait for that. E703: one of `files` exists without our marker (unless `force`); E706:
/// could not write. Then nothing is changed, but where a rename fails (which takes another process
/// that changes the folders meanwhile) those before it are done.
[[nodiscard]] Diagnostics write_files(const std::string& directory, const EmittedFiles& files,
                                      bool force, const std::vector<PlainFile>& plain = {});

/// E703 where a file exists that is written unasked only with `force`.
[[nodiscard]] Diagnostics refuse_existing(const std::string& path, bool force);

/// Whether the file says that elgen generated it.
[[nodiscard]] bool bears_marker(const std::string& path);

struct Differences {
  std::string text = {};                  ///< for people: short unified diffs, hand edits, orphans
  bool is_stale = false;                  ///< a file is missing or differs
  std::vector<std::string> orphans = {};  ///< files of ours that nothing generates any more
};

/// What differs between `files` and the disk.
[[nodiscard]] Differences compare_files(const std::string& directory, const EmittedFiles& files);

}  // namespace elgen::cli
