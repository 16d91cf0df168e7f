// source_paths: what files say they were made from.
//
//     generated/, models/a.toml        ->   ../models/a.toml
//     /tmp/out/, /home/ann/a.toml      ->   a.toml
#pragma once

#include <string>

#include "elgen/pipeline.hpp"

namespace elgen::cli {

/// Relative to the folder that everything is written below, whatever that is called, where both are
/// in one repository of git, or in one folder other than the root, the home and those for temporary
/// files. Names elsewhere, so that no file tells of a machine, and of standard input.
[[nodiscard]] SourcePaths source_paths(const Inputs& inputs, const std::string& directory);

/// The file that such paths name, of a scene itself; none where they are but names.
[[nodiscard]] std::optional<std::string> source_file(const std::string& directory,
                                                     const SourcePaths& paths);

}  // namespace elgen::cli
