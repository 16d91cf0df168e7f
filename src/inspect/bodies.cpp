// E508: an inertia that no rigid body has; a planar inertia must not be negative. E507: a planar
// angular velocity w = s(q, t).v + s0(q, t) that is not the time derivative of a function of q, t.
//
// w is a total time derivative if and only if its Euler-Lagrange expression
//
//     d/dt dw/dv_i - dw/dq_i = sum_j (ds_i/dq_j - ds_j/dq_i) v_j + ds_i/dt - ds0/dq_i
//
// vanishes identically. The oracle evaluates this expression as the equation of motion of L = w.
#include <fmt/format.h>

#include "elgen/inertia.hpp"
#include "elgen/oracle.hpp"
#include "inspect/checks.hpp"
#include "inspect/readable.hpp"
#include "inspect/samples.hpp"
#include "numbers/exact_number.hpp"

namespace elgen {
namespace {

using cln::cl_R;

std::optional<std::vector<cl_R>> inertia_values(const InspectedModel& subject, const Body& body) {
  const State state = nominal_state(subject.model, subject.scene);
  std::vector<cl_R> values;
  for (const ExpressionId id : body.inertia) {
    const auto value = oracle_expression_value(subject.model, id, state);
    if (!value) return std::nullopt;
    values.push_back(*value);
  }
  return values;
}

bool is_possible_inertia(const std::vector<cl_R>& inertia) {
  if (inertia.size() < 6) return inertia[0] >= 0;
  return is_physical_inertia(
      {inertia[0], inertia[1], inertia[2], inertia[3], inertia[4], inertia[5]});
}

std::string comma_list(const std::vector<cl_R>& values) {
  std::string text;
  for (const cl_R& value : values) text += (text.empty() ? "" : ", ") + exact_number_text(value);
  return text;
}

Model with_lagrangian(const Model& model, ExpressionId lagrangian) {
  Model bare;
  bare.expressions = model.expressions;
  bare.definitions = model.definitions;
  bare.prescribed = model.prescribed;
  bare.coordinates = model.coordinates;
  bare.velocities = model.velocities;
  bare.rotations = model.rotations;
  for (Coordinate& coordinate : bare.coordinates) coordinate.armature.reset();
  bare.frames = model.frames;
  bare.points = model.points;
  for (Point& point : bare.points) point.mass.reset();
  bare.energies.L = lagrangian;
  return bare;
}

/// True if x is only the rounding error of cancelling terms of magnitude `scale`.
bool vanishes(const cl_R& x, const cl_R& scale) {
  return cln::abs(x) <= (1 + cln::abs(scale)) * power_of_ten(-50);
}

/// True if the Euler-Lagrange expression is not zero at a sampled state.
bool has_curl(const InspectedModel& subject, ExpressionId spin) {
  const Model bare = with_lagrangian(subject.model, spin);
  for (unsigned seed = 0; seed < zero_sample_count; ++seed) {
    const State state = sample_state(subject, seed);
    const std::vector<cl_R> direction = sample_state(subject, seed + zero_sample_count).v;
    const auto curl =
        oracle_contraction(bare, {.kind = OutputKind::inverse_dynamics}, state, {direction});
    const auto value = oracle_expression_value(bare, spin, state);
    if (curl && value && !vanishes(*curl, *value)) return true;
  }
  return false;
}

}  // namespace

Diagnostics inspect_inertias(const InspectedModel& subject) {
  Diagnostics diagnostics;
  for (const Body& body : subject.model.bodies) {
    if (body.inertia.empty()) continue;
    const auto inertia = inertia_values(subject, body);
    if (!inertia || is_possible_inertia(*inertia)) continue;
    diagnostics.push_back(
        {Code::E508, body.span,
         fmt::format("inertia {} of `{}` belongs to no body", comma_list(*inertia), body.name),
         body.inertia.size() < 6 ? "it is negative"
                                 : "a principal inertia exceeds the sum of the other two"});
  }
  return diagnostics;
}

Diagnostics inspect_spins(const InspectedModel& subject) {
  if (subject.model.velocities.size() > most_coordinates_sampled) return {};
  Diagnostics diagnostics;
  for (const Body& body : subject.model.bodies) {
    if (body.dimension != 2 || body.spin.empty()) continue;
    if (!has_curl(subject, body.spin.back())) continue;
    diagnostics.push_back({Code::E507, body.span,
                           fmt::format("spin of `{}` is the rate of no angle", body.name),
                           "write the rate of an angle, or the term in `[energy] T`"});
  }
  return diagnostics;
}

}  // namespace elgen
