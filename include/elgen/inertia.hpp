// Inertia tensors that some rigid body has.
#pragma once

#include <cln/real.h>

#include <array>

namespace elgen {

/// xx yy zz xy xz yz, about the centre of mass
using InertiaTensor = std::array<cln::cl_R, 6>;

/// An inertia I belongs to a body iff its second moments S = 1/2 tr(I) 1 - I = integral of x x^T dm
/// are positive semidefinite: each principal inertia is then at most the sum of the other two, and
/// none is negative. A thousandth of the trace is forgiven on S's diagonal: inertias are often
/// rounded to three digits, and what that can do to a thin plate is no mistake.
[[nodiscard]] bool is_of_a_body(const InertiaTensor& inertia);

}  // namespace elgen
