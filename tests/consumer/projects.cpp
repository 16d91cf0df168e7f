#include "consumer/projects.hpp"

#include <stdexcept>

namespace elgen::test {

double number_after(const std::string& text, const std::string& words) {
  const std::size_t at = text.find(words);
  if (at == std::string::npos) throw std::runtime_error("no `" + words + "` in: " + text);
  return std::stod(text.substr(at + words.size()));
}

std::filesystem::path write_package(const Workspace& workspace) {
  if (!is_installed("dpkg-dev or file", "command -v dpkg-shlibdeps && command -v file")) return {};
  workspace.prepare("cpack -G DEB --config '" ELGEN_BUILD_DIR
                    "/CPackConfig.cmake' -B packed && mv packed/*.deb elgen.deb");
  return workspace.path() / "elgen.deb";
}

Example::Example(const std::string& name, const std::string& options) : Workspace("an example ") {
  prepare("cp -r '" ELGEN_SOURCE_DIR "/examples/" + name + "/.' . && cmake -S . -B build " +
          options + " " + finding_elgen() + " && cmake --build build");
}

bool is_in_readme(const std::string& output) {
  return !output.empty() && mentions(read_text(ELGEN_SOURCE_DIR "/examples/README.md"), output);
}

}  // namespace elgen::test
