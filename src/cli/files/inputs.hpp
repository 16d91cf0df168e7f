// Reads the files of the command line as sources for diagnostics.
#pragma once

#include <sys/stat.h>

#include <functional>
#include <string>
#include <string_view>

#include "elgen/pipeline.hpp"

namespace elgen::cli {

/// The name of standard input in diagnostics.
inline constexpr std::string_view stdin_name = "<stdin>";

/// Reads a file, or standard input if `path` is "-". E111 if the file does not exist; E707 if the
/// input cannot be read; E901 if the input exceeds `limits.file_bytes`. Ends the process with E909
/// if the input does not arrive within `limits.seconds`.
[[nodiscard]] Result<SourcePointer> read_source(const std::string& path, const Limits& limits);

/// Reads a model; or a scene and the model that it names, relative to the scene's folder. A scene
/// is a file NAME.scene.toml, or standard input with a key `model`.
[[nodiscard]] Result<PipelineSources> read_inputs(const std::string& path, const Limits& limits);

/// read_source() or Revision::read_source(), with the limits of the command.
using SourceReader = std::function<Result<SourcePointer>(const std::string& path)>;

/// read_inputs() for files that are not on disk: calls `read` instead of read_source().
[[nodiscard]] Result<PipelineSources> read_inputs(const std::string& path, const Limits& limits,
                                                  const SourceReader& read);

/// Makes a source that is never destroyed, because diagnostics point into it. E901 if the text
/// exceeds `limits.file_bytes`.
[[nodiscard]] Result<SourcePointer> make_limited_source(const std::string& path, std::string text,
                                                        const Limits& limits);

/// True if read_source() has read this file.
[[nodiscard]] bool is_read_file(const struct stat& file);

/// "a folder", "a device", "a FIFO", …; empty for a regular file.
[[nodiscard]] std::string_view special_file_kind(mode_t mode);

}  // namespace elgen::cli
