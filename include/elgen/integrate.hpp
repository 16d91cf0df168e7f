// integrate: the output `step`, one step of an integration method, as straight-line code. The
// instructions of each output that the step calls are copied, in the chosen form of the output.
//
//     x' = f(x, u, t), x = (q, v)     ->     x(t + h), u held
//
//     rk4       x + h/6 (k1 + 2 k2 + 2 k3 + k4),   k1 = f(x, t),   k2 = f(x + h/2 k1, t + h/2),
//               k3 = f(x + h/2 k2, t + h/2),   k4 = f(x + h k3, t + h)
//     verlet    v += h/2 a(q, t),   q += h v,   v += h/2 a(q, t + h)
//     midpoint  M w = p + h/2 dp/dt - b at (q + h/2 w, w, t + h/2), iterated from w = v,
//               q += h w,   p += h dp/dt;   p = dL/dv = M v + b,   dp/dt = dL/dq + F
//
// If the step projects (StepSpec), it ends with the output `projected` at t + h: one Newton step
// back to the constraints. Quaternions are normalised whenever they change, so f is evaluated only
// at unit quaternions. Normalising keeps the order of the method, because f is tangent to the unit
// sphere. Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, 2nd ed., sec. II.1;
// Hairer, Lubich, Wanner, Geometric Numerical Integration, 2nd ed., sec. I.1.4 and VIII.6.
#pragma once

#include <string>
#include <vector>

#include "elgen/diagnostic.hpp"
#include "elgen/program.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// The outputs that a step calls, and the outputs from which elgen decides whether the method
/// applies (M, p and bias if the system must be separable). midpoint calls the fields of
/// `dynamics`, because they share common subexpressions.
[[nodiscard]] std::vector<OutputRequest> outputs_for_step(const Model& model,
                                                          const OutputRequest& step);

/// The output whose parts (elgen/compose.hpp) a step calls, because the parts give the
/// accelerations and their derivatives together; none if the step calls only outputs.
[[nodiscard]] std::vector<OutputRequest> parts_for_step(const Model& model,
                                                        const OutputRequest& step);

/// The functions that a step calls.
struct StepCallees {
  Program outputs = {};             ///< of outputs_for_step(), in chosen forms
  Program acceleration_parts = {};  ///< of parts_for_step(), as the stage cancel returns them
};

/// The reason why verlet is not symplectic or not explicit for this system; "" if verlet is
/// symplectic and explicit. The decision depends on the leaves that the instructions of
/// mass_matrix, momentum and bias load; `program` must contain these outputs. The model must not
/// have rotations (E622).
[[nodiscard]] std::string nonseparable_reason(const CheckedModel& checked, const Program& program);

/// Appends the function of the request `step` to `program`. E622: the method does not apply to the
/// system.
[[nodiscard]] Diagnostics add_step(const CheckedModel& checked, const OutputRequest& step,
                                   const StepCallees& calls, Program& program);

}  // namespace elgen
