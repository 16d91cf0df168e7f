// Programs as users have them: elgen installed by `cmake --install` from the build under test, and
// other programs of this machine.
#pragma once

#include <filesystem>
#include <string>

namespace elgen::test {

/// The prefix of the installation, which a test program creates once. Its path contains a blank.
[[nodiscard]] const std::filesystem::path& installed();

/// The option of `cmake` with which a project finds elgen in `prefix`.
[[nodiscard]] std::string finding_elgen(const std::filesystem::path& prefix = installed());

/// True if the command `probe` succeeds. Otherwise prints that the program is not installed.
[[nodiscard]] bool is_installed(const std::string& program, const std::string& probe);

[[nodiscard]] inline bool has_node() { return is_installed("node", "node --version"); }

}  // namespace elgen::test
