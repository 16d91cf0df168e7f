// The user's C++ compiler, which compiles C as well: which one, and how it turns a source into a
// shared object.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "elgen/diagnostic.hpp"
#include "elgen/toolchain.hpp"
#include "toolchain/driver.hpp"
#include "toolchain/process.hpp"

namespace elgen {

/// The words that start the compiler ("g++", or "ccache", "g++").
using CompilerCommand = std::vector<std::string>;

struct Compiler {
  CompilerCommand command = {};
  std::uint64_t seconds = 0;  ///< for one source
  std::string version = {};   ///< the first line of what `--version` answers
};

/// The commands tried, in order: $CXX as one path and split at spaces; where it is not set, c++,
/// g++, clang++.
[[nodiscard]] std::vector<CompilerCommand> compiler_candidates();

/// The first candidate that answers `--version`. E704 where none does.
[[nodiscard]] Result<Compiler> find_compiler(std::uint64_t seconds);

/// Compiles `source` as C++17, a `.c` as C99. As written: with the warnings users are promised to
/// be spared, all of them errors, and without contraction, so that bits can be compared.
[[nodiscard]] ProcessResult compile_shared(const Compiler& compiler, Build build,
                                           const std::filesystem::path& source,
                                           const std::filesystem::path& object);

/// Whether it compiles a function of one line, with the library that the source needs where that is
/// installed.
[[nodiscard]] bool takes_probe(const Compiler& compiler, Build build,
                               const std::filesystem::path& directory, const Source& source);

/// Why `compiled` failed for this source: E909 out of time, E705 where the same compiler takes the
/// probe, else E709, with the compiler's words.
[[nodiscard]] Diagnostic why_refused(const Compiler& compiler, const ProcessResult& compiled,
                                     const std::filesystem::path& directory, const Source& source);

}  // namespace elgen
