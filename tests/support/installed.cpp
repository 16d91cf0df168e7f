#include "support/installed.hpp"

#include <iostream>

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

bool is_installed(const std::string& program, const std::string& probe) {
  if (shell(probe, "/").status == 0) return true;
  std::cout << "skipped: " << program << " is not installed\n";
  return false;
}

}  // namespace elgen::test
