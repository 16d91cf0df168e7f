// The files of a folder as inputs of the pipeline.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "elgen/source_text.hpp"
#include "support/shell.hpp"

namespace elgen::test {

/// The files whose names end in `ending`, sorted.
inline std::vector<std::filesystem::path> inputs_in(const std::filesystem::path& folder,
                                                    const std::string& ending) {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().string().ends_with(ending)) paths.push_back(entry.path());
  }
  std::ranges::sort(paths);
  return paths;
}

inline SourcePointer source_of(const std::filesystem::path& path) {
  return make_source(path.string(), read_text(path));
}

}  // namespace elgen::test
