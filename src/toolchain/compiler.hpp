// The user's C++ compiler, which compiles C as well: which one, and how it turns a source into a
// shared object.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "process.hpp"

namespace elgen {

/// The words that start the compiler ("g++", or "ccache", "g++").
using CompilerCommand = std::vector<std::string>;

/// The commands tried, in order: $CXX as one path, $CXX split at spaces, c++, g++, clang++.
[[nodiscard]] std::vector<CompilerCommand> compiler_candidates();

/// The first candidate that answers `--version`; `scratch` is a directory to write into.
[[nodiscard]] std::optional<CompilerCommand> find_compiler(const std::filesystem::path& scratch);

/// Compiles `source` as C++17, a `.c` as C99, with the warnings users are promised to be spared,
/// all of them errors. No contraction: error bounds and bit comparisons hold for the arithmetic
/// that is written.
[[nodiscard]] ProcessResult compile_shared(const CompilerCommand& compiler,
                                           const std::filesystem::path& source,
                                           const std::filesystem::path& object);

}  // namespace elgen
