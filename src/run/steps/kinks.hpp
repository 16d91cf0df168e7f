// KinkWatch: on which side of each abs, sign, min and max of forces and laws a state lies. A side
// is the sign of the argument, or of the difference of two.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "run/steps/system.hpp"

namespace elgen {

class KinkWatch {
 public:
  /// Kinks whose argument changes along a motion.
  explicit KinkWatch(System& system);

  [[nodiscard]] bool empty() const { return kinks_.empty(); }

  /// -1, 0 or 1 of each kink; 0 of a law whose input is held. Cost: the arguments.
  [[nodiscard]] std::vector<int> sides(const Numbers& state, double t);

  /// The velocity on which alone the argument depends.
  [[nodiscard]] std::optional<std::size_t> rate_of(std::size_t kink) const {
    return kinks_[kink].rate;
  }

  /// "`sign(x + dot(x))`"
  [[nodiscard]] std::string text_of(std::size_t kink) const;

 private:
  struct Kink {
    ExpressionId call = 0;
    bool is_of_law = false;
    std::optional<std::size_t> rate = {};
    std::vector<StateFunction> arguments = {};
  };

  void add(ExpressionId call, bool is_of_law);

  System& system_;
  std::vector<Kink> kinks_ = {};
};

}  // namespace elgen
