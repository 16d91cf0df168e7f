// emit: Model, Scene, Program -> the text of every file, after the checks that only emission can
// make.
#include "elgen/emitted_files.hpp"

#include <fmt/format.h>

#include "cpp_names.hpp"
#include "emission_input.hpp"
#include "header.hpp"
#include "markdown.hpp"
#include "scalar_range.hpp"
#include "sidecar.hpp"

namespace elgen {

Result<EmittedFiles> emit(const Model& model, const Scene& scene, const Program& program) {
  Diagnostics diagnostics = check_names(model, scene, program);
  const Diagnostics ranges = check_scalar_range(model, scene, program);
  diagnostics.insert(diagnostics.end(), ranges.begin(), ranges.end());
  if (has_errors(diagnostics)) return diagnostics;
  const EmissionInput input = emission_input(model, scene, program);
  EmittedFiles emitted;
  emitted.files[header_path(scene)] = cpp_header(input);
  emitted.files[sidecar_path(scene)] = sidecar(input);
  emitted.files[markdown_path(scene)] = markdown(input);
  return emitted;
}

std::vector<std::string> emitted_paths(const Scene& scene) {
  return {sidecar_path(scene), header_path(scene), markdown_path(scene)};
}

std::string dump(const EmittedFiles& files) {
  std::string text;
  for (const auto& [path, content] : files.files) text += fmt::format("== {}\n{}", path, content);
  return text;
}

}  // namespace elgen
