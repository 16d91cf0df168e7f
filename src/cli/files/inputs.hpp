// Reads the files of the command line as sources.
#pragma once

#include <sys/stat.h>

#include <functional>
#include <string>
#include <string_view>

#include "elgen/pipeline.hpp"

namespace elgen::cli {

/// The path of a source from standard input.
inline constexpr std::string_view stdin_name = "<stdin>";

/// Reads the file, or standard input if `path` is `-`. E111 if it does not exist, E707 if it cannot
/// be read, E901 beyond `limits.file_bytes`. Ends the process with E909 if the input does not
/// arrive within `limits.seconds`.
[[nodiscard]] Result<SourcePointer> read_source(const std::string& path, const Limits& limits);

/// A model; or a scene and its model, whose path is relative to the scene. A scene is a file
/// NAME.scene.toml, or standard input that names a model.
[[nodiscard]] Result<Inputs> read_inputs(const std::string& path, const Limits& limits);

/// Returns the source at a path.
using SourceReader = std::function<Result<SourcePointer>(const std::string& path)>;

/// read_inputs() for files that are not in the file system.
[[nodiscard]] Result<Inputs> read_inputs(const std::string& path, const Limits& limits,
                                         const SourceReader& read);

/// A source that lives as long as the process, because diagnostics point into it. E901 beyond
/// `limits.file_bytes`.
[[nodiscard]] Result<SourcePointer> kept_source(const std::string& path, std::string text,
                                                const Limits& limits);

/// True if this file was read as an input.
[[nodiscard]] bool is_input(const struct stat& file);

/// The kind of a file in words: "a folder", "a device", …; empty for a regular file.
[[nodiscard]] std::string_view special_kind(mode_t mode);

}  // namespace elgen::cli
