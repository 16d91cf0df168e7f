// Projects that use elgen as it is installed, in folders with a blank in their paths.
#pragma once

#include <filesystem>
#include <string>

#include "support/installed.hpp"
#include "support/shell.hpp"

namespace elgen::test {

inline const std::string models = ELGEN_SOURCE_DIR "/models";

/// The number behind the words; throws where they are not there.
[[nodiscard]] double number_after(const std::string& text, const std::string& words);

/// Writes the package of Debian of this build into the workspace, and returns its path; an empty
/// one where dpkg-dev is not there.
[[nodiscard]] std::filesystem::path packed(const Workspace& workspace);

/// A copy of examples/NAME, configured and built in `build`.
class Example : public Workspace {
 public:
  /// Throws where it does not build.
  explicit Example(const std::string& name, const std::string& options = "-G Ninja");
};

/// Whether examples/README.md shows what an example printed.
[[nodiscard]] bool is_shown(const std::string& output);

}  // namespace elgen::test
