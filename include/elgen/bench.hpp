// Benches of a trade-off: derive, compile and time the designs of one output, or runs by every
// emitted integration step, and compare the results with exact values.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "elgen/pipeline.hpp"
#include "elgen/tradeoff.hpp"

namespace elgen {

/// Limits and callbacks of the process that runs a bench.
struct BenchProcess {
  Limits limits = {};
  /// Is called with the name of each stage when it starts.
  std::function<void(const std::string&)> on_stage = {};
  std::function<void()> renew_time_limit = {};  ///< is called before each long piece of work
};

/// A model, and its scene if any, reduced to one output.
struct OutputBase {
  CheckedModel checked = {};               ///< with the output alone
  std::optional<FileSyntax> scene = {};    ///< none: no scene file
  std::vector<SourcePointer> ranges = {};  ///< in addition to the ranges of the scene

  /// The result refers to *this.
  [[nodiscard]] DesignBase base() const { return {checked, scene ? &*scene : nullptr, {}, ranges}; }
};

/// `output` "" selects inverse_dynamics, or the first output if the scene lacks it. Notes on the
/// model are among the diagnostics. Errors: E601, E606, E630, E633, and the errors of check().
[[nodiscard]] Result<OutputBase> read_output_base(const Inputs& inputs, const std::string& output,
                                                  const std::vector<SourcePointer>& ranges,
                                                  const Limits& limits);

/// Removes all other outputs from the scene and the program. A lock may have added its reaction.
void keep_outputs(const std::vector<std::string>& outputs, Products& products);

struct DesignRequest {
  Inputs inputs = {};
  std::string output = {};  ///< "": inverse_dynamics, or the first output
  DesignChoices choices = {};
  std::vector<SourcePointer> ranges = {};
};

struct MeasuredTable {
  TradeoffTable table = {};       ///< without ranks and Pareto front: see judged()
  Diagnostics not_compiled = {};  ///< errors of the compiler, of designs that fail in the table
};

/// Warnings of the model are among the diagnostics. Errors: E601, E603, E630, E631, E633, E644,
/// E645, E704, and the errors of the pipeline.
[[nodiscard]] Result<MeasuredTable> measure_designs(const DesignRequest& request,
                                                    const BenchProcess& process);

struct RunRequest {
  Inputs inputs = {};
  double time = 0;                   ///< length of the run in s
  std::vector<double> lengths = {};  ///< step lengths in s; empty: a few defaults
};

/// Runs from the start of the model, projected onto the constraints after every step. Warnings of
/// the model are among the diagnostics. A sentence of the table names the methods that do not fit
/// the system. Errors: E621, E623, E624 of the reference run, and the errors of the pipeline. Cost:
/// one derivation and one compilation for each method and order.
[[nodiscard]] Result<MeasuredTable> measure_runs(const RunRequest& request,
                                                 const BenchProcess& process);

}  // namespace elgen
