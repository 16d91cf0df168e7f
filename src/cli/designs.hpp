// The designs of one output, and what they start from: derived, compiled, timed, and compared with
// what is exact.
#pragma once

#include <optional>

#include "cli/options.hpp"
#include "elgen/pipeline.hpp"
#include "elgen/tradeoff.hpp"

namespace elgen::cli {

/// A model or its scene, with one output.
struct OutputBase {
  CheckedModel checked = {};             ///< with the output alone
  std::optional<FileSyntax> scene = {};  ///< where there is one

  /// Valid while this lives.
  [[nodiscard]] DesignBase base() const { return {checked, scene ? &*scene : nullptr}; }
};

/// `output` "": inverse_dynamics, or the first one there is. Notes on the model are among the
/// diagnostics, which point into texts that `sources` gets. E601, and what checks say of a model.
[[nodiscard]] Result<OutputBase> output_base(const Inputs& inputs, const std::string& output,
                                             const Limits& limits,
                                             std::vector<SourcePointer>& sources);

/// Leaves the output alone of what was derived; a lock may have asked for its reaction too.
void keep_only(const std::string& output, Products& products);

struct DesignRequest {
  std::string path = {};  ///< as the command line has it
  Inputs inputs = {};
  std::string output = {};  ///< "": inverse_dynamics, or the first one there is
  DesignChoices choices = {};
  std::vector<SourcePointer> ranges = {};
};

struct MeasuredDesigns {
  TradeoffTable table = {};       ///< not judged
  Diagnostics not_compiled = {};  ///< of designs that fail in the table
};

/// Warnings of the model are among the diagnostics, which point into texts that `sources` gets.
/// E601, E603, E630, E631, E644, E645, E704, and what its stages say of a model.
[[nodiscard]] Result<MeasuredDesigns> measured_designs(const DesignRequest& request,
                                                       const Limits& limits,
                                                       std::vector<SourcePointer>& sources);

}  // namespace elgen::cli
