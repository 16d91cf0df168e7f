// The table of methods.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "elgen/step_methods.hpp"
#include "simulate/steps/stepper.hpp"

namespace elgen {

/// One of the two: the length of steps, or the error they are chosen by.
struct StepRule {
  std::optional<double> step = {};
  double tolerance = 0;
};

/// Of one length, or adapted to a tolerance unless a length is given.
enum class StepKind : std::uint8_t { fixed, adapted };

struct MethodRow {
  std::string_view name;
  StepKind step;
  std::optional<StepMethod> program;  ///< the `step` that it runs; none: it calls accelerations
  std::unique_ptr<Stepper> (*make)(System& system, const StepRule& rule);
};

/// Those that are offered, in their order.
[[nodiscard]] std::span<const MethodRow> method_table();

/// The one that errors of the others are measured from.
[[nodiscard]] const MethodRow& reference_method();

[[nodiscard]] std::unique_ptr<Stepper> make_rk4(System& system, const StepRule& rule);
[[nodiscard]] std::unique_ptr<Stepper> make_dopri5(System& system, const StepRule& rule);
[[nodiscard]] std::unique_ptr<Stepper> make_fehlberg78(System& system, const StepRule& rule);
[[nodiscard]] std::unique_ptr<Stepper> make_step_program(System& system, const StepRule& rule);

}  // namespace elgen
