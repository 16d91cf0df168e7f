// Trajectory: a run of a system in time, by its functions in the interpreter or by compiled emitted
// code.
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

/// Times are in s. At most one of step and tolerance is set. Methods with a fixed step use `step`;
/// the other methods control the error, absolute and relative, by `tolerance`.
struct SimulationOptions {
  std::string method = "dopri5";            ///< a method of run/steps/methods.cpp
  std::optional<std::uint32_t> order = {};  ///< none: the order of the method without composition
  double from = 0;
  double time = 0;                  ///< duration
  std::optional<double> step = {};  ///< upper bound; each interval is an integer number of steps
  std::optional<double> tolerance = {};  ///< 1e-9 if neither is set
  std::optional<double> every = {};      ///< time between rows; none: no rows
  std::optional<double> hold = {};       ///< inputs are constant for this time; none: continuous
  bool project = true;                   ///< projects onto the constraints after each step
  bool through_singular = false;         ///< continues with a fixed step if M or A loses rank
  std::vector<std::string> show = {};    ///< columns with their own panels in the plot
  std::string path = {};                 ///< the point whose path is drawn; "": none
  /// Is called from time to time with the time that the run has reached.
  std::function<void(double)> on_progress = {};
};

/// The deviation of a conserved quantity from its start, relative to `scale`.
struct Drift {
  std::string name = {};
  std::string measure = {};  ///< the quantity whose largest value is `scale`: "|T| + |V|"
  double worst = 0;          ///< largest magnitude
  double secular = 0;        ///< mean over the last tenth of the run - mean over the first tenth
  double scale = 1;
};

/// An entry of `conserved` along a run.
struct ConservedDrift {
  std::string text = {};  ///< as in the model
  std::string unit = {};  ///< "" if it is 1 or unknown
  double start = 0;
  double drift = 0;  ///< largest deviation from the start
};

/// The largest |f| of the constraints on positions, and the largest |r| of all, r = df/dt or phi.
struct ConstraintOffset {
  double position = 0;
  double rate = 0;
};

/// The change of a start coordinate or rate by the assembly.
struct StartCorrection {
  std::string name = {};
  std::string unit = {};
  double by = 0;
};

/// The accuracy of the constraints during a run.
struct ConstraintAccuracy {
  ConstraintOffset largest = {};
  /// Of f, "" if the units differ; none: no constraint on positions.
  std::optional<std::string> unit = {};
  std::string rate_unit = {};               ///< of r, "" if the units differ
  std::vector<StartCorrection> start = {};  ///< changes of more than 1e-9 max(|x|, 1)
};

/// A column of the table of a run.
struct TrajectoryColumn {
  std::string name = {};    ///< in the model language: "theta", "dot(theta)"
  std::string unit = {};    ///< "" if the model declares none
  std::string panel = {};   ///< of the plot that shows it; "": none
  bool from_start = false;  ///< the plot shows the difference from the first value
};

struct Trajectory {
  std::string model = {};
  std::string title = {};   ///< of the model; "" if it has none
  std::string method = {};  ///< "verlet of order 8"
  std::string path = {};    ///< the point whose path is drawn; "": none
  double from = 0;
  std::vector<TrajectoryColumn> columns = {};  ///< t, q, v, u with laws, lambda, x, y of `path`, E
  std::vector<std::vector<double>> rows = {};
  std::vector<double> work = {};  ///< total work at each row; empty if no force does work
  std::vector<double> last = {};  ///< the row at the end
  /// E - E0 relative to the largest |T| + |V| (|v.p| + |L| if L is declared). If forces or time
  /// act, the deviation is E - E0 - int v.(B u + Q - dD/dv) dt + int dL/dt dt. Constraints that
  /// contain t add - int v.A^T lambda dt.
  Drift energy = {};
  bool loses_energy = false;        ///< with a fixed step: more than 10 % of the scale of E648
  std::vector<Drift> momenta = {};  ///< of cyclic coordinates without forces and constraints
  /// Drifts of `conserved` entries of the model, which hold at u = 0. Empty if a scene locks or
  /// expands.
  std::vector<ConservedDrift> conserved = {};
  std::optional<ConstraintAccuracy> constraints = {};  ///< none: the model has no constraints
  std::uint64_t steps = 0;
  double nanoseconds = 0;       ///< per step
  std::string timed_code = {};  ///< "of the emitted C++", "in the evaluator"
};

/// The errors in options that need no derivation: E620, E621, E647.
[[nodiscard]] Diagnostics check_run_options(const SimulationOptions& options);

/// The outputs that every run needs, in the syntax of --outputs.
[[nodiscard]] std::string outputs_of_run(const Model& model);

/// The `step` whose program advances the run; none if the method calls accelerations instead.
[[nodiscard]] std::optional<StepSpec> step_of_run(const SimulationOptions& options);

/// Derives the outputs of a run and its `step`, independently of the outputs of the scene. The
/// resulting scene emits C++ in double, with a batch header for a `step`, or JavaScript if the
/// purpose shows motion. The caller sets options.scene.purpose. E622: the method does not apply to
/// the system.
[[nodiscard]] Products derive_for_run(const Inputs& inputs, PipelineOptions options,
                                      const std::optional<StepSpec>& step);

/// Compiles products of derive_for_run() for a run without a program of `step`. Errors as of
/// compile().
[[nodiscard]] Result<CompiledHeaders> compile_for_run(const Products& products,
                                                      const Limits& limits);

/// The model with a start near its own one that satisfies the constraints at time t. Variables that
/// `--state` sets do not change. E538: the others have no solution.
[[nodiscard]] Result<CheckedModel> assemble_model(const CheckedModel& checked, const cln::cl_R& t);

/// Runs from the assembled start of the model, by `compiled` or, if it is null, in the interpreter.
/// The run ends if M or the constraints lose rank, or if the motion slides along a kink. It warns
/// of lost energy: more than the tolerance allows, or with a fixed step more than 1 % of max |T| +
/// (max V - min V). Errors: E201 of `show` and `path`, E518, E538, E620, E621, E623, E624, E647,
/// E648. Cost per step: one step program or a few calls of the equations of motion, and one call of
/// the energies.
[[nodiscard]] Result<Trajectory> simulate(const CheckedModel& checked, const Program& program,
                                          const CompiledModel* compiled,
                                          const SimulationOptions& options);

/// Coordinates and rates at the end of a reference run, to measure the errors of other runs.
struct ReferenceRun {
  std::vector<double> last = {};        ///< in long double, tolerance 1e-15
  std::vector<double> rough_last = {};  ///< in double, tolerance 1e-12
  std::vector<double> largest = {};     ///< largest magnitude of each number during the run
};

/// Runs from the assembled start of the model by Fehlberg's method of order 8, in the interpreter.
/// Laws of inputs are evaluated at every stage. E538, E623, E624.
[[nodiscard]] Result<ReferenceRun> reference_run(const CheckedModel& checked,
                                                 const Program& program, double time);

/// The last state, the drifts and the cost of a step, for people.
[[nodiscard]] std::string to_text(const Trajectory& trajectory);
/// The rows; each number has the fewest digits that identify it.
[[nodiscard]] std::string to_csv(const Trajectory& trajectory);
[[nodiscard]] std::string to_json(const Trajectory& trajectory);
/// One panel each for coordinates, inputs and E - E0 - work over time. Rates have no panel: they
/// are slopes of the coordinates.
[[nodiscard]] std::string to_svg(const Trajectory& trajectory);

}  // namespace elgen
