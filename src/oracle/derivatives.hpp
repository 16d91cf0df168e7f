// Derivatives of the dynamics: slopes of w.(M a + bias - B u) along displacements, and for forward
// dynamics a solve with M.
#pragma once

#include "elgen/outputs.hpp"
#include "mechanics.hpp"

namespace elgen::oracle {

/// Of what differentiates the equations of motion: all entries, one field after another.
[[nodiscard]] std::vector<cln::cl_R> derivative_values(OutputKind kind, Mechanics& at);

/// w.X y of one field.
[[nodiscard]] cln::cl_R contracted_derivative(OutputKind kind, Mechanics& at,
                                              const Contraction& by);

}  // namespace elgen::oracle
