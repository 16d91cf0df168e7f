// Kinks: on which sides of the kinks of abs, sign, min and max a set of states lies.
//
// Functions that agree on one side of a kink may differ on the other, so states are drawn until
// both sides have a state.
#pragma once

#include <string>
#include <vector>

#include "elgen/oracle.hpp"

namespace elgen {

/// The largest number of draws in search of sides without a state.
inline constexpr std::size_t most_draws_for_kinks = 256;

class Kinks {
 public:
  /// Finds all kinks of the model. The model must outlive this object.
  explicit Kinks(const Model& model);

  /// Adds a state. True if it is the first state on some side. Cost: the oracle evaluates the
  /// arguments of all kinks that do not have states on both sides.
  bool add(const State& state);

  [[nodiscard]] bool all_are_seen() const { return incomplete_.empty(); }

  /// The calls without states on both sides: "`max(x - 5, 0)`, `abs(y)`".
  [[nodiscard]] std::string unseen() const;

 private:
  struct Kink {
    ExpressionId call = 0;
    bool below = false;  ///< some state has argument < 0, or first argument < second
    bool above = false;
  };

  const Model& model_;
  std::vector<Kink> incomplete_ = {};
};

}  // namespace elgen
