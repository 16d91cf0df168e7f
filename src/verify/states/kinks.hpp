// KinkCoverage: the sides of the kinks of abs, sign, min and max that the sampled states cover.
//
// Functions that agree on one side of a kink may differ on the other, so states are drawn until
// both sides have a state.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "elgen/oracle.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// The largest number of draws in search of sides without a state.
inline constexpr std::size_t most_draws_for_kinks = 256;

class KinkCoverage {
 public:
  /// Finds all kinks of the model. The model must outlive this object.
  explicit KinkCoverage(const Model& model);

  /// Adds a state. True if it is the first state on some side. Cost: the oracle evaluates the
  /// arguments of all kinks that do not have states on both sides.
  bool add_state(const State& state);

  [[nodiscard]] bool is_complete() const { return one_sided_kinks_.empty(); }

  /// The calls without states on both sides: "`max(x - 5, 0)`, `abs(y)`".
  [[nodiscard]] std::string one_sided_kinks_text() const;

 private:
  struct Kink {
    ExpressionId call = 0;
    bool has_state_below = false;  ///< some state has argument < 0, or first argument < second
    bool has_state_above = false;
  };

  const Model& model_;
  std::vector<Kink> one_sided_kinks_ = {};
};

/// Random states, and the kinks that have states on one side only.
struct CoveringStates {
  std::vector<State> states = {};
  std::string one_sided_kinks = {};
};

/// `count` states by draw_state(), and more states if these lie on one side of a kink only.
[[nodiscard]] CoveringStates draw_covering_states(const Model& model, const Scene& scene,
                                                  std::size_t count, std::uint64_t seed);

}  // namespace elgen
