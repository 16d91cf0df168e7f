// Files of the command line -> sources.
#pragma once

#include <string>

#include "elgen/pipeline.hpp"

namespace elgen::cli {

/// Reads `path`: E111 where it does not exist, E707 where it cannot be read, E901 beyond
/// `limits.file_bytes`.
[[nodiscard]] Result<SourcePointer> read_source(const std::string& path, const Limits& limits);

/// A model, or (NAME.scene.toml) a scene and the model it names relative to itself.
[[nodiscard]] Result<Inputs> read_inputs(const std::string& path, const Limits& limits);

}  // namespace elgen::cli
