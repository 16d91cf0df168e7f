// LoadedVersion: a model, a scene or a sidecar of equations, read and ready to be compared.
#pragma once

#include <optional>
#include <variant>

#include "elgen/diff.hpp"
#include "elgen/pipeline.hpp"

namespace elgen::cli {

/// A model or scene with its equations, and what these point into.
struct LoweredVersion {
  Inputs inputs = {};
  FileSyntax model = {};
  std::optional<FileSyntax> scene = {};
  Products products = {};
  OperationsByName operations = {};

  [[nodiscard]] Version version() const;
};

using LoadedVersion = std::variant<LoweredVersion, SidecarVersion>;

[[nodiscard]] Version version_of(const LoadedVersion& loaded);

/// NAME.equations.json, or what begins with a brace on standard input.
[[nodiscard]] bool is_sidecar(const SourceText& source);

/// A sidecar has no scene. Errors: those of the stages up to the equations; E714.
[[nodiscard]] Result<LoadedVersion> load_version(const Inputs& inputs, const Limits& limits);

}  // namespace elgen::cli
