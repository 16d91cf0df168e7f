// The table of methods (methods.def).
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

#include "simulate/steps/stepper.hpp"

namespace elgen {

/// One of the two: the length of steps, or the error they are chosen by.
struct StepRule {
  std::optional<double> step = {};
  double tolerance = 0;
};

enum class StepKind : std::uint8_t { fixed, adapted };

enum class MethodDomain : std::uint8_t { any, unturned, separable };

struct MethodRow {
  std::string_view name;
  StepKind step;
  MethodDomain domain;
  std::unique_ptr<Stepper> (*make)(System& system, const StepRule& rule);
};

[[nodiscard]] std::span<const MethodRow> method_table();

#define ELGEN_METHOD(name, step, domain) \
  [[nodiscard]] std::unique_ptr<Stepper> make_##name(System& system, const StepRule& rule);
#include "simulate/steps/methods.def"
#undef ELGEN_METHOD

}  // namespace elgen
