// find_errors: a pattern search (Hooke and Jeeves) for the state at which a design has its largest
// error.
//
// Rounding errors jump from state to state, but their size also varies slowly over the ranges. The
// search tries steps around the worst state so far, from 2^-1 to 2^-20 of a range. Each step is
// multiplied by a random number between 1/2 and 1, so that the search always reaches new states.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>
#include <vector>

#include "elgen/oracle.hpp"
#include "program/evaluate/subject.hpp"
#include "run/steps/rounded_program.hpp"
#include "run/tradeoff/errors.hpp"
#include "sample/states.hpp"

namespace elgen {
namespace {

constexpr std::size_t states_of_a_climb = 100;  ///< one climb per 100 states, from the worst states
constexpr std::size_t searches_per_state = 20;
constexpr std::size_t fewest_sweeps = 8;
constexpr std::size_t most_sweeps = 400;
constexpr double longest_step = 0.5;  ///< steps are fractions of a range
constexpr double first_step = 0.25;
constexpr double shortest_step = 0x1p-20;

/// A leaf on which the function depends, and its range.
struct SearchedLeaf {
  Opcode kind;
  std::uint32_t number;
  double low;
  double high;
};

/// The leaves that the search varies: the function's leaves with a range, except parameters.
std::vector<SearchedLeaf> searched_leaves(const Function& function, const TradeoffStates& states) {
  std::vector<SearchedLeaf> moving;
  for (const Instruction& i : function.instructions) {
    if (!is_leaf(i.opcode) || i.opcode == Opcode::parameter) continue;
    const SearchedLeaf found{i.opcode, i.a, leaf_of(states.low, i.opcode, i.a),
                             leaf_of(states.high, i.opcode, i.a)};
    if (found.low < found.high) moving.push_back(found);
  }
  return moving;
}

/// One search upwards: the worst state so far, its error, and the next step.
struct Climb {
  Arguments<double> state;
  double error;
  double step;  ///< a fraction of the ranges
};

class ErrorSearch {
 public:
  ErrorSearch(const CheckedModel& exact, const Program& program, const TradeoffStates& states,
              const DesignEvaluator& design)
      : exact_(exact),
        program_(program),
        reference_(program),
        parameters_(arguments_at<long double>(nominal_state(exact.model, exact.scene)).parameters),
        scales_(states),
        searched_leaves_(searched_leaves(program.functions.front(), states)),
        design_(design),
        states_searched_(searches_per_state * states.states.size()),
        sampler_(states.seed) {}

  /// Runs all climbs, and returns their final states.
  std::vector<Arguments<double>> search(std::vector<Climb> climbs) {
    const std::size_t states_of_sweep = climbs.size() * (2 * searched_leaves_.size() + 1);
    const std::size_t sweeps =
        std::clamp(states_searched_ / states_of_sweep, fewest_sweeps, most_sweeps);
    for (std::size_t i = 0; i < sweeps && !searched_leaves_.empty(); ++i) sweep(climbs);
    std::vector<Arguments<double>> ends;
    for (Climb& climb : climbs) ends.push_back(std::move(climb.state));
    return ends;
  }

  /// The errors at `states`, computed in 60 digits; 0 at states outside the domain.
  [[nodiscard]] std::vector<double> exact_errors(
      const std::vector<Arguments<double>>& states) const {
    return errors(states, [this](const Arguments<double>& state) {
      return exact_entries(exact_, program_, state);
    });
  }

 private:
  /// The error at each of `states`, with exact entries exact(state); 0 if exact(state) is none.
  template <class Exact>
  [[nodiscard]] std::vector<double> errors(const std::vector<Arguments<double>>& states,
                                           const Exact& exact) const {
    const std::vector<double> values = design_(states);
    std::vector<double> found;
    for (std::size_t i = 0; i < states.size(); ++i) {
      const auto entries = exact(states[i]);
      found.push_back(entries ? scales_.error(states[i], values.data() + i, states.size(), *entries)
                              : 0);
    }
    return found;
  }

  /// The error at each of `states`, with the program's values in long double as the exact entries.
  /// On some machines, long double is 2048 times as precise as double.
  [[nodiscard]] std::vector<double> approximate_errors(
      const std::vector<Arguments<double>>& states) const {
    return errors(states, [this](const Arguments<double>& state) {
      auto arguments = map_leaves([](double x) { return static_cast<long double>(x); }, state);
      arguments.parameters = parameters_;
      for (const auto& [i, range] : exact_.scene.numerics.varied_parameters) {
        arguments.parameters[i] = static_cast<long double>(state.parameters[i]);
      }
      std::optional entries = reference_.evaluate(program_.functions.front(), arguments);
      const bool is_defined =
          std::ranges::all_of(*entries, [](long double x) { return std::isfinite(x); });
      if (!is_defined) entries.reset();
      return entries;
    });
  }

