// Writes the output files of a command: all of them or none. Never replaces files that elgen did
// not write, unless forced.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "elgen/artifacts.hpp"
#include "elgen/emitted_files.hpp"

namespace elgen::cli {

/// The ending of sidecars, which list the generated files of a system.
inline constexpr std::string_view sidecar_ending = artifact_table.sidecar.path_suffix;

/// When an existing file may be replaced without --force.
enum class ReplacePolicy : unsigned char {
  generated,     ///< if it has the marker of elgen
  dependencies,  ///< if its first rule makes a generated file
  never,         ///< in no case, because the owner edits the file
};

struct OutputFile {
  std::string path = {};
  std::string text = {};
  ReplacePolicy policy = ReplacePolicy::generated;
};

struct WriteOptions {
  bool force = false;         ///< replace any regular file, except inputs
  std::uint64_t seconds = 0;  ///< longest wait for other processes that write to the same folders
};

/// The emitted files, with paths in `directory`.
[[nodiscard]] std::vector<OutputFile> to_output_files(const std::string& directory,
                                                      const EmittedFiles& files);

/// Writes the files, and returns the paths of the files that changed. E703: an existing file may
/// not be replaced. E708: a path cannot be reached, is given twice, is an input, or is no regular
/// file. E706: a file cannot be written. After an error no file has changed.
[[nodiscard]] Result<std::vector<std::string>> write_files(const std::vector<OutputFile>& files,
                                                           const WriteOptions& options);

/// The errors E703 and E708 that write_files() would report, for a check before a long computation.
[[nodiscard]] Diagnostics check_output_paths(const std::vector<OutputFile>& files, bool force);

/// True if the path is a regular file whose first 200 bytes contain the marker of generated files.
[[nodiscard]] bool has_generated_marker(const std::string& path);

/// The text of a regular file; none if it does not exist or cannot be read.
[[nodiscard]] std::optional<std::string> read_existing_file(const std::string& path);

/// The path, with spaces and dollar signs escaped for make and ninja.
[[nodiscard]] std::string escape_for_make(const std::string& path);

enum class FileState : unsigned char {
  stale,
  edited,  ///< by hand: the hash in the file is not the hash of its text
  missing,
  orphaned,  ///< has the marker, but no input generates the file now
};

/// "stale", "edited", "missing" or "orphaned".
[[nodiscard]] std::string_view name_of(FileState state);

/// A file on disk that differs from the generated text.
struct FileDifference {
  FileState state = FileState::stale;
  std::string path = {};
  std::string detail = {};  ///< first lines of a unified diff; for an orphan, why it is orphaned
};

/// The generated files that are missing or different on disk. Does not search for orphans.
[[nodiscard]] std::vector<FileDifference> compare_files(const std::string& directory,
                                                        const EmittedFiles& files);

}  // namespace elgen::cli
