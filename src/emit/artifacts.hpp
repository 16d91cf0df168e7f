// artifacts: how each kind of file is written, and which names its language needs for itself.
#pragma once

#include <string>

#include "elgen/artifacts.hpp"
#include "emission_input.hpp"

namespace elgen {

// Texts with their body hash.
[[nodiscard]] std::string cpp_header(const EmissionInput& input);
[[nodiscard]] std::string eigen_header(const EmissionInput& input);
[[nodiscard]] std::string c99_header(const EmissionInput& input);

// E701 for parameters, functions and namespaces whose name the emitted code needs.
[[nodiscard]] Diagnostics cpp_check_names(const Model& model, const Scene& scene,
                                          const Program& program);
[[nodiscard]] Diagnostics eigen_check_names(const Model& model, const Scene& scene,
                                            const Program& program);
[[nodiscard]] Diagnostics c99_check_names(const Model& model, const Scene& scene,
                                          const Program& program);

struct Writer {
  std::string (*text)(const EmissionInput& input);
  /// Null where every name will do.
  Diagnostics (*check_names)(const Model& model, const Scene& scene, const Program& program);
};
[[nodiscard]] const Writer& writer_of(ArtifactId id);

/// E701 at the span of what wants the name.
[[nodiscard]] Diagnostic taken_name(const std::string& name, const char* what, const Span& span);

/// Where the scene asks for a function; nowhere for the scene `full`.
[[nodiscard]] Span span_of(const Scene& scene, const Function& function);

}  // namespace elgen
