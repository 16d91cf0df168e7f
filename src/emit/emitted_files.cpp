// emitted_files: Model, Scene, Program -> the text of every file, after checks of names and of the
// range of numbers.
#include "elgen/emitted_files.hpp"

#include "elgen/artifacts.hpp"
#include "emit/text/emission_checks.hpp"
#include "emit/text/emission_input.hpp"

namespace elgen {
namespace {

/// The writer of a kind of file, and the check for names that the language of the file reserves.
struct ArtifactWriter {
  std::string (*write)(const EmissionInput& input);
  /// Null if every name is allowed.
  Diagnostics (*check_names)(const Model& model, const Scene& scene, const Program& program);
};

constexpr ArtifactTable<ArtifactWriter> artifact_writers{
    .cpp = {&cpp_header, &cpp_check_names},
    .eigen = {&eigen_header, &eigen_check_names},
    .batch = {&batch_header, &batch_check_names},
    .wide = {&wide_header, &wide_check_names},
    .c99 = {&c99_header, &c99_check_names},
    .source = {&source_module, &source_check_names},
    .sidecar = {&sidecar_text, nullptr},
    .page = {&markdown_page_text, nullptr}};

}  // namespace

Result<std::string> emitted_script(const Model& model, const Scene& scene, const Program& program) {
  Diagnostics diagnostics = source_check_names(model, scene, program);
  const Diagnostics ranges = check_scalar_range(model, scene, program);
  diagnostics.insert(diagnostics.end(), ranges.begin(), ranges.end());
  if (has_errors(diagnostics)) return diagnostics;
  return source_script(emission_input(model, scene, program, {}));
}

Result<EmittedFiles> emit(const Model& model, const Scene& scene, const Program& program,
                          const PagePrograms& book) {
  const std::vector<Artifact> wanted = requested_artifacts(scene);
  Diagnostics diagnostics;
  for (const Artifact& artifact : wanted) {
    const auto check_names = artifact_writers[artifact.id].check_names;
    if (check_names == nullptr) continue;
    const Diagnostics names = check_names(model, scene, program);
    diagnostics.insert(diagnostics.end(), names.begin(), names.end());
  }
  const Diagnostics ranges = check_scalar_range(model, scene, program);
  diagnostics.insert(diagnostics.end(), ranges.begin(), ranges.end());
  if (has_errors(diagnostics)) return diagnostics;
  const EmissionInput input = emission_input(model, scene, program, book);
  EmittedFiles emitted;
  for (const auto& [id, path] : wanted) emitted.files[path] = artifact_writers[id].write(input);
  return emitted;
}

}  // namespace elgen
