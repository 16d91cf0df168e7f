// Trajectory: a run of a system in time, by its functions in the evaluator, or as they were emitted
// and compiled.
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

/// Times in s. Of step and tolerance at most one is given: a method of fixed step takes a step, the
/// others choose theirs to an error of `tolerance` absolute and relative.
struct SimulationOptions {
  std::string method = "dopri5";            ///< of run/steps/methods.cpp
  std::optional<std::uint32_t> order = {};  ///< none: that of the method without composition
  double from = 0;
  double time = 0;                       ///< how long
  std::optional<double> step = {};       ///< the longest one; a whole number fill every interval
  std::optional<double> tolerance = {};  ///< 1e-9 where neither is given
  std::optional<double> every = {};      ///< between rows; none: no rows
  std::optional<double> hold = {};       ///< inputs keep their values so long; none: continuous
  bool project = true;                   ///< after each step, back onto the constraints
  bool through_singular = false;         ///< goes on where M or A loses rank, by a fixed step
  std::vector<std::string> show = {};    ///< columns that get panels of the plot besides
  std::string path = {};                 ///< the point whose path is drawn; "": none is
  /// Is told the time that the run has reached, now and then.
  std::function<void(double)> watch = {};
};

/// How far what should stay has gone from where it was, relative to `scale`.
struct Drift {
  std::string name = {};
  std::string measure = {};  ///< the quantity whose largest value is the scale: "|T| + |V|"
  double worst = 0;          ///< the largest magnitude
  double secular = 0;        ///< its mean over the last tenth of the run less that over the first
  double scale = 1;
};

/// An entry of `conserved` along a run.
struct ConservedDrift {
  std::string text = {};  ///< as in the model
  std::string unit = {};  ///< "" where it is 1 or not known
  double start = 0;
  double drift = 0;  ///< the largest deviation from the start, in the unit
};

/// The largest |f| of the constraints on positions, and |r| of all, r = df/dt or phi.
struct ConstraintOffset {
  double position = 0;
  double rate = 0;
};

/// The change of a coordinate or rate of the start that meets the constraints.
struct StartMove {
  std::string name = {};
  std::string unit = {};
  double by = 0;
};

/// How a run keeps to the constraints of its model.
struct KeptConstraints {
  ConstraintOffset largest = {};
  std::optional<std::string> unit = {};  ///< of f, "" where not all have the same; none: no f
  std::string rate_unit = {};            ///< of r, alike
  std::vector<StartMove> start = {};     ///< what was moved by more than 1e-9 of it, or of 1
};

/// A number of every row.
struct TrajectoryColumn {
  std::string name = {};    ///< as in models: "theta", "dot(theta)"
  std::string unit = {};    ///< "" where none is given
  std::string panel = {};   ///< of the plot that shows it; "" where none does
  bool from_start = false;  ///< the plot shows how far it went from its first value
};

struct Trajectory {
  std::string model = {};
  std::string title = {};   ///< of the model; "" where it has none
  std::string method = {};  ///< "verlet of order 8"
  std::string path = {};    ///< the point whose path is drawn; "": none is
  double from = 0;
  std::vector<TrajectoryColumn> columns = {};  ///< t, q, v, u with laws, lambda, x, y of `path`, E
  std::vector<std::vector<double>> rows = {};
  std::vector<double> work = {};  ///< until each row; empty where none is done
  std::vector<double> last = {};  ///< the row of the end
  /// E - E0, relative to the largest |T| + |V| (of an L given whole |v.p| + |L|); where forces or
  /// time act, less the work they did: E - E0 - int v.(B u + Q - dD/dv) dt + int dL/dt dt, and of
  /// constraints that move by themselves - int v.A^T lambda dt.
  Drift energy = {};
  bool loses_energy = false;        ///< in steps of one length, more than 10 % of the scale of E648
  std::vector<Drift> momenta = {};  ///< of what is cyclic, and free of forces and constraints
  /// Drifts of the model's `conserved`, which holds at u = 0; none where a scene locks or expands.
  std::vector<ConservedDrift> conserved = {};
  std::optional<KeptConstraints> constraints = {};  ///< of a model that has some
  std::uint64_t steps = 0;
  double nanoseconds = 0;       ///< per step
  std::string timed_code = {};  ///< "of the emitted C++", "in the evaluator"
};

/// The errors of a run that are found before anything is derived: E620, E621, E647.
[[nodiscard]] Diagnostics refuse_run(const SimulationOptions& options);

/// The outputs that every run calls of a model, as --outputs has them.
[[nodiscard]] std::string outputs_of_run(const Model& model);

/// The `step` whose program a run goes by, beside these outputs; none where it calls accelerations.
[[nodiscard]] std::optional<StepSpec> step_of_run(const SimulationOptions& options);

/// The model of a run with the outputs that it calls and the `step` that it goes by, whatever the
/// scene asks for; the scene that is left emits C++ for double alone, of a `step` in packs too, or
/// JavaScript if the purpose is to show the motion. The caller says which purpose the run has.
/// E622 where the method is not for the system.
[[nodiscard]] Products derived_for_run(const Inputs& inputs, PipelineOptions options,
                                       const std::optional<StepSpec>& step);

/// Products of derived_for_run compiled, for a run that is not by a program of `step`. Errors as of
/// `compile`.
[[nodiscard]] Result<CompiledHeaders> compiled_for_run(const Products& products,
                                                       const Limits& limits);

/// The model with a start that meets its constraints at a time, near its own one. What `--state`
/// names stays: E538 where the rest cannot be solved for.
[[nodiscard]] Result<CheckedModel> assembled_model(const CheckedModel& checked, const cln::cl_R& t);

/// Runs from the model's start, assembled, by what was compiled; where that is null, in the
/// evaluator. Ends where M or the constraints lose rank, or a motion slides along a kink, and warns
/// if energy is lost: by more than the tolerance allows, or in steps of one length by 1 % of max
/// |T| + (max V - min V). E201 of `show` and `path`, E518, E538, E620, E621, E623, E624, E647,
/// E648. Cost: one step of the program, or a few calls of the equations of motion, per step, and of
/// the energies for each.
[[nodiscard]] Result<Trajectory> simulate(const CheckedModel& checked, const Program& program,
                                          const CompiledModel* compiled,
                                          const SimulationOptions& options);

/// Coordinates and rates at the end of a run, from which errors of others are measured.
struct ReferenceRun {
  std::vector<double> last = {};     ///< to 1e-15, in long double
  std::vector<double> rougher = {};  ///< to 1e-12, in double
  std::vector<double> largest = {};  ///< of each the largest magnitude on the way
};

/// By Fehlberg's method of order 8 from the model's start on, assembled, in the evaluator; laws of
/// inputs at every stage. E538, E623, E624.
[[nodiscard]] Result<ReferenceRun> reference_run(const CheckedModel& checked,
                                                 const Program& program, double time);

/// The last state, the drifts and the cost of a step, for people.
[[nodiscard]] std::string to_text(const Trajectory& trajectory);
/// The rows, each number in the fewest digits that read back as it.
[[nodiscard]] std::string to_csv(const Trajectory& trajectory);
[[nodiscard]] std::string to_json(const Trajectory& trajectory);
/// Coordinates, inputs and E - E0 - work over time, each in a panel of its own; rates are their
/// slopes.
[[nodiscard]] std::string to_svg(const Trajectory& trajectory);

}  // namespace elgen
