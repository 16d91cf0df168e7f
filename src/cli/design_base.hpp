// What all designs start from: a model or its scene, with one output.
#pragma once

#include <optional>

#include "elgen/pipeline.hpp"
#include "elgen/tradeoff.hpp"

namespace elgen::cli {

struct OutputBase {
  CheckedModel checked = {};             ///< with the output alone
  std::optional<FileSyntax> scene = {};  ///< where there is one

  /// Valid while this lives.
  [[nodiscard]] DesignBase base() const { return {checked, scene ? &*scene : nullptr}; }
};

/// `output` "": inverse_dynamics, or the first one there is. What is said of the model is among the
/// diagnostics, which point into texts that `sources` gets. E601, and what checks say of a model.
[[nodiscard]] Result<OutputBase> output_base(const Inputs& inputs, const std::string& output,
                                             const Limits& limits,
                                             std::vector<SourcePointer>& sources);

/// Leaves the output alone of what was derived; a lock may have asked for its reaction too.
void keep_only(const std::string& output, Products& products);

}  // namespace elgen::cli
