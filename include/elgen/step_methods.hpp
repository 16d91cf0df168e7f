// The methods of `step` (step_methods.def) as straight-line code: explicit methods, implicit
// methods with a fixed number of iterations, and compositions of symmetric methods.
//
//     Phi_h of order 2, Phi_{-h} its inverse   ->   Phi_{g_s h} ... Phi_{g_1 h},   g_i = g_{s+1-i}
//
// The composition has order 4 if sum g_i = 1 and sum g_i^3 = 0, and order 8 under six further
// conditions.
// Hairer, Lubich, Wanner, Geometric Numerical Integration, 2nd ed., sec. V.3.2.
#pragma once

#include <cln/rational.h>

#include <array>
#include <compare>
#include <cstddef>
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

/// The most iterations of an implicit step. A step that has not converged after 20 iterations needs
/// a shorter h, not more iterations.
inline constexpr std::uint32_t max_step_iterations = 20;

/// Up to so many velocities, derivatives of steps and interpreted languages write out every column.
/// For more velocities, derivatives of a step call the parts of derivatives of accelerations
/// (elgen/compose.hpp), and interpreted languages loop over columns: straight-line code would have
/// megabytes.
inline constexpr std::size_t max_unrolled_velocities = 10;

/// The most velocities of derivatives of a step. The program lists every repetition: for 40
/// velocities and inputs, 3.5 million instructions by rk4; by verlet of order 8 up to 20 times as
/// many.
inline constexpr std::size_t max_step_velocities = 40;

struct StepMethodRow {
  StepMethod id;
  std::string_view name;
  StepDomain domain;
  std::uint32_t order;       ///< order of the method without composition
  std::uint32_t iterations;  ///< default number of iterations; 0: explicit method
  std::string_view doc;
  std::string_view equation;
};

inline constexpr std::array step_methods{
#define ELGEN_STEP_METHOD(name, domain, order, iterations, doc, equation) \
  StepMethodRow{StepMethod::name, #name, StepDomain::domain, order, iterations, doc, equation},
#include "elgen/step_methods.def"
#undef ELGEN_STEP_METHOD
};

[[nodiscard]] constexpr const StepMethodRow& step_method_row(StepMethod method) {
  return step_methods[static_cast<std::size_t>(method)];
}

/// The method and options of a `step`.
struct StepSpec {
  StepMethod method = {};
  std::uint32_t composed_order = 0;  ///< order of the composition; 0: not composed
  std::uint32_t iterations = 0;      ///< number of iterations; 0: explicit method
  bool projects = false;  ///< true: the step ends with one Newton step onto the constraints
  friend auto operator<=>(const StepSpec&, const StepSpec&) = default;
};

/// The step by `method` with the default number of iterations.
[[nodiscard]] constexpr StepSpec default_step(StepMethod method, std::uint32_t composed_order = 0) {
  return {method, composed_order, step_method_row(method).iterations};
}

/// The order of the step, with or without composition.
[[nodiscard]] constexpr std::uint32_t step_order(const StepSpec& step) {
  return step.composed_order > 0 ? step.composed_order : step_method_row(step.method).order;
}

/// The orders that a method of order `own` has with and without composition: 2, 4, 8 for `own` = 2.
[[nodiscard]] std::vector<std::uint32_t> step_orders(std::uint32_t own);

/// The coefficients g_1 ... g_s of the composition with the order `composed_order`: 4 by Suzuki
/// (1/9 of the error of Yoshida's composition at equal cost), 8 by Kahan and Li. In both, the
/// middle coefficient is negative and has the largest magnitude. {1} if `composed_order` is 0.
[[nodiscard]] std::vector<cln::cl_RA> composition_coefficients(std::uint32_t composed_order);

}  // namespace elgen
