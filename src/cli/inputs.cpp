// Reads the files a command names. A scene's model is found through the scene's own text.
#include "inputs.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

namespace elgen::cli {

namespace {

namespace fs = std::filesystem;

bool is_scene(const std::string& path) {
  static const std::string suffix = ".scene.toml";
  return path.size() > suffix.size() &&
         path.compare(path.size() - suffix.size(), suffix.size(), suffix) == 0;
}

/// Diagnostics point into sources without owning them, so sources live as long as the process.
const SourcePointer& kept(SourcePointer source) {
  static std::vector<SourcePointer> sources;
  return sources.emplace_back(std::move(source));
}

const ValueSyntax* model_path(const SceneSyntax& scene) {
  for (const EntrySyntax& entry : scene.entries) {
    if (!entry.name.empty()) continue;
    const KeySyntax* key = entry.find("model");
    if (key != nullptr) return &key->value;
  }
  return nullptr;
}

}  // namespace

Result<SourcePointer> read_source(const std::string& path, const Limits& limits) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) {
    return Diagnostic{Code::E111, {}, fmt::format("`{}` does not exist", path)};
  }
  if (fs::is_directory(status)) {
    return Diagnostic{Code::E707, {}, fmt::format("`{}` is a folder, not a file", path)};
  }
  const std::uintmax_t size = fs::file_size(path, error);
  if (!error && size > limits.file_bytes) {
    return Diagnostic{
        Code::E901,
        {},
        fmt::format("`{}` has {} bytes: the limit is {}", path, size, limits.file_bytes),
        "raised by --limit file_bytes=N"};
  }
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file) return Diagnostic{Code::E707, {}, fmt::format("`{}` could not be read", path)};
  return kept(make_source(path, text.str()));
}

Result<Inputs> read_inputs(const std::string& path, const Limits& limits) {
  Result<SourcePointer> source = read_source(path, limits);
  if (!source) return source.diagnostics;
  if (!is_scene(path)) return Inputs{*source, nullptr};

  const Result<SceneSyntax> scene = parse_scene(*source, limits);
  if (!scene) return scene.diagnostics;
  const ValueSyntax* named = model_path(*scene);
  if (named == nullptr) return scene.diagnostics;  // parse has reported the missing key
  const fs::path model = fs::path(path).parent_path() / named->text;
  Result<SourcePointer> model_source = read_source(model.lexically_normal().string(), limits);
  if (!model_source) {
    // The mistake is in the scene: point there.
    Diagnostics errors = model_source.diagnostics;
    errors.front().span = named->span;
    return errors;
  }
  return Inputs{*model_source, *source};
}

}  // namespace elgen::cli
