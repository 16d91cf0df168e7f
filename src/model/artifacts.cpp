// artifacts: the kinds of files that a scene requests, and their paths.
#include "elgen/artifacts.hpp"

#include <fmt/format.h>

namespace elgen {

std::string artifact_path(const Scene& scene, ArtifactId id) {
  const std::string_view ending = artifact_table[id].path_suffix;
  const std::string of_language =
      fmt::format(".{}", language_row(scene.emission.language).file_extension);
  return fmt::format("{0}/{0}{1}", scene.base_name, ending.empty() ? of_language : ending);
}

std::vector<Artifact> requested_artifacts(const Scene& scene) {
  std::vector<Artifact> artifacts;
#define ELGEN_ARTIFACT(kind)                                                         \
  if (artifact_table.kind.is_requested(scene)) {                                     \
    artifacts.push_back({ArtifactId::kind, artifact_path(scene, ArtifactId::kind)}); \
  }
#include "elgen/artifacts.def"
  return artifacts;
}

}  // namespace elgen
