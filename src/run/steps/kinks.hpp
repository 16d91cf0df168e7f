// KinkWatch: the side of each abs, sign, min and max in forces and laws on which a state lies. The
// side is the sign of the argument, or of the difference of two arguments.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "run/steps/system.hpp"

namespace elgen {

class KinkWatch {
 public:
  /// Considers kinks whose argument changes along a motion.
  explicit KinkWatch(System& system);

  [[nodiscard]] bool empty() const { return kinks_.empty(); }

  /// -1, 0 or 1 for each kink; 0 for the law of an input on hold. Cost: evaluation of the
  /// arguments.
  [[nodiscard]] std::vector<int> sides(const Numbers& state, double t);

  /// The velocity, if the argument depends on no other variable.
  [[nodiscard]] std::optional<std::size_t> rate_of(std::size_t kink) const {
    return kinks_[kink].rate;
  }

  /// "`sign(x + dot(x))`"
  [[nodiscard]] std::string kink_text(std::size_t kink) const;

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
