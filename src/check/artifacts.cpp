// artifacts_of: the rows whose condition holds.
#include "elgen/artifacts.hpp"

#include <fmt/format.h>

namespace elgen {

std::string path_of(const Scene& scene, ArtifactId id) {
  return fmt::format("{0}/{0}{1}", scene.base_name, row_of(artifact_table, id).ending);
}

std::vector<Artifact> artifacts_of(const Scene& scene) {
  std::vector<Artifact> artifacts;
  for (const ArtifactRow& row : artifact_table) {
    if (row.is_wanted(scene.emission)) artifacts.push_back({row.id, path_of(scene, row.id)});
  }
  return artifacts;
}

}  // namespace elgen
