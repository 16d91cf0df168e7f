// TradeoffTable: what the designs of one output, or of one run, cost and how far they are off.
//
// A design is a scene. plan() lists designs; the pipeline and the compiler run on each;
// find_costs() and found_errors() look at what came out, and judged() makes the table. What the
// scene of a design promises is checked by promised_errors().
//
// Costs and errors have noise. Two costs are alike where the dearer is at most alike_within times
// the cheaper, or where their quartiles overlap. The error of a design is found in three samples of
// states, by three seeds; the noise of an error is the interval from the least of the three to the
// worst. The error of a run is known to the distance of two reference runs. An error is smaller
// than another one where alike_within times its worst is below the least of the other. The Pareto
// front is the rows whose error is smaller than that of every row of the front in front of them.
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

/// The model and the scene that designs start from.
struct DesignBase {
  const CheckedModel& checked;        ///< with the output as the first one
  const FileSyntax* scene = nullptr;  ///< null: the model alone
  /// The promise of a written scene, in the ranges of `scene` and these ("theta=-1..1").
  std::optional<double> max_error = {};
  std::vector<SourcePointer> ranges = {};
};

/// Functions of one state call the library for sines and cosines.
inline constexpr std::string_view library_sines = "library";

/// The choice in each dimension; "" where that of the scene stands.
struct Design {
  ScalarKind scalar = ScalarKind::double_precision;  ///< or float
  bool in_packs = false;
  /// max_error of polynomials; "": as accurate as the scalar; or library_sines
  std::string trigonometry = {};
  bool is_fixed = false;                  ///< every parameter is a number
  InnerScalar inner = InnerScalar::same;  ///< of one state in double
  std::string order = {};                 ///< of an expansion, or "exact": nothing is approximated
  std::optional<StepSpec> step = {};      ///< in the place of the output
  std::string doc = {};                   ///< of the scene
  friend bool operator==(const Design&, const Design&) = default;
};

/// The design that computes exactly what the model says.
inline const Design exact_design{.order = "exact"};

/// A dimension of designs, and the values that it has.
struct DesignDimension {
  std::string name = {};  ///< "scalar"
  std::string doc = {};   ///< of an option that pins it
  std::vector<std::string> values = {};
};

[[nodiscard]] std::vector<DesignDimension> design_dimensions();

/// Designs that differ from the value are not tried; both words are of design_dimensions().
struct PinnedDimension {
  std::string name = {};
  std::string value = {};
};

struct DesignChoices {
  std::vector<std::string> more = {};  ///< dimensions that are tried beside the usual ones
  std::vector<PinnedDimension> pinned = {};
};

/// E644, at its key, where the scene says another value of a pinned dimension.
[[nodiscard]] Diagnostics contradictions(const DesignBase& base,
                                         const std::vector<PinnedDimension>& pinned);

struct PlannedDesign {
  std::vector<std::string> values = {};  ///< of the dimensions, in their order
  Design design = {};
};

struct TradeoffPlan {
  std::vector<std::string> dimensions = {};  ///< those with two values or more, and pinned ones
  std::vector<PlannedDesign> designs = {};
};

/// The scalars, batches, sines and parameters that the first function of `program` takes, in all
/// combinations that there are and that `choices` leaves. E631; E645 where it leaves none.
[[nodiscard]] Result<TradeoffPlan> plan(const CheckedModel& checked, const Program& program,
                                        const DesignChoices& choices);

/// The design as a scene file of a model at `model_path`.
[[nodiscard]] std::string scene_text(const DesignBase& base, const Design& design,
                                     const std::string& model_path);

/// The common part of designs that are derived alike: all but scalars, packs and their sines.
[[nodiscard]] Design derivation_of(const Design& design);

/// A number to 32 digits: high + low.
struct ExactNumber {
  double high = 0;
  double low = 0;
};

