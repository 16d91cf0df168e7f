// emit: Model, Scene, Program -> the text of every file, after the checks that only emission can
// make.
#include "elgen/emitted_files.hpp"

#include "emit/artifacts.hpp"
#include "emit/text/emission_input.hpp"
#include "emit/text/scalar_range.hpp"

namespace elgen {

Result<EmittedFiles> emit(const Model& model, const Scene& scene, const Program& program) {
  const std::vector<Artifact> wanted = artifacts_of(scene);
  Diagnostics diagnostics;
  for (const Artifact& artifact : wanted) {
    const auto check_names = writer_of(artifact.id).check_names;
    if (check_names == nullptr) continue;
    const Diagnostics names = check_names(model, scene, program);
    diagnostics.insert(diagnostics.end(), names.begin(), names.end());
  }
  const Diagnostics ranges = check_scalar_range(model, scene, program);
  diagnostics.insert(diagnostics.end(), ranges.begin(), ranges.end());
  if (has_errors(diagnostics)) return diagnostics;
  const EmissionInput input = emission_input(model, scene, program);
  EmittedFiles emitted;
  for (const auto& [id, path] : wanted) emitted.files[path] = writer_of(id).text(input);
  return emitted;
}

}  // namespace elgen
