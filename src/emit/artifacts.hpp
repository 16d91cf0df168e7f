// artifacts: how each kind of file is written, and which names its language needs for itself.
#pragma once

#include <string>

#include "elgen/artifacts.hpp"
#include "emit/text/emission_input.hpp"

namespace elgen {

struct Writer {
  std::string (*text)(const EmissionInput& input);
  /// Null where every name will do.
  Diagnostics (*check_names)(const Model& model, const Scene& scene, const Program& program);
};
[[nodiscard]] const Writer& writer_of(ArtifactId id);

}  // namespace elgen
