// Benches of a trade-off. A bench derives, compiles and times either the designs of one output, or
// the runs by each method of `step`. The bench compares the results with exact values.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "elgen/pipeline.hpp"
#include "elgen/tradeoff.hpp"

namespace elgen {

/// Limits and callbacks of the process that runs a bench.
struct BenchOptions {
  Limits limits = {};
  /// Called at the start of each stage, with its name.
  std::function<void(const std::string&)> on_stage = {};
  std::function<void()> renew_time_limit = {};  ///< called before each long piece of work
};

/// A model, and its scene if any, reduced to one output.
struct SingleOutputModel {
  CheckedModel checked = {};             ///< checked.scene requests only the output
  std::optional<FileSyntax> scene = {};  ///< none: no scene file
  /// Ranges of the command line, which replace ranges of the scene.
  std::vector<SourcePointer> ranges = {};

  /// The model, scene and ranges as a source of designs. The result refers to *this.
  [[nodiscard]] DesignSource design_source() const {
    return {checked, scene ? &*scene : nullptr, {}, ranges};
  }
};

struct DesignRequest {
  PipelineSources inputs = {};
  std::string output = {};  ///< the measured output; "": as in read_single_output_model()
  DesignChoices choices = {};
  std::vector<SourcePointer> ranges = {};
  std::vector<SourcePointer> over = {};  ///< SceneOptions::over
  SourcePointer log = {};  ///< source of a StateLog with the states; null: states are drawn
};

/// The model and scene of a request, reduced to its output. If the request names no output, the
/// result has inverse_dynamics, or the first output of a scene without inverse_dynamics; the
/// diagnostics then contain the warnings and notes on the model. Errors: E601, E606, E630, E633,
/// and the errors of check().
[[nodiscard]] Result<SingleOutputModel> read_single_output_model(const DesignRequest& request,
                                                                 const Limits& limits);

/// Removes all outputs except `outputs` from the scene and the program of `products`, for example
/// the output `reaction` that a lock added.
void keep_outputs(const std::vector<std::string>& outputs, Products& products);

struct MeasuredTable {
  TradeoffTable table = {};          ///< without ranks and Pareto front, which rank_rows() adds
  Diagnostics compiler_errors = {};  ///< compiler errors of designs that the table lists as failed
};

/// Costs and errors of the designs of one output. If the scene sets `trigonometry`, the designs
/// vary in this dimension, too. If request.output is empty, warnings of the model are among the
/// diagnostics. Errors: E601, E603, E630, E631, E633, E644, E645, E650, E704, and the errors of the
/// pipeline.
[[nodiscard]] Result<MeasuredTable> measure_designs(const DesignRequest& request,
                                                    const BenchOptions& process);

struct RunRequest {
  PipelineSources inputs = {};
  double duration = 0;                    ///< length of the run in s
  std::vector<double> step_lengths = {};  ///< step lengths in s; empty: a few defaults
};

/// Costs and errors of runs from the start of the model. A run is projected onto the constraints
/// after every step. Warnings of the model are among the diagnostics. TradeoffTable::sentences
/// names the methods that do not apply to the system. Errors: E621 for a duration or step length,
/// E623 and E624 for the reference run, and the errors of the pipeline. Cost: one derivation and
/// one compilation for each method and order.
[[nodiscard]] Result<MeasuredTable> measure_runs(const RunRequest& request,
                                                 const BenchOptions& process);

}  // namespace elgen
