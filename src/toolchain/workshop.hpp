// Workshop: a temporary directory with emitted headers and sources in it, and the user's compiler,
// for C++ and C alike: which one, and how it turns a source into a shared object.
#pragma once

#include <dlfcn.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "elgen/emitted_files.hpp"
#include "elgen/limits.hpp"
#include "toolchain/driver.hpp"
#include "toolchain/process.hpp"

namespace elgen {

/// The words that start the user's compiler ("g++", or "ccache", "g++").
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

/// A fresh directory that is removed, with all it holds, when its owner goes.
class TemporaryDirectory {
 public:
  /// A new directory, readable by this user alone, under $TMPDIR or /tmp; none where that is not
  /// writable.
  [[nodiscard]] static std::optional<TemporaryDirectory> create();

  TemporaryDirectory(TemporaryDirectory&& other) noexcept;
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;
  ~TemporaryDirectory();

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  explicit TemporaryDirectory(std::filesystem::path path) : path_(std::move(path)) {}

  std::filesystem::path path_;
};

/// One that has these files. E706 without room.
[[nodiscard]] Result<TemporaryDirectory> directory_with(const EmittedFiles& files,
                                                        const std::vector<Source>& sources);

/// A shared object that is loaded as long as its owner lives.
class Library {
 public:
  explicit Library(const std::filesystem::path& object)
      : handle_(dlopen(object.c_str(), RTLD_NOW | RTLD_LOCAL)) {}
  Library(Library&& other) noexcept : handle_(std::exchange(other.handle_, nullptr)) {}
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
  Library& operator=(Library&&) = delete;
  ~Library() {
    if (handle_ != nullptr) dlclose(handle_);
  }

  [[nodiscard]] bool loaded() const { return handle_ != nullptr; }

  /// Null where there is no such symbol. Function: a pointer to what it is.
  template <class Function>
  [[nodiscard]] Function find(const std::string& symbol) const {
    return reinterpret_cast<Function>(dlsym(handle_, symbol.c_str()));
  }

 private:
  void* handle_;
};

/// Its directory is removed with it; loaded objects stay. The owner holds NoInterrupts.
class Workshop {
 public:
  /// E704 without a compiler, E706 without room, E909 where the compiler does not answer.
  [[nodiscard]] static Result<Workshop> open(const EmittedFiles& files,
                                             const std::vector<Source>& sources,
                                             const Limits& limits);

  /// One of the sources, compiled and loaded. E705, E709 and E909 as of `compile`.
  [[nodiscard]] Result<Library> build(const Source& source, Build build) const;

  /// Whether the compiler takes the flags of this build: of a function of one line.
  [[nodiscard]] bool takes(Build build, const Source& source) const;

 private:
  Workshop(TemporaryDirectory directory, Compiler compiler)
      : directory_(std::move(directory)), compiler_(std::move(compiler)) {}

  TemporaryDirectory directory_;
  Compiler compiler_;
};

/// E705: a symbol of a driver is not in what was loaded.
[[nodiscard]] Diagnostic missing_function();

}  // namespace elgen
