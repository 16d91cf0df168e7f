// Runs commands as users type them, with elgen in PATH, and captures their output.
#pragma once

#include <filesystem>
#include <string>

#include "support/text.hpp"

namespace elgen::test {

struct Outcome {
  int status = 0;
  std::string output = {};  ///< standard output
  std::string errors = {};  ///< standard error
  std::string command = {};
};

/// Runs `command` with /bin/sh in `folder`, without standard input. `elgen` is the binary under
/// test, $ELGEN its path. CXX and NO_COLOR are unset.
[[nodiscard]] Outcome shell(const std::string& command, const std::filesystem::path& folder);

/// The command, exit code, output and errors of a command that failed; empty if it succeeded.
[[nodiscard]] std::string failure_of(const Outcome& outcome);

/// Runs a command that prepares a test; throws if it fails.
void prepare(const std::string& command, const std::filesystem::path& folder);

/// The path of every file in the folder ("./a/b.txt"), one per line, sorted.
[[nodiscard]] std::string files_below(const std::filesystem::path& folder);

/// A new temporary folder, removed at the end of the scope.
class Workspace {
 public:
  /// The name of the folder starts with `prefix`.
  explicit Workspace(const std::string& prefix = "elgen_test_");
  Workspace(const Workspace&) = delete;
  Workspace& operator=(const Workspace&) = delete;
  ~Workspace();

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  /// The functions above for this folder. File names are relative to the folder.
  [[nodiscard]] Outcome run(const std::string& command) const { return shell(command, path_); }
  void prepare(const std::string& command) const { test::prepare(command, path_); }
  [[nodiscard]] std::string files() const { return files_below(path_); }
  [[nodiscard]] std::string read(const std::string& file) const;
  void write(const std::string& file, const std::string& text) const;

 private:
  std::filesystem::path path_;
};

}  // namespace elgen::test
