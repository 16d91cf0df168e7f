// SPDX-License-Identifier: GPL-3.0-or-later
// elgen as its users have it: `cmake --install` of the build under test.
#pragma once

#include <filesystem>
#include <string>

namespace elgen::test {

/// The prefix of the installation, made once by a test program; its path has a blank.
[[nodiscard]] const std::filesystem::path& installed();

/// The option of `cmake` by which a project finds elgen in `prefix`.
[[nodiscard]] std::string finding_elgen(const std::filesystem::path& prefix = installed());

}  // namespace elgen::test
