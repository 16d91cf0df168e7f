// CompilerSession: a temporary directory with emitted headers and sources, and the user's compiler
// for C++ and C, which turns each source into a shared object.
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

/// The words of the compiler command: {"g++"}, or {"ccache", "g++"}.
using CompilerCommand = std::vector<std::string>;

struct Compiler {
  CompilerCommand command = {};
  std::uint64_t seconds = 0;  ///< time limit for each source
  std::string version = {};   ///< first line of the answer to `--version`
};

/// The commands to try, in this order: if $CXX is set, $CXX as one path, then $CXX split at spaces;
/// otherwise c++, g++, clang++.
[[nodiscard]] std::vector<CompilerCommand> compiler_candidates();

/// The first candidate that answers `--version`. E704 if none answers; E909 after `seconds`.
[[nodiscard]] Result<Compiler> find_compiler(std::uint64_t seconds);

/// Compiles `source` as C++17, or a `.c` file as C99. BuildFlags::as_written turns the warnings
/// that emitted code must not cause into errors, and disables contraction, so that results can be
/// compared bit by bit.
[[nodiscard]] ProcessResult compile_shared(const Compiler& compiler, BuildFlags build,
                                           const std::filesystem::path& source,
                                           const std::filesystem::path& object);

/// True if the compiler accepts the flags of the build for a probe: a function of one line, with
/// the header that the source needs, if this header is installed.
[[nodiscard]] bool accepts_probe(const Compiler& compiler, BuildFlags build,
                                 const std::filesystem::path& directory, const SourceFile& source);

/// The error of a failed compilation: E909 if the time ran out; E705 if the compiler refuses
/// the source but accepts the probe; otherwise E709. E705 and E709 contain the compiler's output.
[[nodiscard]] Diagnostic compile_error(const Compiler& compiler, const ProcessResult& compiled,
                                       const std::filesystem::path& directory,
                                       const SourceFile& source);

/// A new directory; the destructor removes it with its content.
class TemporaryDirectory {
 public:
  /// Makes a directory under $TMPDIR or /tmp that only this user can read; none if the parent is
  /// not writable.
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

/// A temporary directory that contains these files. E706 if they cannot be written.
[[nodiscard]] Result<TemporaryDirectory> make_source_directory(
    const EmittedFiles& files, const std::vector<SourceFile>& sources);

/// A loaded shared object; the destructor unloads it.
class SharedLibrary {
 public:
  explicit SharedLibrary(const std::filesystem::path& object)
      : handle_(dlopen(object.c_str(), RTLD_NOW | RTLD_LOCAL)) {}
  SharedLibrary(SharedLibrary&& other) noexcept : handle_(std::exchange(other.handle_, nullptr)) {}
  SharedLibrary(const SharedLibrary&) = delete;
  SharedLibrary& operator=(const SharedLibrary&) = delete;
  SharedLibrary& operator=(SharedLibrary&&) = delete;
  ~SharedLibrary() {
    if (handle_ != nullptr) dlclose(handle_);
  }

  [[nodiscard]] bool is_loaded() const { return handle_ != nullptr; }

  /// The symbol's address; null if the symbol does not exist. Function: a pointer type.
  template <class Function>
  [[nodiscard]] Function find(const std::string& symbol) const {
    return reinterpret_cast<Function>(dlsym(handle_, symbol.c_str()));
  }

 private:
  void* handle_;
};

/// The destructor removes the directory; loaded objects remain valid. The owner must hold a
/// SignalBlocker.
class CompilerSession {
 public:
  /// E704 without a compiler; E706 if files cannot be written; E909 if the compiler does not answer
  /// in time.
  [[nodiscard]] static Result<CompilerSession> open(const EmittedFiles& files,
                                                    const std::vector<SourceFile>& sources,
                                                    const Limits& limits);

  /// Compiles and loads a source. Errors: compile_error(), or E709 if the object cannot be loaded.
  [[nodiscard]] Result<SharedLibrary> build(const SourceFile& source, BuildFlags build) const;

  /// accepts_probe() in this directory: true if the compiler accepts the flags of the build.
  [[nodiscard]] bool accepts_flags(BuildFlags build, const SourceFile& source) const;

 private:
  CompilerSession(TemporaryDirectory directory, Compiler compiler)
      : directory_(std::move(directory)), compiler_(std::move(compiler)) {}

  TemporaryDirectory directory_;
  Compiler compiler_;
};

/// E705: the loaded object lacks a symbol of a driver.
[[nodiscard]] Diagnostic missing_function_error();

}  // namespace elgen
