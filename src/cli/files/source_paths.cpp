// source_paths: compares paths folder by folder, after resolving links of existing files.
#include "cli/files/source_paths.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/files/inputs.hpp"

namespace elgen::cli {

namespace {

namespace fs = std::filesystem;

fs::path canonical_path(const std::string& path) {
  std::error_code error;
  const fs::path known = fs::weakly_canonical(fs::absolute(path, error), error);
  return error ? fs::path(path) : known;
}

fs::path common_folder(const fs::path& x, const fs::path& y) {
  fs::path common;
  for (auto i = x.begin(), j = y.begin(); i != x.end() && j != y.end() && *i == *j; ++i, ++j) {
    common /= *i;
  }
  return common;
}

bool is_in_repository(fs::path folder) {
  std::error_code error;
  for (; folder.has_relative_path(); folder = folder.parent_path()) {
    if (fs::exists(folder / ".git", error)) return true;
  }
  return false;
}

/// True if `folder` is or contains the home folder or a folder for temporary files. Two files below
/// a folder of this kind may be unrelated.
bool is_shared_folder(const fs::path& folder) {
  std::vector<std::string> places{"/tmp", "/var/tmp"};
  for (const char* const variable : {"HOME", "TMPDIR"}) {
    if (const char* const place = std::getenv(variable)) places.emplace_back(place);
  }
  return std::ranges::any_of(places, [&](const std::string& place) {
    return common_folder(folder, canonical_path(place)) == folder;
  });
}

std::string relative_source_path(const fs::path& directory, const SourcePointer& source) {
  if (source == nullptr) return {};
  if (source->path == stdin_name) return source->path;
  const fs::path file = canonical_path(source->path);
  const fs::path common = common_folder(file, directory);
  if (!is_in_repository(common) && is_shared_folder(common)) return file_name(*source);
  return file.lexically_relative(directory).generic_string();
}

}  // namespace

SourcePaths source_paths(const PipelineSources& inputs, const std::string& directory) {
  const fs::path known = canonical_path(directory);
  return {relative_source_path(known, inputs.model), relative_source_path(known, inputs.scene)};
}

std::optional<std::string> find_source_path(const std::string& directory,
                                            const SourcePaths& paths) {
  const std::string& path = paths.scene.empty() ? paths.model : paths.scene;
  if (path.find('/') == std::string::npos) return std::nullopt;
  return (fs::path(directory) / path).lexically_normal().generic_string();
}

}  // namespace elgen::cli
