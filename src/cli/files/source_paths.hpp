// source_paths: the paths of sources that generated files state.
//
//     generated/, models/a.toml        ->   ../models/a.toml
//     /tmp/out/, /home/ann/a.toml      ->   a.toml
#pragma once

#include <string>

#include "elgen/pipeline.hpp"

namespace elgen::cli {

/// Paths relative to the output folder, if source and output are in one repository of git or in one
/// common folder. The root, the home and folders for temporary files do not count as common.
/// Otherwise, and for standard input, bare names, so that no file reveals paths of a machine.
[[nodiscard]] SourcePaths source_paths(const Inputs& inputs, const std::string& directory);

/// The file that the paths name: the scene, or else the model. Empty if they are bare names.
[[nodiscard]] std::optional<std::string> source_file(const std::string& directory,
                                                     const SourcePaths& paths);

}  // namespace elgen::cli
