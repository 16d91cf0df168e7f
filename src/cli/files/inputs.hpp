// Files of the command line -> sources.
#pragma once

#include <sys/stat.h>

#include <functional>
#include <string>
#include <string_view>

#include "elgen/pipeline.hpp"

namespace elgen::cli {

/// The path of a source that came from standard input.
inline constexpr std::string_view stdin_name = "<stdin>";

/// Reads the file, or standard input where `path` is `-`. E111 where it does not exist, E707 where
/// it cannot be read, E901 beyond `limits.file_bytes`; ends the process with E909 where it does not
/// arrive within `limits.seconds`.
[[nodiscard]] Result<SourcePointer> read_source(const std::string& path, const Limits& limits);

/// A model, or (NAME.scene.toml, or what names a model on standard input) a scene and the model it
/// names relative to itself.
[[nodiscard]] Result<Inputs> read_inputs(const std::string& path, const Limits& limits);

/// Gives the source of a path.
using SourceReader = std::function<Result<SourcePointer>(const std::string& path)>;

/// The same of files that are not in the file system.
[[nodiscard]] Result<Inputs> read_inputs(const std::string& path, const Limits& limits,
                                         const SourceReader& read);

/// A source that lives as long as the process, for diagnostics point into it; E901 where it is
/// beyond `limits.file_bytes`.
[[nodiscard]] Result<SourcePointer> kept_source(const std::string& path, std::string text,
                                                const Limits& limits);

/// Whether this is a file that was read.
[[nodiscard]] bool is_input(const struct stat& file);

/// The kind of a file in words: "a folder", "a device", …; empty for a regular file.
[[nodiscard]] std::string_view special_kind(mode_t mode);

}  // namespace elgen::cli
