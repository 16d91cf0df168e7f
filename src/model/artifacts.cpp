// artifacts: the kinds of files that a scene requests, and their paths.
#include "elgen/artifacts.hpp"

#include <fmt/format.h>

namespace elgen {

std::string path_of(const Scene& scene, ArtifactId id) {
  const std::string_view ending = artifact_table[id].ending;
  const std::string of_language = fmt::format(".{}", language_row(scene.emission.language).ending);
  return fmt::format("{0}/{0}{1}", scene.base_name, ending.empty() ? of_language : ending);
}

std::vector<Artifact> artifacts_of(const Scene& scene) {
  std::vector<Artifact> artifacts;
#define ELGEN_ARTIFACT(kind)                                                   \
  if (artifact_table.kind.is_wanted(scene)) {                                  \
    artifacts.push_back({ArtifactId::kind, path_of(scene, ArtifactId::kind)}); \
  }
#include "elgen/artifacts.def"
  return artifacts;
}

}  // namespace elgen
