// Inertia tensors, and a test for tensors that no rigid body can have.
#pragma once

#include <cln/real.h>

#include <array>

namespace elgen {

/// The entries xx yy zz xy xz yz of I about the centre of mass; I_xy = -(integral of x y dm).
using InertiaTensor = std::array<cln::cl_R, 6>;

/// True if a rigid body can have this inertia I, that is, if its second moments
///
///     S = 1/2 tr(I) E - I = integral of x x^T dm,   E the unit matrix
///
/// are positive semidefinite. Each principal inertia is then non-negative and at most the sum of
/// the other two. The diagonal of S is first raised by 1/1000 of the trace, because the inertia of
/// a thin plate, rounded to three digits, may violate the condition.
[[nodiscard]] bool is_physical_inertia(const InertiaTensor& inertia);

}  // namespace elgen
