// The recursive and the chosen program of an energy, and the states at which their errors are
// measured. All coordinates of these states are doubles, which the oracle takes exactly.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "choose/chosen.hpp"
#include "choose/energies.hpp"
#include "choose/points.hpp"
#include "elgen/domain.hpp"
#include "elgen/oracle.hpp"
#include "numbers/exact_number.hpp"
#include "sample/states.hpp"

namespace elgen::test {

/// The forms chosen for gravity and V of `energy`, without the stable forms.
inline ChosenForms chosen_energy(const TypedEnergy& energy, InnerScalar inner = InnerScalar::same) {
  SceneOptions options;
  options.inner = inner;
  options.outputs = {make_source("command line", "gravity,potential_energy")};
  return chosen(model_of(energy), options);
}

/// The nominal state with coordinates `q` and with parameters rounded to double, so that equal
/// parameters stay equal and no value is rounded again.
inline State state_in_double(const CheckedModel& checked, const std::vector<double>& q) {
  State state = nominal_state(checked.model, checked.scene);
  for (cln::cl_R& p : state.parameters) p = exact_value(to_double(p));
  for (std::size_t i = 0; i < q.size(); ++i) state.q[i] = exact_value(q[i]);
  return state;
}

/// Distinct states inside the ranges: the origin and zeros of typed sums; states near the origin,
/// the zeros and the places of `near`, at distances down to 1e-150; states of the domain; random
/// states.
class SampleStates {
 public:
  SampleStates(const TypedEnergy& energy, const ChosenForms& c)
      : domain_(domain_of({c.checked.model, c.checked.scene, c.recursive.leaves})) {
    SumZeros zeros = find_sum_zeros(c.recursive, domain_);
    zeros.emplace_back(c.checked.model.coordinates.size());
    for (const std::vector<double>& zero : zeros) add(zero);
    for (const double distance : {1e-1, 1e-4, 1e-8, 1e-12, 1e-150}) {
      for (const std::string& line : energy.near) {
        for (const auto& q : StatesNear(c.checked.model, line).at(distance)) add(q);
      }
      for (const std::vector<double>& zero : zeros) {
        for (const double step : {distance, -distance}) add_displaced(zero, step);
      }
    }
    for (const Arguments<double>& state : domain_.states) add(state.q);
    Sampler draw(2);
    const StateSpace space{c.checked.model, c.checked.scene, c.recursive.leaves};
    while (all.size() < least_count) add(draw_in_ranges(space, domain_.ranges, draw).q);
  }

  std::vector<std::vector<double>> all = {};

 private:
  static constexpr std::size_t least_count = 125;

  void add(const std::vector<double>& q) {
    for (std::size_t i = 0; i < q.size(); ++i) {
      const Range& range = domain_.ranges.q[i];
      if (q[i] < range.low || q[i] > range.high) return;
    }
    if (std::ranges::find(all, q) == all.end()) all.push_back(q);
  }

  /// Adds `zero` with each coordinate displaced alone, and `zero` with all coordinates displaced.
  void add_displaced(const std::vector<double>& zero, double step) {
    std::vector<double> moved = zero;
    for (std::size_t i = 0; i < zero.size(); ++i) {
      std::vector<double> alone = zero;
      alone[i] = moved[i] = displaced(zero[i], step);
      add(alone);
    }
    add(moved);
  }

  Domain domain_;
};

}  // namespace elgen::test
