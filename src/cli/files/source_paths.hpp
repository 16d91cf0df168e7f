// source_paths: the paths of sources that generated files state, relative to the output folder:
//
//     generated/, models/a.toml        ->   ../models/a.toml
//     /tmp/out/, /home/ann/a.toml      ->   a.toml
#pragma once

#include <string>

#include "elgen/pipeline.hpp"

namespace elgen::cli {

/// The paths of the sources: relative to `directory` if both are in one git repository, or have a
/// common folder other than the root, the home folder and folders for temporary files. Otherwise,
/// and for standard input, only the file's name, so that files reveal no paths of a machine.
[[nodiscard]] SourcePaths source_paths(const PipelineSources& inputs, const std::string& directory);

/// The path of the scene in `paths`, or of the model if there is no scene; none if `paths` contains
/// only the name of the file.
[[nodiscard]] std::optional<std::string> find_source_path(const std::string& directory,
                                                          const SourcePaths& paths);

}  // namespace elgen::cli
