// Benches of a trade-off: derive, compile and time the designs of one output, or runs in time by
// all steps that can be emitted, and compare them with exact values.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "elgen/pipeline.hpp"
#include "elgen/tradeoff.hpp"

namespace elgen {

/// The process in which a bench works.
struct BenchProcess {
  Limits limits = {};
  std::function<void(const std::string&)> on_stage = {};  ///< told each name as it starts
  std::function<void()> renew_time_limit = {};            ///< called before work of its own
};

/// A model or its scene, with one output.
struct OutputBase {
  CheckedModel checked = {};               ///< with the output alone
  std::optional<FileSyntax> scene = {};    ///< where there is one
  std::vector<SourcePointer> ranges = {};  ///< beside those of the scene

  /// Valid while this lives.
  [[nodiscard]] DesignBase base() const { return {checked, scene ? &*scene : nullptr, {}, ranges}; }
};

/// `output` "": inverse_dynamics, or the first one there is. Notes on the model are among the
/// diagnostics. E601, E606, E630, E633, and what checks say of a model.
[[nodiscard]] Result<OutputBase> output_base(const Inputs& inputs, const std::string& output,
                                             const std::vector<SourcePointer>& ranges,
                                             const Limits& limits);

/// Leaves these outputs of what was derived; a lock may have asked for its reaction too.
void keep_only(const std::vector<std::string>& outputs, Products& products);

struct DesignRequest {
  Inputs inputs = {};
  std::string output = {};  ///< "": inverse_dynamics, or the first one there is
  DesignChoices choices = {};
  std::vector<SourcePointer> ranges = {};
};

struct MeasuredTable {
  TradeoffTable table = {};       ///< not judged
  Diagnostics not_compiled = {};  ///< of designs that fail in the table
};

/// Warnings of the model are among the diagnostics. E601, E603, E630, E631, E633, E644, E645, E704,
/// and what its stages say of a model.
[[nodiscard]] Result<MeasuredTable> measured_designs(const DesignRequest& request,
                                                     const BenchProcess& process);

struct RunRequest {
  Inputs inputs = {};
  double time = 0;                   ///< s
  std::vector<double> lengths = {};  ///< of steps; empty: a few
};

/// Runs from the start, put back onto constraints behind every step. Warnings of the model are
/// among the diagnostics; methods that are not for the system are named in a sentence. E621, E623,
/// E624 of the reference, and what its stages say of a model. Cost: a derivation and a compilation
/// for each method and order.
[[nodiscard]] Result<MeasuredTable> measured_runs(const RunRequest& request,
                                                  const BenchProcess& process);

}  // namespace elgen
