// Trajectory: a simulated run of a system. The functions of the system are called in the
// interpreter or as compiled emitted code.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "elgen/pipeline.hpp"
#include "elgen/program.hpp"
#include "elgen/scene.hpp"
#include "elgen/step_methods.hpp"
#include "elgen/toolchain.hpp"

namespace elgen {

/// Options of a run; times are in s. At most one of `step` and `tolerance` is set. Methods with a
/// fixed step use `step`; all other methods adapt the step, and `tolerance` limits its absolute and
/// relative error.
struct SimulationOptions {
  std::string method = "dopri5";            ///< a method of run/steps/methods.cpp
  std::optional<std::uint32_t> order = {};  ///< order of the step; none: order of `method` alone
  double from = 0;
  double duration = 0;  ///< the run ends at `from` + `duration`
  /// Largest step; equal steps fill each interval between rows or holds.
  std::optional<double> step = {};
  std::optional<double> tolerance = {};     ///< none: 1e-9 if `step` is not set either
  std::optional<double> row_interval = {};  ///< time between rows; none: no rows
  /// Time for which the inputs stay constant; none: inputs follow their laws continuously.
  std::optional<double> input_hold_time = {};
  bool projects = true;                   ///< true: project onto the constraints after each step
  bool continues_at_singularity = false;  ///< true: go on if M or A loses rank; needs `step`
  std::vector<std::string> panel_columns = {};  ///< columns that get separate panels in the plot
  std::string path = {};                        ///< the point whose path is drawn; "": none
  /// Called repeatedly with the time in s that the run has reached; if `compile` is set, only after
  /// its call.
  std::function<void(double)> on_progress = {};
  /// Called once, after the interpreter has computed `most_interpreted` instructions. The run
  /// continues with the returned functions, whose results have the same bits, and times only these;
  /// with null, it continues in the interpreter. Not set: the code does not change during the run.
  std::function<Result<const CompiledModel*>()> compile = {};
  /// About two seconds of the interpreter, the time that a compiler takes for a robot.
  std::size_t most_interpreted = 1 << 28;
};

/// The deviation of a conserved quantity from its initial value, relative to `scale`.
struct Drift {
  std::string name = {};
  std::string measure = {};  ///< the quantity whose largest value is `scale`: "|T| + |V|"
  double worst = 0;          ///< largest magnitude of the deviation
  double secular = 0;        ///< mean deviation in the last tenth - mean in the first tenth
  double scale = 1;
};

/// An entry of `conserved` along a run.
struct ConservedDrift {
  std::string text = {};  ///< the expression as typed in the model
  std::string unit = {};  ///< unit of the expression; "" if the unit is 1 or unknown
  double start = 0;
  double drift = 0;  ///< largest deviation from the start
};

/// The largest |f| of the constraints on positions, and the largest |r| of all constraints, with r
/// = df/dt or phi.
struct ConstraintViolation {
  double position = 0;
  double rate = 0;
};

/// The change of an initial coordinate or rate by the assembly.
struct StartCorrection {
  std::string name = {};
  std::string unit = {};
  double change = 0;
};

/// The accuracy of the constraints during a run.
struct ConstraintAccuracy {
  ConstraintViolation largest = {};
  /// Unit of f; "" if the constraints have no common unit. None if no constraint is on positions.
  std::optional<std::string> unit = {};
  std::string rate_unit = {};               ///< common unit of r; "" if the units of r differ
  std::vector<StartCorrection> start = {};  ///< changes of more than 1e-9 max(|x|, 1)
};

/// A column of the table of a run.
struct TrajectoryColumn {
  std::string name = {};              ///< in the model language: "theta", "dot(theta)"
  std::string unit = {};              ///< "" if the model declares none
  std::string panel = {};             ///< title of the panel of the plot that shows it; "": none
  bool is_relative_to_start = false;  ///< true: the plot shows value - initial value - work
  std::string symbol = {};            ///< the name in plots, in Unicode: "θ̇"
};

struct Trajectory {
  std::string model = {};
  std::string title = {};   ///< title of the model; "" if it has none
  std::string method = {};  ///< "verlet of order 8"
  std::string path = {};    ///< the point whose path is drawn; "": none
  double from = 0;
  std::vector<TrajectoryColumn> columns = {};  ///< t; q; v; u with laws; lambda; x, y of `path`; E
  std::vector<std::vector<double>> rows = {};
  std::vector<double> work = {};  ///< work done up to each row, in J; empty if no force does work
  std::vector<double> last = {};  ///< the row at the end of the run
  /// The drift of the energy balance
  ///
  ///     E - E0 - int v.(B u + Q - dD/dv) dt + int dL/dt dt - int v.A^T lambda dt
  ///
  /// relative to the largest |T| + |V|, or to the largest |v.p| + |L| if T and V are not separate.
  /// The last integral is present only for constraints that contain t.
  Drift energy = {};
  bool loses_energy = false;        ///< true: `energy` drifts by > 10 % of the scale of E648
  std::vector<Drift> momenta = {};  ///< drift of p of each cyclic q without force or constraint
  /// Drifts of `conserved` entries of the model, which are constant at u = 0. Empty if the scene
  /// locks variables or expands the equations.
  std::vector<ConservedDrift> conserved = {};
  std::optional<ConstraintAccuracy> constraints = {};  ///< none: the model has no constraints
  std::uint64_t steps = 0;
  double nanoseconds = 0;       ///< mean wall-clock time of a step, in ns
  std::string timed_code = {};  ///< "of the emitted C++", "in the evaluator"
};

/// The errors in options that can be found without a derivation: E620, E621, E647.
[[nodiscard]] Diagnostics check_run_options(const SimulationOptions& options);

/// The outputs that every run needs, in the syntax of --outputs.
[[nodiscard]] std::string outputs_for_run(const Model& model);

/// The output `step` that advances the run; none if the method calls forward dynamics instead.
[[nodiscard]] std::optional<StepSpec> step_for_run(const SimulationOptions& options);

/// Derives the outputs that a run needs and the output `step`, instead of the outputs of the scene.
/// The scene of the result emits C++ in double, with a batch header if `step` is set. If
/// Purpose::shows_motion is set, the scene emits JavaScript instead. The caller sets
/// options.scene.purpose. E622: the method of `step` does not apply to the system.
[[nodiscard]] Products derive_for_run(const PipelineSources& inputs, PipelineOptions options,
                                      const std::optional<StepSpec>& step);

/// Compiles products of derive_for_run() for a run without `step`. Errors: as emit() and compile().
[[nodiscard]] Result<CompiledHeaders> compile_for_run(const Products& products,
                                                      const Limits& limits);

/// The model with its start moved onto the constraints at time t. Variables that `--state` sets do
/// not change. E538: no values of the other variables satisfy the constraints.
[[nodiscard]] Result<CheckedModel> assemble_start(const CheckedModel& checked, const cln::cl_R& t);

/// Runs from the assembled start of the model (assemble_start()), by `compiled` or, if `compiled`
/// is null, in the interpreter. E624: M or the constraints lose rank, the motion slides along a
/// kink, or a number is not finite. Other errors: E201 of `--show` and `--path`, E538, E620, E621,
/// E623, E647. Warning E518: a constant law is beyond the limits of its input. Warning E648, if
/// `tolerance` is set: the energy balance (Trajectory::energy) deviates by more than the tolerance
/// allows. Warning E648, with a fixed step: the energy balance deviates by more than 1 % of
/// max |T| + (max V - min V), or an entry of `conserved` drifts. Cost per step: one `step` or a few
/// calls of the equations of motion, and one call of the energies.
[[nodiscard]] Result<Trajectory> simulate(const CheckedModel& checked, const Program& program,
                                          const CompiledModel* compiled,
                                          const SimulationOptions& options);

/// Coordinates and rates at the end of a reference run, to measure the errors of other runs.
struct ReferenceRun {
  std::vector<double> last = {};        ///< final values of the run
  std::vector<double> rough_last = {};  ///< final values of a run with 10 times the tolerance
  std::vector<double> largest = {};     ///< largest magnitude of each value during the run
  double tolerance = 0;                 ///< of the error of a step, absolute and relative
};

/// Runs from the assembled start of the model by Fehlberg's method of order 8, in the interpreter,
/// in long double. The tolerance is 1e-18, or 1e-15 if the inputs have laws or if the run needs too
/// many steps of 1e-18. Laws of inputs are evaluated at every stage of the method. Errors: E538,
/// E623, E624.
[[nodiscard]] Result<ReferenceRun> run_reference(const CheckedModel& checked,
                                                 const Program& program, double time);

/// The last state, the drifts and the cost of a step, for people.
[[nodiscard]] std::string to_text(const Trajectory& trajectory);
/// The rows as CSV. Each number has the fewest digits that read back the same double.
[[nodiscard]] std::string to_csv(const Trajectory& trajectory);
[[nodiscard]] std::string to_json(const Trajectory& trajectory);
/// A plot over time with panels for coordinates, inputs with laws, E - E0 - work and the columns in
/// SimulationOptions::panel_columns. If `trajectory.path` is set: a plot of y over x of this point.
[[nodiscard]] std::string to_svg(const Trajectory& trajectory);

}  // namespace elgen
