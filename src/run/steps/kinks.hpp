// KinkWatch: finds on which side of each kink a state lies. Each abs, sign, min and max in forces
// and laws has a kink. The side is the sign of the argument; for min and max, the sign of the first
// argument minus the second.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/kinks.hpp"
#include "run/steps/system.hpp"

namespace elgen {

class KinkWatch {
 public:
  /// Finds all kinks whose arguments change along a motion.
  explicit KinkWatch(SimulatedSystem& system);

  [[nodiscard]] bool empty() const { return kinks_.empty(); }

  /// The side of each kink: -1, 0 or 1; 0 for kinks in laws while inputs are held. Cost: one
  /// evaluation of all arguments.
  [[nodiscard]] std::vector<int> sides(const Numbers& state, double t);

  /// The velocity, if it is the only variable in the arguments of `kink`; otherwise none.
  [[nodiscard]] std::optional<std::size_t> rate_of(std::size_t kink) const {
    return kinks_[kink].rate;
  }

  /// The call as typed: "`sign(x + dot(x))`".
  [[nodiscard]] std::string kink_text(std::size_t kink) const;

 private:
  struct Kink : KinkedCall {
    std::vector<StateFunction> arguments = {};
  };

  SimulatedSystem& system_;
  std::vector<Kink> kinks_ = {};
};

}  // namespace elgen
