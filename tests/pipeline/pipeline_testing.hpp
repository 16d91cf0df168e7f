// What tests of the pipeline share: models of the project, and runs of generated headers.
#pragma once

#include <string>

#include "support/shell.hpp"

namespace elgen::test {

inline std::string model_file(const std::string& name) {
  return read_text(std::string(ELGEN_SOURCE_DIR) + "/models/" + name + ".toml");
}

/// What a program prints that includes headers in the folder or those of the project.
inline std::string printed(const Workspace& folder, const std::string& program) {
  write_text(folder.path() / "main.cpp", program);
  const std::string include = std::string(ELGEN_SOURCE_DIR) + "/generated";
  prepare("c++ -std=c++17 -O1 -I. -I'" + include + "' main.cpp -o main", folder.path());
  return shell("./main", folder.path()).output;
}

}  // namespace elgen::test
