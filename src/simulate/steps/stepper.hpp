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

  /// The next steps lead from `state` at `begin` to `end`. Inputs may have jumped there.
  virtual void aim(const Numbers& state, double begin, double end) = 0;

  /// One step; the time it reaches, in the end `end` itself. None where it cannot be made.
  [[nodiscard]] virtual std::optional<double> step(Numbers& state) = 0;

  /// Why not.
  [[nodiscard]] virtual std::string_view obstacle() const = 0;

  /// From q, v and work to what the method has in their places, and back.
  virtual void to_own(Numbers& /*state*/, double /*t*/) {}
  virtual void to_plain(Numbers& /*state*/, double /*t*/) {}
};

/// A method (System&) with restart(state, t) and step(state, t, h), in steps of one length.
template <class Method>
class FixedSteps : public Stepper {
 public:
  FixedSteps(System& system, double longest) : method(system), longest_(longest) {}

  void aim(const Numbers& state, double begin, double end) override {
    // A quotient that is whole but for rounding is whole.
    const double count = std::ceil((end - begin) / longest_ * (1 - 1e-12));
    count_ = static_cast<std::uint64_t>(std::max(count, 1.0));
    begin_ = begin;
    end_ = end;
    length_ = (end - begin) / static_cast<double>(count_);
    done_ = 0;
    method.restart(state, begin);
  }

  std::optional<double> step(Numbers& state) override {
    if (!method.step(state, begin_ + static_cast<double>(done_) * length_, length_)) {
      return std::nullopt;
    }
    ++done_;
    return done_ == count_ ? end_ : begin_ + static_cast<double>(done_) * length_;
  }

  [[nodiscard]] std::string_view obstacle() const override {
    return "the equations of the step are not solved";
  }

 protected:
  Method method;

 private:
  double longest_;
  double begin_ = 0;
  double end_ = 0;
  double length_ = 0;
  std::uint64_t count_ = 0;
  std::uint64_t done_ = 0;
};

}  // namespace elgen
