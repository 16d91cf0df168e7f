// Projects that use an installed elgen, in folders with a blank in their paths.
#pragma once

#include <filesystem>
#include <string>

#include "support/installed.hpp"
#include "support/shell.hpp"

namespace elgen::test {

inline const std::string models = ELGEN_SOURCE_DIR "/models";

/// The number after `words` in `text`; throws if `text` does not contain `words`.
[[nodiscard]] double number_after(const std::string& text, const std::string& words);

/// Writes the Debian package of this build into the workspace and returns its path; empty if
/// dpkg-dev is not installed.
[[nodiscard]] std::filesystem::path write_package(const Workspace& workspace);

/// A copy of examples/NAME, configured and built in `build`.
class Example : public Workspace {
 public:
  /// Throws if the build fails.
  explicit Example(const std::string& name, const std::string& options = "-G Ninja");
};

/// True if examples/README.md shows `output`, the output of an example.
[[nodiscard]] bool is_in_readme(const std::string& output);

}  // namespace elgen::test
