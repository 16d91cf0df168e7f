// emit: Model, Scene, Program -> the text of every file, after the checks that only emission can
// make.
#include "elgen/emitted_files.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "eigen_header.hpp"
#include "emission_input.hpp"
#include "languages.hpp"
#include "markdown.hpp"
#include "scalar_range.hpp"
#include "sidecar.hpp"

namespace elgen {

Result<EmittedFiles> emit(const Model& model, const Scene& scene, const Program& program) {
  const Language& target = language(scene.emission.language);
  Diagnostics diagnostics = target.check_names(model, scene, program);
  const Diagnostics ranges = check_scalar_range(model, scene, program);
  diagnostics.insert(diagnostics.end(), ranges.begin(), ranges.end());
  if (scene.emission.eigen) {
    const Diagnostics names = eigen_check_names(scene, program);
    diagnostics.insert(diagnostics.end(), names.begin(), names.end());
  }
  if (has_errors(diagnostics)) return diagnostics;
  const EmissionInput input = emission_input(model, scene, program);
  EmittedFiles emitted;
  emitted.files[header_path(scene)] = target.header(input);
  if (scene.emission.eigen) emitted.files[eigen_path(scene)] = eigen_header(input);
  emitted.files[sidecar_path(scene)] = sidecar(input);
  emitted.files[markdown_path(scene)] = markdown(input);
  return emitted;
}

std::vector<std::string> emitted_paths(const Scene& scene) {
  std::vector<std::string> paths = {sidecar_path(scene), header_path(scene), markdown_path(scene)};
  if (scene.emission.eigen) paths.push_back(eigen_path(scene));
  std::sort(paths.begin(), paths.end());
  return paths;
}

std::string dump(const EmittedFiles& files) {
  std::string text;
  for (const auto& [path, content] : files.files) text += fmt::format("== {}\n{}", path, content);
  return text;
}

}  // namespace elgen
