// Workshop: a temporary directory with emitted headers and sources in it, and the user's compiler.
#pragma once

#include <dlfcn.h>

#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "elgen/emitted_files.hpp"
#include "elgen/limits.hpp"
#include "toolchain/compiler.hpp"

namespace elgen {

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

/// Its directory goes with it, what it loaded stays. Whoever opens one holds NoInterrupts.
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
