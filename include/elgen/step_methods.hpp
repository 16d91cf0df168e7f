// The methods of `step` (step_methods.def), which are straight-line code: explicit ones, and
// implicit ones of a fixed number of iterations; and compositions of those that are symmetric.
//
//     Phi_h of order 2, Phi_{-h} its inverse   ->   Phi_{g_s h} ... Phi_{g_1 h},   g_i = g_{s+1-i}
//
// is of order 4 where sum g_i = 1 and sum g_i^3 = 0, of order 8 by six conditions more. Hairer,
// Lubich, Wanner, Geometric Numerical Integration, 2nd ed., sec. V.3.2.
#pragma once

#include <cln/rational.h>

#include <array>
#include <compare>
#include <cstdint>
#include <string_view>
#include <vector>

namespace elgen {

enum class StepMethod : std::uint8_t {
#define ELGEN_STEP_METHOD(name, domain, order, iterations, doc, equation) name,
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
  std::uint32_t order;       ///< without composition
  std::uint32_t iterations;  ///< 0: explicit
  std::string_view doc;
  std::string_view equation;
};

/// step_methods.def
inline constexpr std::array step_methods{
#define ELGEN_STEP_METHOD(name, domain, order, iterations, doc, equation) \
  StepMethodRow{StepMethod::name, #name, StepDomain::domain, order, iterations, doc, equation},
#include "elgen/step_methods.def"
#undef ELGEN_STEP_METHOD
};

[[nodiscard]] constexpr const StepMethodRow& step_row(StepMethod method) {
  return step_methods[static_cast<std::size_t>(method)];
}

/// How a `step` is made.
struct StepSpec {
  StepMethod method = {};
  std::uint32_t composed_order = 0;  ///< 0: not composed
  std::uint32_t iterations = 0;      ///< 0: explicit
  bool projects = false;             ///< back onto the constraints behind it
  friend auto operator<=>(const StepSpec&, const StepSpec&) = default;
};

/// A method with the iterations that it has where nobody says another number.
[[nodiscard]] constexpr StepSpec step_by(StepMethod method, std::uint32_t composed_order = 0) {
  return {method, composed_order, step_row(method).iterations};
}

/// The order of the method, composed or not.
[[nodiscard]] constexpr std::uint32_t step_order(const StepSpec& step) {
  return step.composed_order > 0 ? step.composed_order : step_row(step.method).order;
}

/// The orders that there are of a method that is itself of order `own`: 2 -> 2, 4, 8.
[[nodiscard]] std::vector<std::uint32_t> step_orders(std::uint32_t own);

/// g_1 ... g_s of an order that is composed, of which the middle one is the longest: of 4 Suzuki's,
/// whose errors are a ninth of those of Yoshida's for as many accelerations, of 8 Kahan and Li's.
/// 1 alone where the order is 0.
[[nodiscard]] std::vector<cln::cl_RA> step_parts(std::uint32_t composed_order);

}  // namespace elgen
