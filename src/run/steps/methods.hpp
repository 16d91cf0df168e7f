// Methods of integration: their steppers, their table, and the choice of a method.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "elgen/simulate.hpp"
#include "elgen/step_methods.hpp"
#include "run/steps/system.hpp"

namespace elgen {

inline constexpr std::string_view usual_remedy =
    "check with a shorter step, or with a smaller tolerance";

/// Makes one step after another from the beginning of an interval to its end.
class Stepper {
 public:
  Stepper() = default;
  Stepper(const Stepper&) = delete;
  Stepper& operator=(const Stepper&) = delete;
  virtual ~Stepper() = default;

  /// The next steps lead from `begin` to `end`. Inputs may be discontinuous at `begin`.
  virtual void set_interval(double begin, double end) = 0;

  /// Makes one step and returns the time it reaches; the last step returns exactly `end`. Empty if
  /// the step cannot be made.
  [[nodiscard]] virtual std::optional<double> step(Numbers& state) = 0;

  /// The reason if step() made no step.
  [[nodiscard]] virtual std::string_view obstacle() const = 0;

  /// The hint of the resulting error.
  [[nodiscard]] virtual std::string_view remedy() const { return usual_remedy; }
};

/// Steps of one length by a method (System&) with restart() and step(state, t, h).
template <class Method>
class FixedSteps final : public Stepper {
 public:
  FixedSteps(System& system, double longest) : method_(system), longest_(longest) {}

  void set_interval(double begin, double end) override {
    // A quotient that differs from an integer by rounding counts as the integer.
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

/// The tolerance of a step if the options contain neither a tolerance nor a length of steps.
inline constexpr double default_tolerance = 1e-9;

/// Either the length of steps, or the tolerance from which it follows.
struct StepRule {
  std::optional<double> step = {};
  double tolerance = 0;
  double shortest = 0;  ///< lower bound of adapted steps
};

/// fixed: steps have one length; adapted: the tolerance determines it, unless a length is an
/// option.
enum class StepKind : std::uint8_t { fixed, adapted };

struct MethodRow {
  std::string_view name;
  std::uint32_t order;  ///< without composition
  StepKind step;
  std::optional<StepMethod> program;  ///< the `step` that it runs; none: it integrates dv/dt
  std::unique_ptr<Stepper> (*make)(System& system, const StepRule& rule);
};

/// All methods that `--method` accepts.
[[nodiscard]] std::span<const MethodRow> method_table();

[[nodiscard]] std::unique_ptr<Stepper> make_rk4(System& system, const StepRule& rule);
[[nodiscard]] std::unique_ptr<Stepper> make_dopri5(System& system, const StepRule& rule);
[[nodiscard]] std::unique_ptr<Stepper> make_step_program(System& system, const StepRule& rule);

/// The row of options.method. E620 with a suggestion; E647 for an unknown order.
[[nodiscard]] Result<MethodRow> find_method(const SimulationOptions& options);

/// The steps of a run. E621 for impossible numbers, for a step and a tolerance together, and for no
/// step if the method needs one.
[[nodiscard]] Result<StepRule> step_rule(const MethodRow& method, const SimulationOptions& options);

}  // namespace elgen