/// States at which errors are looked at, with the exact value of every entry at each.
struct TradeoffStates {
  std::vector<Arguments<double>> states = {};  ///< float gets them rounded, which counts
  std::vector<std::size_t> field_sizes = {};
  std::vector<std::vector<ExactNumber>> exact = {};  ///< of each state the entries
  Arguments<double> low = {};                        ///< ends of the ranges they are drawn from
  Arguments<double> high = {};
  std::uint64_t seed = 1;  ///< of the search from them
};

/// How many, and which.
struct TradeoffSampling {
  std::size_t count = 1000;
  std::uint64_t seed = 1;
};

/// States inside the ranges of the model, narrowed by those of the scene, and the values that the
/// first function of the program has there, by numbers of 60 digits, with the exact parameters.
/// E521 where it has none. Cost: one operation of Real per instruction and state.
[[nodiscard]] Result<TradeoffStates> tradeoff_states(const CheckedModel& exact,
                                                     const Program& program,
                                                     const TradeoffSampling& sampling);

/// For each state: the largest |x - x*| of the entries of a field / the largest |x*| of that field
/// at any state. Infinite where x is no number. `results` as those of DesignValues.
[[nodiscard]] std::vector<double> state_errors(const std::vector<double>& results,
                                               const TradeoffStates& states);

/// The values of a design at states: entry k of state i at [k * states.size() + i]; never asked at
/// no state.
using DesignValues = std::function<std::vector<double>(const std::vector<Arguments<double>>&)>;

struct FoundErrors {
  double worst = 0;              ///< of the states and of those that the search came to
  double median = 0;             ///< of the states
  Arguments<double> where = {};  ///< the worst state
};

/// The states, and a pattern search inside the ranges from the worst of them, one for each hundred,
/// at about 20 others for each state: each number that the function reads goes up and down by a
/// step, and all that help go together; the step doubles where this is worse, and is halved where
/// nothing is. There errors are those from the program in long double; the states that it ends at
/// are confirmed in 60 digits. Relative to the largest |x*| of the field at the states, or where
/// that is larger at the state itself. The same in every run, whatever the time takes.
[[nodiscard]] FoundErrors found_errors(const CheckedModel& exact, const Program& program,
                                       const TradeoffStates& states, const DesignValues& design);

/// The error of a design in a table is so many times the worst that was found.
inline constexpr double search_margin = 1.5;

/// Costs, and errors, within this factor are alike, however well they are measured: a table shows
/// two digits of an error, and times of the same code differ by as much from run to run.
inline constexpr double alike_within = 1.1;

/// `[numeric] max_error` of the scene, held against `compiled` and options.as_users: a row for each
/// output, header and scalar, which fails where the worst error found is larger. `exact` and
/// `program` are those of the scene without its expansion. Nothing where it promises nothing.
[[nodiscard]] std::vector<CertificateRow> promised_errors(const CheckedModel& exact,
                                                          const Program& program,
                                                          const CompiledHeaders& compiled,
                                                          const VerifyOptions& options);

/// Median and quartiles.
struct Spread {
  double median = 0;
  double low = 0;
  double high = 0;
};

/// In a table: the error of a design or of a run, and its noise.
struct DesignErrors {
  double worst = 0;
  double median = 0;
  double least = 0;  ///< the worst error may as well be this
};

/// search_margin times the worst of all samples and the worst of that sample where it is least, and
/// the median of their medians. There is at least one.
[[nodiscard]] DesignErrors errors_of(std::vector<FoundErrors> samples);

/// Work of equal parts, and the cost of one of them in ns of the processor.
struct TimedWork {
  std::function<void()> run = {};
  std::size_t parts = 1;
  Spread* cost = nullptr;
};

/// Sets the costs, by turns, so that all meet the same machine: as many rounds as `seconds` allow,
/// 9 at least and 1001 at most.
void find_costs(const std::vector<TimedWork>& works, double seconds = 1.5);

