// TradeoffTable: what the designs of one output, or of one run, cost and how far they are off.
//
// A design is a scene. plan() lists designs; the pipeline and the compiler run on each; measured()
// and errors_of() look at what came out, and judged() makes the table.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "elgen/program.hpp"
#include "elgen/scene.hpp"
#include "elgen/simulate.hpp"
#include "elgen/syntax.hpp"
#include "elgen/timing.hpp"

namespace elgen {

/// The model and the scene that designs start from.
struct DesignBase {
  const CheckedModel& checked;        ///< with the output as the first one
  const FileSyntax* scene = nullptr;  ///< null: the model alone
};

/// The choice in each dimension; "" where that of the scene stands.
struct Design {
  ScalarKind scalar = ScalarKind::double_precision;  ///< or float
  bool in_packs = false;
  std::string trigonometry = {};        ///< max_error of polynomials; "": as accurate as the scalar
  bool is_fixed = false;                ///< every parameter is a number
  std::string order = {};               ///< of an expansion, or "exact": nothing is approximated
  std::optional<ChosenStep> step = {};  ///< in the place of the output
  std::string doc = {};                 ///< of the scene
  friend bool operator==(const Design&, const Design&) = default;
};

/// The design that computes exactly what the model says.
inline const Design exact_design{.order = "exact"};

struct PlannedDesign {
  std::vector<std::string> values = {};  ///< of the dimensions, in their order
  Design design = {};
};

struct TradeoffPlan {
  std::vector<std::string> dimensions = {};  ///< those with two values or more
  std::vector<PlannedDesign> designs = {};
};

/// The scalars, batches, sines and parameters that the first function of `program` takes, in all
/// combinations that there are; `more` adds dimensions by name. E631.
[[nodiscard]] Result<TradeoffPlan> plan(const CheckedModel& checked, const Program& program,
                                        const std::vector<std::string>& more);

/// The design as a scene file of a model at `model_path`.
[[nodiscard]] std::string scene_text(const DesignBase& base, const Design& design,
                                     const std::string& model_path);

/// The common part of designs that are derived alike: all but scalar, packs and their sines.
[[nodiscard]] Design derivation_of(const Design& design);

/// A number to 32 digits: high + low.
struct ExactNumber {
  double high = 0;
  double low = 0;
};

/// States at which errors are looked at, with the exact value of every entry at each.
struct TradeoffStates {
  std::vector<Arguments<float>> states = {};  ///< numbers of float are numbers of every scalar
  std::vector<std::size_t> field_sizes = {};
  std::vector<ExactNumber> exact = {};  ///< entry k of state i at [k * states.size() + i]
};

/// `count` states inside the ranges of the model, narrowed by `ranges` ("theta=-0.1..0.1"), and the
/// values that the first function of the program has there, by numbers of 60 digits, with the exact
/// parameters. E630; E521 where it has none. Cost: one operation of Real per instruction and state.
[[nodiscard]] Result<TradeoffStates> tradeoff_states(const CheckedModel& exact,
                                                     const Program& program,
                                                     const std::vector<SourcePointer>& ranges,
                                                     std::size_t count);

/// Median and quartiles.
struct Spread {
  double median = 0;
  double low = 0;
  double high = 0;
};

/// Over states: the largest |x - x*| of the entries of a field / the largest |x*| of that field at
/// any state. Infinite where x is no number.
struct DesignErrors {
  double worst = 0;
  double median = 0;
};

/// By results as TimedFunction gives them.
[[nodiscard]] DesignErrors errors_of(const std::vector<double>& results,
                                     const TradeoffStates& states);

/// How many rounds there are: as many as `seconds` allow, but so few at least and so many at most.
struct Rounds {
  double seconds = 0;
  std::size_t fewest = 1;
  std::size_t most = 1;
};

/// Appends figure(i) to figures[i] of each i in turn, so that all meet the same machine, until each
/// has as many as there are rounds; what is there already counts.
void by_turns(std::vector<std::vector<double>>& figures, const Rounds& rounds,
              const std::function<double(std::size_t)>& figure);

/// Processor time in ns of each, by turns: as many rounds as `seconds` allow, 9 at least and 1001
/// at most.
[[nodiscard]] std::vector<Spread> measured(const std::vector<std::function<void()>>& alternatives,
                                           double seconds);

/// Of at least one number.
[[nodiscard]] Spread spread_of(std::vector<double> numbers);

/// A run by an emitted step of one length.
struct PlannedRun {
  std::vector<std::string> values = {};  ///< method, order, step, batch
  Design design = {};
  std::size_t steps = 0;
};

/// All methods and orders, each in a few lengths of steps, by one state and in packs.
[[nodiscard]] std::vector<PlannedRun> planned_runs(double time);

/// q and v at the end of a run from the model's start; in each step inputs keep what their laws are
/// where it starts. `program` is that of the equations, which simulate() takes.
[[nodiscard]] std::vector<double> end_of_run(const CheckedModel& checked, const Program& program,
                                             const StepLoops& loops, const PlannedRun& run,
                                             double time);

/// Some steps of a length from the model's start, to be timed.
struct TimedSteps {
  std::function<void()> work = {};
  std::size_t count = 0;  ///< steps, of all states together
};

/// Of one state, or of 256 side by side in packs.
[[nodiscard]] TimedSteps timed_steps(const CheckedModel& checked, const Program& program,
                                     const StepLoops& loops, bool in_packs, double length);

/// Of coordinates and rates at the end: the distance from the reference / the largest magnitude of
/// that number in the reference; the largest and the median one. Angles that wrap are near each
/// other across the jump.
[[nodiscard]] DesignErrors errors_of(const std::vector<double>& last, const ReferenceRun& reference,
                                     const Model& model);

struct TradeoffRow {
  std::vector<std::string> values = {};  ///< of the dimensions
  Design design = {};
  Spread cost = {};
  DesignErrors error = {};
  std::string failure = {};  ///< why there is neither cost nor error; "": there is
  /// The error is that of the reference, which the row's own is not told from.
  bool is_below_reference = false;
  bool is_on_front = false;  ///< nothing is as cheap and more accurate, or as accurate and cheaper
};

struct TradeoffTable {
  std::string model = {};
  std::string subject = {};  ///< "inverse_dynamics"
  std::string cost = {};     ///< what it is: "ns per state"
  std::string error = {};    ///< likewise
  std::vector<std::string> dimensions = {};
  std::vector<TradeoffRow> rows = {};       ///< cheapest first, failed ones last
  std::vector<std::string> sentences = {};  ///< of runs, below the table
  Machine machine = {};
};

/// Sorts the rows, and marks the front.
[[nodiscard]] TradeoffTable judged(TradeoffTable table);

/// "float, packs, full, fixed"
[[nodiscard]] std::string name_of(const TradeoffRow& row);

/// The cheapest row whose worst error is at most this; null where there is none.
[[nodiscard]] const TradeoffRow* cheapest_within(const TradeoffTable& table, double max_error);
/// The row of the smallest worst error, the cheapest of them; null where all failed.
[[nodiscard]] const TradeoffRow* most_accurate(const TradeoffTable& table);

/// For people.
[[nodiscard]] std::string to_text(const TradeoffTable& table);
[[nodiscard]] std::string to_csv(const TradeoffTable& table);
[[nodiscard]] std::string to_json(const TradeoffTable& table);
/// Worst errors over costs, both logarithmic; the front is joined.
[[nodiscard]] std::string to_svg(const TradeoffTable& table);

}  // namespace elgen
