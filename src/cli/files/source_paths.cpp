// source_paths: by the names of folders; links are followed where they exist.
#include "cli/files/source_paths.hpp"

#include <algorithm>
#include <filesystem>

#include "cli/files/inputs.hpp"

namespace elgen::cli {

namespace {

namespace fs = std::filesystem;

fs::path complete(const std::string& path) {
  std::error_code error;
  const fs::path known = fs::weakly_canonical(fs::absolute(path, error), error);
  return error ? fs::path(path) : known;
}

std::string path_from(const fs::path& directory, const SourcePointer& source) {
  if (source == nullptr) return {};
  if (source->path == stdin_name) return source->path;
  const fs::path relative = complete(source->path).lexically_relative(directory);
  const auto steps_up = std::ranges::count(relative, fs::path(".."));
  const fs::path inside = directory.relative_path();
  const bool is_far = steps_up >= std::distance(inside.begin(), inside.end());
  return relative.empty() || is_far ? file_name(*source) : relative.generic_string();
}

}  // namespace

SourcePaths source_paths(const Inputs& inputs, const std::string& directory) {
  const fs::path known = complete(directory);
  return {path_from(known, inputs.model), path_from(known, inputs.scene)};
}

std::optional<std::string> source_file(const std::string& directory, const std::string& path) {
  if (path.find('/') == std::string::npos) return std::nullopt;
  return (fs::path(directory) / path).lexically_normal().generic_string();
}

}  // namespace elgen::cli
