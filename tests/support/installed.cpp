// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/installed.hpp"

#include "support/shell.hpp"

namespace elgen::test {

const std::filesystem::path& installed() {
  static const Workspace workspace("a prefix ");
  static const bool is_made = [] {
    workspace.prepare("cmake --install '" ELGEN_BUILD_DIR "' --prefix .");
    return true;
  }();
  static_cast<void>(is_made);
  return workspace.path();
}

std::string finding_elgen(const std::filesystem::path& prefix) {
  return "'-DCMAKE_PREFIX_PATH=" + prefix.string() + "'";
}

}  // namespace elgen::test
