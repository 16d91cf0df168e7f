// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/installed.hpp"

#include "support/shell.hpp"

namespace elgen::test {

namespace {

class Installation : public Workspace {
 public:
  Installation() : Workspace("a prefix ") {
    prepare("cmake --install '" ELGEN_BUILD_DIR "' --prefix .");
  }
};

}  // namespace

const std::filesystem::path& installed() {
  static const Installation made;
  return made.path();
}

std::string finding_elgen(const std::filesystem::path& prefix) {
  return "'-DCMAKE_PREFIX_PATH=" + prefix.string() + "'";
}

}  // namespace elgen::test
