// The methods of `step` (step_methods.def), which are straight-line code: explicit ones, and
// implicit ones of a fixed number of iterations.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace elgen {

enum class StepMethod : std::uint8_t {
#define ELGEN_STEP_METHOD(name, domain, iterations, doc, equation) name,
#include "elgen/step_methods.def"
#undef ELGEN_STEP_METHOD
};

enum class StepDomain : std::uint8_t { any, separable, quadratic };

/// More do not pay: where 20 are not enough, the step is too long.
inline constexpr std::uint32_t most_step_iterations = 20;

struct StepMethodRow {
  StepMethod id;
  std::string_view name;
  StepDomain domain;
  std::uint32_t iterations;  ///< 0: explicit
  std::string_view doc;
  std::string_view equation;
};

/// step_methods.def
inline constexpr std::array step_methods{
#define ELGEN_STEP_METHOD(name, domain, iterations, doc, equation) \
  StepMethodRow{StepMethod::name, #name, StepDomain::domain, iterations, doc, equation},
#include "elgen/step_methods.def"
#undef ELGEN_STEP_METHOD
};

}  // namespace elgen
