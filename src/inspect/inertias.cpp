// E508: an inertia I belongs to a body iff its second moments S = 1/2 tr(I) 1 - I = integral of x
// x^T dm are positive semidefinite: each principal inertia is then at most the sum of the other
// two, and none is negative.
#include <fmt/format.h>

#include <array>

#include "checks.hpp"
#include "elgen/oracle.hpp"
#include "readable.hpp"

namespace elgen::inspection {
namespace {

using cln::cl_R;

/// xx yy zz xy xz yz
using Symmetric = std::array<cl_R, 6>;

/// Inertias are often rounded to three digits; what that can do to a thin plate is no mistake.
const cl_R& rounding_share() {
  static const cl_R share = cln::cl_RA(1) / cln::cl_RA(1000);
  return share;
}

std::optional<std::vector<cl_R>> values_of(const Subject& subject, const Body& body) {
  const State state = nominal_state(subject.model, subject.scene);
  std::vector<cl_R> values;
  for (const ExpressionId id : body.inertia) {
    const auto value = oracle_expression(subject.model, id, state);
    if (!value) return std::nullopt;
    values.push_back(*value);
  }
  return values;
}

/// S, with its diagonal raised by the rounding that is forgiven.
Symmetric second_moments(const std::vector<cl_R>& inertia) {
  const cl_R trace = inertia[0] + inertia[1] + inertia[2];
  const cl_R half = trace / 2 + cln::abs(trace) * rounding_share();
  return {half - inertia[0], half - inertia[1], half - inertia[2],
          -inertia[3],       -inertia[4],       -inertia[5]};
}

/// All principal minors are at least zero.
bool is_positive_semidefinite(const Symmetric& s) {
  const auto& [xx, yy, zz, xy, xz, yz] = s;
  const cl_R determinant =
      xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
  return xx >= 0 && yy >= 0 && zz >= 0 && xx * yy >= xy * xy && xx * zz >= xz * xz &&
         yy * zz >= yz * yz && determinant >= 0;
}

bool is_possible(const std::vector<cl_R>& inertia) {
  if (inertia.size() < 6) return inertia[0] >= 0;
  return is_positive_semidefinite(second_moments(inertia));
}

std::string listed(const std::vector<cl_R>& values) {
  std::string text;
  for (const cl_R& value : values) text += (text.empty() ? "" : ", ") + readable(value);
  return text;
}

}  // namespace

Diagnostics inspect_inertias(const Subject& subject) {
  Diagnostics diagnostics;
  for (const Body& body : subject.model.bodies) {
    if (body.inertia.empty()) continue;
    const auto inertia = values_of(subject, body);
    if (!inertia || is_possible(*inertia)) continue;
    diagnostics.push_back(
        {Code::E508, body.span,
         fmt::format("inertia {} of `{}` belongs to no body", listed(*inertia), body.name),
         body.inertia.size() < 6 ? "it is negative"
                                 : "a principal inertia exceeds the sum of the other two"});
  }
  return diagnostics;
}

}  // namespace elgen::inspection
