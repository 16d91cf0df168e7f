// Methods of integration: their steppers, their table, and the choice of a method by options.
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

inline constexpr std::string_view default_hint =
    "check with a shorter step, or with a smaller tolerance";

/// Why a run ends. A page ends its run with the same words.
inline constexpr std::string_view step_too_short =
    "the tolerance requires a step that is too short";
inline constexpr std::string_view slides_along = "the motion slides along the kink of ";

/// Steps from the beginning of an interval to its end.
class Stepper {
 public:
  Stepper() = default;
  Stepper(const Stepper&) = delete;
  Stepper& operator=(const Stepper&) = delete;
  virtual ~Stepper() = default;

  /// Sets the interval of the next steps. Inputs may be discontinuous at `begin`.
  virtual void set_interval(double begin, double end) = 0;

  /// Makes one step, and returns the time after it; the last step returns exactly `end`. None if no
  /// step is possible.
  [[nodiscard]] virtual std::optional<double> step(Numbers& state) = 0;

  /// Why step() returned none.
  [[nodiscard]] virtual std::string_view failure_reason() const = 0;

  /// The hint of the error that reports failure_reason().
  [[nodiscard]] virtual std::string_view failure_hint() const { return default_hint; }
};

/// Steps of equal length. Method: constructed from SimulatedSystem&, with restart() and step(state,
/// t, h).
template <class Method>
class FixedStepper final : public Stepper {
 public:
  FixedStepper(SimulatedSystem& system, double longest) : method_(system), longest_(longest) {}

  void set_interval(double begin, double end) override {
    // A quotient that exceeds an integer only by rounding counts as the integer.
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

  [[nodiscard]] std::string_view failure_reason() const override {
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

/// The tolerance of a step if the options have neither a tolerance nor a step.
inline constexpr double default_tolerance = 1e-9;

/// The fixed length of steps, or the tolerance to which steps are adapted.
struct StepRule {
  std::optional<double> step = {};
  double tolerance = 0;
  double shortest_step = 0;  ///< the shortest adapted step, in s
};

/// fixed: all steps have the length in the options. adaptive: the tolerance determines each length,
/// unless the options have a length.
enum class StepKind : std::uint8_t { fixed, adaptive };

struct MethodRow {
  std::string_view name;
  std::uint32_t order;  ///< of the method itself, without composition of steps
  StepKind step_kind;
  std::optional<StepMethod> step_method;  ///< the method of the output `step`; none: rk4, dopri5
  std::unique_ptr<Stepper> (*make_stepper)(SimulatedSystem& system, const StepRule& rule);
};

/// The methods that `--method` accepts.
[[nodiscard]] std::span<const MethodRow> method_table();

[[nodiscard]] std::unique_ptr<Stepper> make_rk4(SimulatedSystem& system, const StepRule& rule);
[[nodiscard]] std::unique_ptr<Stepper> make_dopri5(SimulatedSystem& system, const StepRule& rule);
[[nodiscard]] std::unique_ptr<Stepper> make_step_program(SimulatedSystem& system,
                                                         const StepRule& rule);

/// The row of options.method. E620 for an unknown method, with a suggestion; E647 for an unknown
/// order.
[[nodiscard]] Result<MethodRow> find_method(const SimulationOptions& options);

/// The rule for the steps of a run. E621 if a number is not positive and finite, if options
/// contradict each other, or if the method or an option needs a step, and `options` has none.
[[nodiscard]] Result<StepRule> step_rule(const MethodRow& method, const SimulationOptions& options);

}  // namespace elgen
