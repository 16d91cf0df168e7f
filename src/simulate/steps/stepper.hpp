// Stepper: a method of integration, one step after another from the begin of an interval to its
// end.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>

#include "simulate/steps/system.hpp"

namespace elgen {

class Stepper {
 public:
  Stepper() = default;
  Stepper(const Stepper&) = delete;
  Stepper& operator=(const Stepper&) = delete;
  virtual ~Stepper() = default;

  /// The next steps lead from `begin` to `end`. Inputs may have jumped at `begin`.
  virtual void aim(double begin, double end) = 0;

  /// One step; the time it reaches, in the end `end` itself. None where it cannot be made.
  [[nodiscard]] virtual std::optional<double> step(Numbers& state) = 0;

  /// Why not.
  [[nodiscard]] virtual std::string_view obstacle() const = 0;
};

/// A method (System&) with restart() and step(state, t, h), in steps of one length.
template <class Method>
class FixedSteps final : public Stepper {
 public:
  FixedSteps(System& system, double longest) : method_(system), longest_(longest) {}

  void aim(double begin, double end) override {
    // A quotient that is whole but for rounding is whole.
    const double count = std::ceil((end - begin) / longest_ * (1 - 1e-12));
    count_ = static_cast<std::uint64_t>(std::max(count, 1.0));
    begin_ = begin;
    end_ = end;
    length_ = (end - begin) / static_cast<double>(count_);
    done_ = 0;
    method_.restart();
  }

  std::optional<double> step(Numbers& state) override {
    if (!method_.step(state, begin_ + static_cast<double>(done_) * length_, length_)) {
      return std::nullopt;
    }
    ++done_;
    return done_ == count_ ? end_ : begin_ + static_cast<double>(done_) * length_;
  }

  [[nodiscard]] std::string_view obstacle() const override {
    return "the equations of the step are not solved";
  }

 private:
  Method method_;
  double longest_;
  double begin_ = 0;
  double end_ = 0;
  double length_ = 0;
  std::uint64_t count_ = 0;
  std::uint64_t done_ = 0;
};

}  // namespace elgen
