// Kinks: the sides of abs, sign, min and max on which a set of states lies.
//
// Functions that agree on one side of a kink may differ on the other, so states are drawn until
// both sides have been seen.
#pragma once

#include <string>
#include <vector>

#include "elgen/oracle.hpp"

namespace elgen {

/// The number of draws for sides that have not been seen.
inline constexpr std::size_t most_draws_for_kinks = 256;

class Kinks {
 public:
  /// Finds all kinks of the model, which must outlive this.
  explicit Kinks(const Model& model);

  /// True if the state lies on a side that no state before it lay on. Cost: the oracle evaluates
  /// the arguments of kinks that have not been seen on both sides.
  bool add(const State& state);

  [[nodiscard]] bool all_are_seen() const { return incomplete_.empty(); }

  /// "`max(x - 5, 0)`, `abs(y)`": the calls that have not been seen on both sides.
  [[nodiscard]] std::string unseen() const;

 private:
  struct Kink {
    ExpressionId call = 0;
    bool below = false;  ///< first argument < second, or < 0
    bool above = false;
  };

  const Model& model_;
  std::vector<Kink> incomplete_ = {};
};

}  // namespace elgen
