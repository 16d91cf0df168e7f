// Output of every command -> disk: all files or none, and never over what is not ours.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "elgen/artifacts.hpp"
#include "elgen/emitted_files.hpp"

namespace elgen::cli {

/// The ending of files that list the generated ones.
inline constexpr std::string_view sidecar_ending = artifact_table.sidecar.ending;

/// The condition on an existing file under which another takes its place unasked.
enum class Replaces : unsigned char {
  generated,     ///< a file that says that elgen generated it
  dependencies,  ///< a file for make whose first rule is about a file of ours
  nothing,       ///< such a file is edited by its owner
};

struct OutputFile {
  std::string path = {};
  std::string text = {};
  Replaces replaces = Replaces::generated;
};

struct WriteOptions {
  bool force = false;         ///< replaces any regular file that is no input
  std::uint64_t seconds = 0;  ///< to wait for another process that writes there
};

/// Every file below `directory`.
[[nodiscard]] std::vector<OutputFile> files_in(const std::string& directory,
                                               const EmittedFiles& files);

/// Puts every file in its place, and returns the paths of those that were not there already, byte
/// for byte. E703, E708: what stands in a place may not be replaced. E706: could not write. Then
/// nothing is changed.
[[nodiscard]] Result<std::vector<std::string>> write_files(const std::vector<OutputFile>& files,
                                                           const WriteOptions& options);

/// The E703 and E708 of write_files alone, for a command that takes long.
[[nodiscard]] Diagnostics refuse_places(const std::vector<OutputFile>& files, bool force);

/// Whether the file says that elgen generated it.
[[nodiscard]] bool bears_marker(const std::string& path);

/// The text of a regular file; nothing where there is none.
[[nodiscard]] std::optional<std::string> existing_text(const std::string& path);

/// A path as make and ninja want it.
[[nodiscard]] std::string escaped_for_make(const std::string& path);

enum class FileState : unsigned char {
  stale,
  edited,  ///< by hand: the file does not have the hash that it states
  missing,
  orphaned,  ///< ours, but nothing generates it any more
};

/// "stale", "edited", "missing", "orphaned"
[[nodiscard]] std::string_view name_of(FileState state);

/// A file that is not as it would be written.
struct FileDifference {
  FileState state = FileState::stale;
  std::string path = {};
  std::string detail = {};  ///< the first lines of a unified diff; of an orphan, why it is one
};

/// The differences between `files` and the disk; orphans are not looked for.
[[nodiscard]] std::vector<FileDifference> compare_files(const std::string& directory,
                                                        const EmittedFiles& files);

}  // namespace elgen::cli
