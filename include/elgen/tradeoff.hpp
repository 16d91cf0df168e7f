// TradeoffTable: costs and errors of the designs of one output, or of runs.
//
// A design is a scene. plan_designs() lists designs; the pipeline and the compiler then run for
// each design. measure_costs() and find_errors() measure the results, and rank_rows() ranks them.
// check_max_error() checks `max_error` of a scene.
//
// Costs and errors have noise. A cost equals a smaller cost if their ratio is at most
// equality_factor, or within the noise of the smaller cost. The error of a design is measured in
// three samples of states, with three seeds; its noise is the interval [least, worst] of the three
// errors. The error of a run is known up to four times the distance between two reference runs.
// Error x is smaller than error y if equality_factor * x.worst < y.least. A row is on the Pareto
// front if its error is smaller than the error of every cheaper row of the front.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "elgen/certificate.hpp"
#include "elgen/program.hpp"
#include "elgen/scene.hpp"
#include "elgen/simulate.hpp"
#include "elgen/syntax.hpp"
#include "elgen/toolchain.hpp"

namespace elgen {

/// The model and scene from which designs are made.
struct DesignSource {
  const CheckedModel& checked;        ///< checked.scene.outputs[0] is the output of the designs
  const FileSyntax* scene = nullptr;  ///< null: no scene file
  /// The `max_error` that scene_text() writes. It applies in the ranges of `scene` and in `ranges`
  /// ("theta=-1..1").
  std::optional<double> max_error = {};
  std::vector<SourcePointer> ranges = {};
};

/// The value of `trigonometry` for functions of one state that call sin and cos of the library.
inline constexpr std::string_view library_sines = "library";

/// One value per dimension of the trade-off. An empty member keeps the value of the scene.
struct Design {
  ScalarKind scalar = ScalarKind::double_precision;  ///< double or float
  bool in_packs = false;
  /// The max_error of the sine polynomials, or library_sines; "": the accuracy of the scalar.
  std::string trigonometry = {};
  bool is_fixed = false;  ///< true: all parameters are numbers in the code
  bool is_typed = false;  ///< true: the recursive form of the text as typed; no sum is rewritten
  /// The scalar inside the functions. A wider scalar has neither packs nor `scalar` float; float is
  /// only for `step`.
  InnerScalar inner = InnerScalar::same;
  std::string order = {};             ///< order of an expansion, or "exact": no expansion
  std::optional<StepSpec> step = {};  ///< step emitted instead of the output; none: the output
  std::string doc = {};               ///< value of `doc` in the scene; "": no `doc`
  friend bool operator==(const Design&, const Design&) = default;
};

/// The design without any approximation of the model.
inline const Design exact_design{.order = "exact"};

/// A dimension of designs with its possible values.
struct DesignDimension {
  std::string name = {};  ///< "scalar"
  std::string doc = {};   ///< description of the option that pins the dimension
  std::vector<std::string> values = {};
};

[[nodiscard]] std::vector<DesignDimension> design_dimensions();

/// A restriction to designs with this value of a dimension. Both words are from
/// design_dimensions().
struct PinnedDimension {
  std::string name = {};
  std::string value = {};
};

struct DesignChoices {
  std::vector<std::string> more = {};  ///< dimensions to vary in addition to the default dimensions
  std::vector<PinnedDimension> pinned = {};
};

/// E644 for each key of the scene that contradicts a pinned dimension.
[[nodiscard]] Diagnostics scene_conflicts(const DesignSource& base,
                                          const std::vector<PinnedDimension>& pinned);

struct PlannedDesign {
  std::vector<std::string> values = {};  ///< value of each of TradeoffPlan::dimensions, in order
  Design design = {};
};

struct TradeoffPlan {
  /// The dimensions with at least two values, and the pinned dimensions.
  std::vector<std::string> dimensions = {};
  std::vector<PlannedDesign> designs = {};
};

/// All possible combinations of scalar, batch and parameters, and of the dimensions in
/// choices.more, for the first function of `program`. choices.pinned restricts the combinations. If
/// neither contains `form`, only the first combination is also planned as typed.
/// E631: choices.more contains an unknown dimension. E645: no combination remains.
[[nodiscard]] Result<TradeoffPlan> plan_designs(const CheckedModel& checked, const Program& program,
                                                const DesignChoices& choices);

/// The design as a scene file for the model at `model_path`.
[[nodiscard]] std::string scene_text(const DesignSource& base, const Design& design,
                                     const std::string& model_path);

/// `design` with all members except `is_fixed`, `is_typed` and `order` set to their defaults.
/// Designs with equal keys have the same derivation.
[[nodiscard]] Design derivation_key(const Design& design);

/// The number high + low, to 32 digits.
struct TwoDoubleNumber {
  double high = 0;
  double low = 0;
};

/// The states of a measurement, with the exact value of every entry at each state.
struct TradeoffStates {
  /// A design in float rounds the states; this rounding is part of the error of the design.
  std::vector<Arguments<double>> states = {};
  std::vector<std::size_t> field_sizes = {};
  std::vector<std::vector<TwoDoubleNumber>> exact = {};  ///< exact[i][k]: entry k at states[i]
  Arguments<double> low = {};   ///< lower ends of the ranges from which states are drawn
  Arguments<double> high = {};  ///< upper ends of the ranges from which states are drawn
  std::uint64_t seed = 1;       ///< seed of the search for worse states
};

/// The states in a log of a run: rows[i][k] is the value of leaves[k], a kind and a number.
struct StateLog {
  std::vector<std::pair<Opcode, std::uint32_t>> leaves = {};
  std::vector<std::vector<double>> rows = {};
};

/// Reads a CSV table: a line of names, then lines of numbers. The names are leaves of a state as
/// models write them, E, and multipliers; all coordinates and rates are required. E650: a wrong or
/// missing name, a wrong number or count of numbers, or no row.
[[nodiscard]] Result<StateLog> read_state_log(const SourceText& source, const Model& model);

/// The number of states and their seed. The samples with the seeds 1 to `samples` together have the
/// rows of `log`, spread evenly; without rows, all states are drawn.
struct TradeoffSampling {
  std::size_t count = 1000;
  std::uint64_t seed = 1;
  StateLog log = {};
  std::size_t samples = 1;
};

/// The number of successive states with the same values of Numerics::varied_parameters: enough for
/// the magnitude of a field, and few enough for many draws.
inline constexpr std::size_t states_of_draw = 16;

/// Draws states inside the ranges of the model; Numerics::ranges replace ranges of the same name.
/// Leaves in the log have the values of its rows, and no range.
/// Draws Numerics::varied_parameters: a quarter of the values at each end of the range, the others
/// between the ends, log-uniform if the range is positive, else uniform. Other parameters are
/// exact. Evaluates the first function of `program` at these states, with 60 digits. E521: the
/// function has no value at most states. Cost: one operation of Real per instruction and state.
[[nodiscard]] Result<TradeoffStates> sample_tradeoff_states(const CheckedModel& exact,
                                                            const Program& program,
                                                            const TradeoffSampling& sampling);

/// For each state the error: the largest |x - x*| of an entry x with exact value x*, divided by the
/// largest |x*| of the entries of the same field at all states with the same parameters. Infinite
/// if an x is NaN. `results` has entry k at state i in results[k * states.states.size() + i].
[[nodiscard]] std::vector<double> state_errors(const std::vector<double>& results,
                                               const TradeoffStates& states);

/// A function that computes the entries of a design at states: entry k of state i at
/// [k * states.size() + i]. It is never called with an empty list of states.
using DesignEvaluator = std::function<std::vector<double>(const std::vector<Arguments<double>>&)>;

struct FoundErrors {
  double worst = 0;                    ///< largest error at the states and in the search
  double median = 0;                   ///< median of the errors at the states
  Arguments<double> worst_state = {};  ///< the state with the error `worst`
};

/// The errors at `states`, and in a pattern search for worse states inside the ranges. The search
/// starts at the worst states, one per 100 states, and evaluates about 20 times as many states as
/// `states` has. Each argument of the function, except parameters, is moved up and down by a step,
/// and all improvements are combined; the step doubles after a success and is halved otherwise. In
/// the search, the program in long double gives the exact values x*; the errors at the final states
/// are computed in 60 digits. Errors are relative to the largest |x*| of the field at `states` with
/// the same parameters and at the evaluated state. The result is deterministic.
[[nodiscard]] FoundErrors find_errors(const CheckedModel& exact, const Program& program,
                                      const TradeoffStates& states, const DesignEvaluator& design);

/// The factor by which a table multiplies the worst error found, because worse states may exist.
inline constexpr double search_margin = 1.5;

/// Costs or errors within this factor count as equal: a table shows two digits of an error, and
/// times of the same code differ by about this factor from run to run.
inline constexpr double equality_factor = 1.1;

/// Checks `[numeric] max_error` of the scene for compiled code. There is one row for each output,
/// header and scalar; a row fails if a larger error is found. `exact` and `program` belong to the
/// scene without its expansion. Empty if the scene has no `max_error`.
[[nodiscard]] std::vector<CertificateRow> check_max_error(const CheckedModel& exact,
                                                          const Program& program,
                                                          const CompiledHeaders& compiled,
                                                          const VerifyOptions& options);

/// The cost of a piece of work. Other work on the machine only lengthens a timing, so the least of
/// many timings is closest to the cost.
struct MeasuredCost {
  double least = 0;  ///< the least time of all rounds
  /// high / low - 1, if low <= high are the least times of the even and of the odd rounds.
  double noise = 0;
};

/// The error of a design or a run in a table, with its noise.
struct DesignErrors {
  double worst = 0;
  double median = 0;
  double least = 0;  ///< lower end of the noise interval, whose upper end is `worst`
};

/// The errors of a design from several samples. worst, least: search_margin times the largest and
/// the smallest FoundErrors::worst. median: the median of the medians. `samples` must not be empty.
[[nodiscard]] DesignErrors combine_errors(std::vector<FoundErrors> samples);

/// A piece of work that consists of equal parts. measure_costs() sets `cost` to the cost of one
/// part, in ns of wall-clock time.
struct TimedWork {
  std::function<void()> run = {};
  std::size_t parts = 1;
  MeasuredCost* cost = nullptr;
};

/// Measures the costs of all `works` in rounds that time each work once, so that changes of the
/// machine affect all works. Runs rounds for about `seconds` s: at least 10 and at most 1000
/// rounds.
void measure_costs(const std::vector<TimedWork>& works, double seconds = 1.5);

/// A run of `steps` equal steps, each a call of the emitted output `step`.
struct PlannedRun {
  std::vector<std::string> values = {};  ///< method, order, step length, batch, inner, as texts
  Design design = {};
  std::size_t steps = 0;
};

/// The runs to measure: all methods and orders, each for one state and in packs; explicit methods
/// also with accelerations in float. A step length is
/// `time` / n, n an integer: n is `time` / length, rounded, for each length in `lengths`. If
/// `lengths` is empty, n has a few default values.
[[nodiscard]] std::vector<PlannedRun> plan_runs(double time,
                                                const std::vector<double>& lengths = {});

/// q and v at the end of a run from the start of the model. During each step, inputs have their
/// value at the start of the step. `program` has the equations for simulate().
[[nodiscard]] std::vector<double> run_to_end(const CheckedModel& checked, const Program& program,
                                             const StepLoops& loops, const PlannedRun& run,
                                             double time);

/// A piece of work for measure_costs(): some steps of `length` from the start of the model, for one
/// state or, if `in_packs` is set, for 256 states. One part of the work is one step of one state.
[[nodiscard]] TimedWork make_step_work(const CheckedModel& checked, const Program& program,
                                       const StepLoops& loops, bool in_packs, double length);

/// The worst and the median error of the coordinates and rates at the end of a run. The error of a
/// number is its distance from the reference, divided by ReferenceRun::largest. Angles that wrap
/// are compared modulo 2 pi.
[[nodiscard]] DesignErrors run_errors(const std::vector<double>& last,
                                      const ReferenceRun& reference, const Model& model);

struct TradeoffRow {
  std::vector<std::string> values = {};  ///< value of each of TradeoffTable::dimensions, in order
  Design design = {};
  MeasuredCost cost = {};
  /// Cost of a call with one state; in packs, the state fills one lane.
  MeasuredCost call_cost = {};
  DesignErrors error = {};
  std::string failure = {};  ///< why cost and error are missing; "": they are present
  /// True: the measured error is below the error of the reference run. Then `worst` and `median` of
  /// `error` are the error of the reference run, and `least` is 0.
  bool is_below_reference = false;
  /// The rank by cost, from 1; 0 if the row failed. All rows whose cost equals the cheapest cost of
  /// the remaining rows get the next rank, so the rows of a rank never form a chain.
  std::size_t rank = 0;
  /// True if the worst error of the row is at most 1 and, beyond noise, smaller than the error of
  /// every earlier row that is on the front. A row below the reference may thus end the front.
  bool is_on_pareto_front = false;
};

struct TradeoffTable {
  std::string model = {};
  std::string subject = {};    ///< "inverse_dynamics"
  std::string cost = {};       ///< unit of the cost: "ns per state"
  std::string call_cost = {};  ///< "ns per call"; "" if it equals `cost` or is missing
  std::string error = {};      ///< "errors relative to the largest value of a field"
  std::vector<std::string> dimensions = {};
  /// Sorted by rank, then by worst error, then in planned order; failed rows are last.
  std::vector<TradeoffRow> rows = {};
  std::vector<std::string> sentences = {};  ///< notes below the table, a sentence each
  Machine machine = {};
  std::optional<double> max_error = {};  ///< largest permitted error of picked_row(); none: no pick
};

/// Ranks and sorts the planned rows, and marks the Pareto front.
[[nodiscard]] TradeoffTable rank_rows(TradeoffTable table);

/// The values of a row as text: "float, packs, full, fixed".
[[nodiscard]] std::string name_of(const TradeoffRow& row);

/// The cheapest row with a worst error of at most `max_error`; if several of these rows have the
/// same rank, the most accurate. Null if no row qualifies.
[[nodiscard]] const TradeoffRow* cheapest_accurate_row(const TradeoffTable& table,
                                                       double max_error);
/// cheapest_accurate_row() for table.max_error; null if no row qualifies or max_error is not set.
[[nodiscard]] const TradeoffRow* picked_row(const TradeoffTable& table);
/// The first row with the smallest worst error; null if all rows failed.
[[nodiscard]] const TradeoffRow* most_accurate_row(const TradeoffTable& table);

/// The table as text for people.
[[nodiscard]] std::string to_text(const TradeoffTable& table);
[[nodiscard]] std::string to_csv(const TradeoffTable& table);
[[nodiscard]] std::string to_json(const TradeoffTable& table);
/// A plot of worst errors over costs on logarithmic axes, with the Pareto front as a staircase.
[[nodiscard]] std::string to_svg(const TradeoffTable& table);

}  // namespace elgen
