// LoadedVersion: a model or a scene, read and ready to be compared.
#pragma once

#include <optional>
#include <string>

#include "elgen/diff.hpp"
#include "elgen/pipeline.hpp"

namespace elgen::cli {

/// A model or scene with its equations, and what these point into.
struct LoadedVersion {
  Inputs inputs = {};
  FileSyntax model = {};
  std::optional<FileSyntax> scene = {};
  Products products = {};
  OperationsByName operations = {};

  [[nodiscard]] Version version() const;
};

/// The base name of its files: MODEL, or MODEL_SCENE. "" where it has errors.
[[nodiscard]] std::string system_name(const Inputs& inputs, const Limits& limits);

/// Errors and warnings that are found without the equations.
[[nodiscard]] Diagnostics mistakes(const Inputs& inputs, const Limits& limits);

/// Errors: those of the stages up to the equations.
[[nodiscard]] Result<LoadedVersion> load_version(const Inputs& inputs, const Limits& limits);

}  // namespace elgen::cli
