// Writes the output files of every command: all or none, and never over files of others.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "elgen/artifacts.hpp"
#include "elgen/emitted_files.hpp"

namespace elgen::cli {

/// The ending of files that list the generated files.
inline constexpr std::string_view sidecar_ending = artifact_table.sidecar.ending;

/// The condition on an existing file under which it is replaced without --force.
enum class Replaces : unsigned char {
  generated,     ///< it has the marker of elgen
  dependencies,  ///< its first rule makes a generated file
  nothing,       ///< never: its owner edits it
};

struct OutputFile {
  std::string path = {};
  std::string text = {};
  Replaces replaces = Replaces::generated;
};

struct WriteOptions {
  bool force = false;         ///< replaces any regular file that is no input
  std::uint64_t seconds = 0;  ///< longest wait for another process that writes to the same folder
};

/// The emitted files with their paths in `directory`.
[[nodiscard]] std::vector<OutputFile> files_in(const std::string& directory,
                                               const EmittedFiles& files);

/// Writes the files and returns the paths of those that changed. E703, E708: an existing file may
/// not be replaced. E706: a file could not be written. After an error nothing is changed.
[[nodiscard]] Result<std::vector<std::string>> write_files(const std::vector<OutputFile>& files,
                                                           const WriteOptions& options);

/// Only the E703 and E708 of write_files(), to be checked before a long computation.
[[nodiscard]] Diagnostics refuse_places(const std::vector<OutputFile>& files, bool force);

/// True if the first 200 bytes of a regular file contain the marker of generated files.
[[nodiscard]] bool has_marker(const std::string& path);

/// The text of a regular file; empty if there is none.
[[nodiscard]] std::optional<std::string> existing_text(const std::string& path);

/// A path with spaces and dollar signs escaped for make and ninja.
[[nodiscard]] std::string escaped_for_make(const std::string& path);

enum class FileState : unsigned char {
  stale,
  edited,  ///< by hand: the text does not have the hash that it states
  missing,
  orphaned,  ///< it has the marker, but no input generates it any more
};

/// "stale", "edited", "missing", "orphaned"
[[nodiscard]] std::string_view name_of(FileState state);

/// A file that differs from the generated text.
struct FileDifference {
  FileState state = FileState::stale;
  std::string path = {};
  std::string detail = {};  ///< the first lines of a unified diff; for an orphan the reason
};

/// The differences between `files` and the disk. Orphans are not searched.
[[nodiscard]] std::vector<FileDifference> compare_files(const std::string& directory,
                                                        const EmittedFiles& files);

}  // namespace elgen::cli