  [[nodiscard]] Arguments<double> neighbour_state(const Climb& climb, const SearchedLeaf& number,
                                                  double share) const {
    Arguments<double> state = climb.state;
    const double from = leaf_of(state, number.kind, number.number);
    const double to = from + share * climb.step * (number.high - number.low);
    set_leaf(state, number.kind, number.number, std::clamp(to, number.low, number.high));
    normalize_quaternions(exact_.model, state);
    return state;
  }

  /// For each climb and each leaf two states: the leaf increased, and decreased.
  [[nodiscard]] std::vector<Arguments<double>> neighbours(const std::vector<Climb>& climbs) {
    std::vector<Arguments<double>> states;
    for (const Climb& climb : climbs) {
      for (const SearchedLeaf& number : searched_leaves_) {
        const double share = sampler_.random_fraction();
        states.push_back(neighbour_state(climb, number, share));
        states.push_back(neighbour_state(climb, number, -share));
      }
    }
    return states;
  }

  /// The state of `climb`; each leaf that alone increased the error has its value from the worse of
  /// the two states in `near` that move this leaf.
  [[nodiscard]] Arguments<double> combined_state(const Climb& climb, const Arguments<double>* near,
                                                 const double* errors) const {
    Arguments<double> state = climb.state;
    for (std::size_t k = 0; k < searched_leaves_.size(); ++k) {
      const std::size_t worse = errors[2 * k] >= errors[2 * k + 1] ? 2 * k : 2 * k + 1;
      const SearchedLeaf& number = searched_leaves_[k];
      if (errors[worse] <= climb.error) continue;
      set_leaf(state, number.kind, number.number, leaf_of(near[worse], number.kind, number.number));
    }
    normalize_quaternions(exact_.model, state);
    return state;
  }

  void sweep(std::vector<Climb>& climbs) {
    const std::size_t each = 2 * searched_leaves_.size();
    const std::vector<Arguments<double>> near = neighbours(climbs);
    const std::vector<double> errors = approximate_errors(near);
    std::vector<Arguments<double>> joint;
    for (std::size_t c = 0; c < climbs.size(); ++c) {
      joint.push_back(combined_state(climbs[c], &near[c * each], &errors[c * each]));
    }
    const std::vector<double> of_joint = approximate_errors(joint);
    for (std::size_t c = 0; c < climbs.size(); ++c) {
      Climb& climb = climbs[c];
      const double before = climb.error;
      for (std::size_t k = c * each; k < (c + 1) * each; ++k)
        keep_if_worse(climb, near[k], errors[k]);
      keep_if_worse(climb, joint[c], of_joint[c]);
      climb.step = climb.error > before ? std::min(2 * climb.step, longest_step) : climb.step / 2;
      if (climb.step < shortest_step) climb.step = first_step;
    }
  }

  static void keep_if_worse(Climb& climb, const Arguments<double>& state, double error) {
    if (error > climb.error) climb = {state, error, climb.step};
  }

  const CheckedModel& exact_;
  const Program& program_;
  RoundedProgram<long double> reference_;
  std::vector<long double> parameters_;  ///< the exact parameters, rounded to long double
  FieldScales scales_;
  std::vector<SearchedLeaf> searched_leaves_;
  const DesignEvaluator& design_;
  std::size_t states_searched_;
  Sampler sampler_;
};

}  // namespace

FoundErrors find_errors(const CheckedModel& exact, const Program& program,
                        const TradeoffStates& states, const DesignEvaluator& design) {
  const std::vector<double> errors = state_errors(design(states.states), states);
  std::vector<std::size_t> order(errors.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::greater<>(), [&](std::size_t i) { return errors[i]; });
  const std::size_t worst = order.front();
  FoundErrors found{errors[worst], errors[order[order.size() / 2]], states.states[worst]};
  std::vector<Climb> climbs;
  for (std::size_t i = 0; i * states_of_a_climb < order.size(); ++i) {
    climbs.push_back({states.states[order[i]], errors[order[i]], first_step});
  }
  ErrorSearch search(exact, program, states, design);
  const std::vector<Arguments<double>> ends = search.search(std::move(climbs));
  const std::vector<double> confirmed = search.exact_errors(ends);
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (confirmed[i] <= found.worst) continue;
    found.worst = confirmed[i];
    found.worst_state = ends[i];
  }
  return found;
}

}  // namespace elgen
