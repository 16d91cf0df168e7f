// Kinks: on which sides of abs, sign, min and max a set of states lies.
//
// Two functions that agree on one side of a kink may differ on the other, so that states are drawn
// until both have been seen.
#pragma once

#include <string>
#include <vector>

#include "elgen/oracle.hpp"

namespace elgen {

/// So many states are drawn for sides that have not been seen.
inline constexpr std::size_t most_draws_for_kinks = 256;

class Kinks {
 public:
  /// Finds kinks of all forces of the model, which outlives it.
  explicit Kinks(const Model& model);

  /// Whether the state lies on a side that no state before it lay on. Cost: the arguments of the
  /// kinks that are left, by the oracle.
  bool add(const State& state);

  [[nodiscard]] bool are_seen() const { return left_.empty(); }

  /// "`max(x - 5, 0)`, `abs(y)`": the calls that were seen on one side, or on none.
  [[nodiscard]] std::string unseen() const;

 private:
  struct Kink {
    ExpressionId call = 0;
    bool below = false;  ///< first argument < second, or < 0
    bool above = false;
  };

  const Model& model_;
  std::vector<Kink> left_ = {};
};

}  // namespace elgen
