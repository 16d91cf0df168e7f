// inertia: the matrix of second moments is positive semidefinite if all its principal minors are at
// least zero. The tolerance is 0.1 % of the trace, for rounded inertias.
#include "elgen/inertia.hpp"

#include <cln/rational.h>

namespace elgen {

namespace {

using cln::cl_R;

InertiaTensor second_moments(const InertiaTensor& inertia) {
  const cl_R rounding_share = cln::cl_RA(1) / cln::cl_RA(1000);
  const cl_R trace = inertia[0] + inertia[1] + inertia[2];
  const cl_R half = trace / 2 + cln::abs(trace) * rounding_share;
  return {half - inertia[0], half - inertia[1], half - inertia[2],
          -inertia[3],       -inertia[4],       -inertia[5]};
}

}  // namespace

bool is_physical_inertia(const InertiaTensor& inertia) {
  const auto& [xx, yy, zz, xy, xz, yz] = second_moments(inertia);
  const cl_R determinant =
      xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
  return xx >= 0 && yy >= 0 && zz >= 0 && xx * yy >= xy * xy && xx * zz >= xz * xz &&
         yy * zz >= yz * yz && determinant >= 0;
}

}  // namespace elgen