/// A run by an emitted step of one length.
struct PlannedRun {
  std::vector<std::string> values = {};  ///< method, order, step, batch
  Design design = {};
  std::size_t steps = 0;
};

/// All methods and orders, each in these lengths of steps, whole parts of `time`, or in a few where
/// there are none; by one state and in packs.
[[nodiscard]] std::vector<PlannedRun> planned_runs(double time,
                                                   const std::vector<double>& lengths = {});

/// q and v at the end of a run from the model's start; inputs are held over each step at their
/// values at its start. `program` is that of the equations, which simulate() takes.
[[nodiscard]] std::vector<double> end_of_run(const CheckedModel& checked, const Program& program,
                                             const StepLoops& loops, const PlannedRun& run,
                                             double time);

/// Some steps of a length from the model's start, of one state, or of 256 side by side in packs;
/// each step of each state is a part of the work.
[[nodiscard]] TimedWork timed_steps(const CheckedModel& checked, const Program& program,
                                    const StepLoops& loops, bool in_packs, double length);

/// Errors of coordinates and rates at the end: the distance from the reference / the largest
/// magnitude of that number in the reference; the largest and the median. Angles that wrap are near
/// each other across the jump.
[[nodiscard]] DesignErrors errors_of(const std::vector<double>& last, const ReferenceRun& reference,
                                     const Model& model);

struct TradeoffRow {
  std::vector<std::string> values = {};  ///< of the dimensions
  Design design = {};
  Spread cost = {};
  Spread call_cost = {};  ///< of a call with one state; in packs it fills one place of them
  DesignErrors error = {};
  std::string failure = {};  ///< why there is neither cost nor error; "": there is
  /// The error is that of the reference, which the row's own is not told from.
  bool is_below_reference = false;
  /// From 1 on. A rank is the cheapest row that no rank has yet, with those whose costs are like
  /// its own: their costs are taken to be equal. 0 where it failed.
  std::size_t rank = 0;
  /// Its worst error is at most 1, and its error is smaller, beyond noise, than that of every row
  /// before it that is on the front or below the reference.
  bool is_on_pareto_front = false;
};

struct TradeoffTable {
  std::string model = {};
  std::string subject = {};    ///< "inverse_dynamics"
  std::string cost = {};       ///< what it is: "ns per state"
  std::string call_cost = {};  ///< "ns per call"; "" where it is no other, or there is none
  std::string error = {};      ///< likewise
  std::vector<std::string> dimensions = {};
  /// By ranks, in a rank by worst errors, of the same error as planned; failed ones last.
  std::vector<TradeoffRow> rows = {};
  std::vector<std::string> sentences = {};  ///< below the table
  Machine machine = {};
  std::optional<double> max_error = {};  ///< that a row is picked by
};

/// Ranks and sorts the rows, which are as planned, and marks the Pareto front.
[[nodiscard]] TradeoffTable judged(TradeoffTable table);

/// "float, packs, full, fixed"
[[nodiscard]] std::string name_of(const TradeoffRow& row);

/// The first row whose worst error is at most this: of the cheapest rank that has one the most
/// accurate. Null where there is none.
[[nodiscard]] const TradeoffRow* cheapest_within(const TradeoffTable& table, double max_error);
/// The one within table.max_error; null where none is or none is asked for.
[[nodiscard]] const TradeoffRow* picked(const TradeoffTable& table);
/// The row of the smallest worst error, the cheapest of them; null where all failed.
[[nodiscard]] const TradeoffRow* most_accurate(const TradeoffTable& table);

/// For people.
[[nodiscard]] std::string to_text(const TradeoffTable& table);
[[nodiscard]] std::string to_csv(const TradeoffTable& table);
[[nodiscard]] std::string to_json(const TradeoffTable& table);
/// Worst errors over costs, both logarithmic; the Pareto front is a staircase.
[[nodiscard]] std::string to_svg(const TradeoffTable& table);

}  // namespace elgen
