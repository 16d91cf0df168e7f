// The methods of `step` (step_methods.def): explicit ones, which are straight-line code.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace elgen {

enum class StepMethod : std::uint8_t {
#define ELGEN_STEP_METHOD(name, domain, doc, equation) name,
#include "elgen/step_methods.def"
#undef ELGEN_STEP_METHOD
};

enum class StepDomain : std::uint8_t { any, separable };

struct StepMethodRow {
  StepMethod id;
  std::string_view name;
  StepDomain domain;
  std::string_view doc;
  std::string_view equation;
};

/// step_methods.def
inline constexpr std::array step_methods{
#define ELGEN_STEP_METHOD(name, domain, doc, equation) \
  StepMethodRow{StepMethod::name, #name, StepDomain::domain, doc, equation},
#include "elgen/step_methods.def"
#undef ELGEN_STEP_METHOD
};

}  // namespace elgen
