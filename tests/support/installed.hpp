// Programs as users have them: elgen by `cmake --install` of the build under test, others where
// they are installed.
#pragma once

#include <filesystem>
#include <string>

namespace elgen::test {

/// The prefix of the installation, made once by a test program; its path has a blank.
[[nodiscard]] const std::filesystem::path& installed();

/// The option of `cmake` by which a project finds elgen in `prefix`.
[[nodiscard]] std::string finding_elgen(const std::filesystem::path& prefix = installed());

/// Whether the program answers the probe, a command; where it does not, a line says that it is not
/// installed.
[[nodiscard]] bool is_installed(const std::string& program, const std::string& probe);

}  // namespace elgen::test
