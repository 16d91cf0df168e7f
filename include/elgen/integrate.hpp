// integrate: the output `step`, one step of a method, as straight-line code: the chosen forms of
// what the method calls, one copy for every call.
//
//     x' = f(x, u, t), x = (q, v)     ->     x(t + h), u held
//
//     rk4       x + h/6 (k1 + 2 k2 + 2 k3 + k4),   k1 = f(x, t),   k2 = f(x + h/2 k1, t + h/2),
//               k3 = f(x + h/2 k2, t + h/2),   k4 = f(x + h k3, t + h)
//     verlet    v += h/2 a(q, t),   q += h v,   v += h/2 a(q, t + h)
//     midpoint  M w = p + h/2 dp/dt - b at (q + h/2 w, w, t + h/2), iterated from w = v,
//               q += h w,   p += h dp/dt;   p = dL/dv = M v + b,   dp/dt = dL/dq + F
//
// With `projected` one step of Newton back to the constraints follows, at t + h: a call of that
// output. Quaternions are divided by their length wherever they were moved, so that f is asked for
// at rotations alone: the same order, since f has no part along them. Hairer, Norsett, Wanner,
// Solving Ordinary Differential Equations I, 2nd ed., sec. II.1; Hairer, Lubich, Wanner, Geometric
// Numerical Integration, 2nd ed., sec. I.1.4 and VIII.6.
#pragma once

#include <string>
#include <vector>

#include "elgen/diagnostic.hpp"
#include "elgen/program.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// The outputs that a step calls, and those it is judged by (M, p and bias if it has to be
/// separable). Those that midpoint calls are fields of one `dynamics`, which share what they
/// compute.
[[nodiscard]] std::vector<OutputRequest> needed_for_step(const Model& model,
                                                         const OutputRequest& step);

/// The reason why kick, drift, kick is not symplectic or explicit; "" where there is none. There
/// are no rotations (E622 of the scene). `program` has mass_matrix, momentum and bias: what these
/// do not depend on they do not read.
[[nodiscard]] std::string not_separable(const CheckedModel& checked, const Program& program);

/// Appends the function of the request to `program`. `calls`: what needed_for_step says, in chosen
/// forms. E622 where the method is not for the system.
[[nodiscard]] Diagnostics add_step(const CheckedModel& checked, const OutputRequest& step,
                                   const Program& calls, Program& program);

}  // namespace elgen
