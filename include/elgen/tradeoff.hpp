// TradeoffTable: costs and errors of the designs of one output, or of runs.
//
// A design is a scene. plan() lists designs, and the pipeline and the compiler process each.
// find_costs() and find_errors() measure the results, and rank_rows() ranks them. check_max_error()
// checks `max_error` of a scene.
//
// Costs and errors have noise. Two costs are equal if their ratio is at most equality_factor or
// their quartiles overlap. The error of a design is measured in three samples of states, with three
// seeds; its noise is the interval from the least to the worst of the three. The error of a run is
// known up to the distance of two reference runs. An error is smaller than another if
// equality_factor times its worst is less than the least of the other. A row is on the Pareto front
// if its error is smaller than the error of every cheaper row of the front.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "elgen/certificate.hpp"
#include "elgen/program.hpp"
#include "elgen/scene.hpp"
#include "elgen/simulate.hpp"
#include "elgen/syntax.hpp"
#include "elgen/toolchain.hpp"

namespace elgen {

/// The model and scene from which designs are made.
struct DesignBase {
  const CheckedModel& checked;        ///< the output is its first one
  const FileSyntax* scene = nullptr;  ///< null: no scene file
  /// The `max_error` of a written scene, valid in the ranges of `scene` and in `ranges`
  /// ("theta=-1..1").
  std::optional<double> max_error = {};
  std::vector<SourcePointer> ranges = {};
};

/// The value of `trigonometry` for functions of one state that call sin and cos of the library.
inline constexpr std::string_view library_sines = "library";

/// One value per dimension; empty: as in the scene.
struct Design {
  ScalarKind scalar = ScalarKind::double_precision;  ///< or float
  bool in_packs = false;
  /// max_error of the polynomials; "": the accuracy of the scalar; or library_sines.
  std::string trigonometry = {};
  bool is_fixed = false;                  ///< all parameters are numbers
  InnerScalar inner = InnerScalar::same;  ///< only for one state in double
  std::string order = {};                 ///< of an expansion, or "exact": no approximation
  std::optional<StepSpec> step = {};      ///< replaces the output
  std::string doc = {};                   ///< of the scene
  friend bool operator==(const Design&, const Design&) = default;
};

/// The design without any approximation of the model.
inline const Design exact_design{.order = "exact"};

/// A dimension of designs with its possible values.
struct DesignDimension {
  std::string name = {};  ///< "scalar"
  std::string doc = {};   ///< of the option that pins it
  std::vector<std::string> values = {};
};

[[nodiscard]] std::vector<DesignDimension> design_dimensions();

/// Only designs with this value are tried. Both words are from design_dimensions().
struct PinnedDimension {
  std::string name = {};
  std::string value = {};
};

struct DesignChoices {
  std::vector<std::string> more = {};  ///< dimensions to try in addition to the default ones
  std::vector<PinnedDimension> pinned = {};
};

/// E644 at a key of the scene that contradicts a pinned dimension.
[[nodiscard]] Diagnostics scene_conflicts(const DesignBase& base,
                                          const std::vector<PinnedDimension>& pinned);

struct PlannedDesign {
  std::vector<std::string> values = {};  ///< by dimension
  Design design = {};
};

struct TradeoffPlan {
  /// Dimensions with at least two values, and pinned ones.
  std::vector<std::string> dimensions = {};
  std::vector<PlannedDesign> designs = {};
};

/// The possible combinations of scalar, batch, sines and parameters for the first function of
/// `program`, restricted by `choices`. E631: an unknown dimension in `choices`. E645: no design
/// remains.
[[nodiscard]] Result<TradeoffPlan> plan(const CheckedModel& checked, const Program& program,
                                        const DesignChoices& choices);

/// The design as a scene file for the model at `model_path`.
[[nodiscard]] std::string scene_text(const DesignBase& base, const Design& design,
                                     const std::string& model_path);

/// The design without scalar, packs and sines, on which the derivation does not depend.
[[nodiscard]] Design derivation_key(const Design& design);

/// high + low: a number to 32 digits.
struct ExactNumber {
  double high = 0;
  double low = 0;
};

/// The states of a measurement, with the exact value of every entry at each state.
struct TradeoffStates {
  /// For float they are rounded, which counts as error.
  std::vector<Arguments<double>> states = {};
  std::vector<std::size_t> field_sizes = {};
  std::vector<std::vector<ExactNumber>> exact = {};  ///< by state and entry
  Arguments<double> low = {};   ///< lower ends of the ranges from which states are drawn
  Arguments<double> high = {};  ///< upper ends
  std::uint64_t seed = 1;       ///< of the search for worse states
};

/// The number of states and their seed.
struct TradeoffSampling {
  std::size_t count = 1000;
  std::uint64_t seed = 1;
};

/// States inside the ranges of the model, narrowed by the scene, and the values of the program's
/// first function there: in 60 digits with exact parameters. E521: it has no value. Cost: one
/// operation of Real per instruction and state.
[[nodiscard]] Result<TradeoffStates> tradeoff_states(const CheckedModel& exact,
                                                     const Program& program,
                                                     const TradeoffSampling& sampling);

/// For each state the largest |x - x*| in a field / the largest |x*| of that field at any state.
/// Infinite if x is NaN. `results` are laid out as in DesignValues.
[[nodiscard]] std::vector<double> state_errors(const std::vector<double>& results,
                                               const TradeoffStates& states);

/// The values of a design: entry k of state i at [k * states.size() + i]. The list of states is
/// never empty.
using DesignValues = std::function<std::vector<double>(const std::vector<Arguments<double>>&)>;

struct FoundErrors {
  double worst = 0;              ///< over the states and the search
  double median = 0;             ///< over the states
  Arguments<double> where = {};  ///< the worst state
};

/// Errors at the states and of a pattern search inside the ranges. The search starts at the worst
/// states, one start per 100 states, and visits about 20 other states per state. Each number that
/// the function reads is moved up and down by a step, and all improvements are combined; the step
/// doubles after a success and is halved otherwise. During the search the program in long double
/// gives the exact values; the final states are confirmed in 60 digits. Errors are relative to the
/// largest |x*| of the field at the states or, if that is larger, at the visited state. The result
/// does not depend on time.
[[nodiscard]] FoundErrors find_errors(const CheckedModel& exact, const Program& program,
                                      const TradeoffStates& states, const DesignValues& design);

/// A table shows the worst error found, times this factor.
inline constexpr double search_margin = 1.5;

/// Costs or errors within this factor are equal: a table shows two digits of an error, and times of
/// the same code differ by this much from run to run.
inline constexpr double equality_factor = 1.1;

/// Checks `[numeric] max_error` of the scene for `compiled` and options.as_users: one row for each
/// output, header and scalar, which fails if a larger error is found. `exact` and `program` belong
/// to the scene without its expansion. Empty without `max_error`.
[[nodiscard]] std::vector<CertificateRow> check_max_error(const CheckedModel& exact,
                                                          const Program& program,
                                                          const CompiledHeaders& compiled,
                                                          const VerifyOptions& options);

/// Median and quartiles.
struct Quartiles {
  double median = 0;
  double low = 0;
  double high = 0;
};

/// The error of a design or a run in a table, with its noise.
struct DesignErrors {
  double worst = 0;
  double median = 0;
  double least = 0;  ///< lower end of the noise of `worst`
};

/// worst and least: search_margin times the largest and the smallest worst error of a sample.
/// median: the median of the medians. `samples` is not empty.
[[nodiscard]] DesignErrors errors_of(std::vector<FoundErrors> samples);

/// Work in equal parts. `cost` receives the cost of one part in ns of processor time.
struct TimedWork {
  std::function<void()> run = {};
  std::size_t parts = 1;
  Quartiles* cost = nullptr;
};

/// Measures the costs in turns, so that all works see the same state of the machine. The number of
/// rounds follows from `seconds`, between 9 and 1001.
void find_costs(const std::vector<TimedWork>& works, double seconds = 1.5);

/// A run by an emitted step of fixed length.
struct PlannedRun {
  std::vector<std::string> values = {};  ///< method, order, step, batch
  Design design = {};
  std::size_t steps = 0;
};

/// Runs by all methods and orders, one state or packs. Step lengths are integer fractions of `time`
/// near `lengths`, or a few defaults if it is empty.
[[nodiscard]] std::vector<PlannedRun> plan_runs(double time,
                                                const std::vector<double>& lengths = {});

/// q and v at the end of a run from the start of the model. Inputs are constant during each step,
/// with their value at its start. `program` has the equations for simulate().
[[nodiscard]] std::vector<double> end_of_run(const CheckedModel& checked, const Program& program,
                                             const StepLoops& loops, const PlannedRun& run,
                                             double time);

/// Some steps of a length from the start of the model: one state, or 256 states in packs. Each step
/// of each state is a part of the work.
[[nodiscard]] TimedWork timed_steps(const CheckedModel& checked, const Program& program,
                                    const StepLoops& loops, bool in_packs, double length);

/// Errors of coordinates and rates at the end: distance from the reference / largest magnitude of
/// that number in the reference; `worst` and `median` over the numbers. Angles that wrap are
/// compared modulo 2 pi.
[[nodiscard]] DesignErrors errors_of(const std::vector<double>& last, const ReferenceRun& reference,
                                     const Model& model);

struct TradeoffRow {
  std::vector<std::string> values = {};  ///< by dimension
  Design design = {};
  Quartiles cost = {};
  Quartiles call_cost = {};  ///< of a call with one state; with packs it fills one lane
  DesignErrors error = {};
  std::string failure = {};  ///< why cost and error are missing; "": they are present
  /// The error is the error of the reference run, which cannot resolve a smaller one.
  bool is_below_reference = false;
  /// Counted from 1. A rank is the cheapest row without a rank and all rows with equal cost. 0:
  /// failed.
  std::size_t rank = 0;
  /// The worst error is at most 1. Beyond noise, it is smaller than the error of every earlier row
  /// that is on the front or below the reference.
  bool is_on_pareto_front = false;
};

struct TradeoffTable {
  std::string model = {};
  std::string subject = {};    ///< "inverse_dynamics"
  std::string cost = {};       ///< its unit: "ns per state"
  std::string call_cost = {};  ///< "ns per call"; "" if it equals `cost` or is missing
  std::string error = {};      ///< the meaning of the error
  std::vector<std::string> dimensions = {};
  /// By rank, then by worst error, then in planned order; failed rows last.
  std::vector<TradeoffRow> rows = {};
  std::vector<std::string> sentences = {};  ///< printed below the table
  Machine machine = {};
  std::optional<double> max_error = {};  ///< the bound for picked_row()
};

/// Ranks and sorts the planned rows, and marks the Pareto front.
[[nodiscard]] TradeoffTable rank_rows(TradeoffTable table);

/// "float, packs, full, fixed"
[[nodiscard]] std::string name_of(const TradeoffRow& row);

/// The first row with a worst error of at most max_error: the most accurate row of the cheapest
/// rank that has one. Null if no row qualifies.
[[nodiscard]] const TradeoffRow* cheapest_within(const TradeoffTable& table, double max_error);
/// The row for table.max_error; null if no row qualifies or it is not set.
[[nodiscard]] const TradeoffRow* picked_row(const TradeoffTable& table);
/// The first row with the smallest worst error; null if all failed.
[[nodiscard]] const TradeoffRow* most_accurate(const TradeoffTable& table);

/// For readers.
[[nodiscard]] std::string to_text(const TradeoffTable& table);
[[nodiscard]] std::string to_csv(const TradeoffTable& table);
[[nodiscard]] std::string to_json(const TradeoffTable& table);
/// Worst errors over costs on logarithmic axes, with the Pareto front as a staircase.
[[nodiscard]] std::string to_svg(const TradeoffTable& table);

}  // namespace elgen
