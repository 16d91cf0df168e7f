// E512: a mass that is pushed up. [gravity] along the last axis pulls up where that axis is drawn
// upwards, as most models do; and where the written V uses a point's height, V must not fall
// steadily as a point with a mass rises.
//
// `Up` is against [gravity], else along the last component of the points. The point is raised by a
// coordinate of its own, and dV/d(height) is sampled: negative and the same everywhere is a weight
// with the wrong sign.
#include <fmt/format.h>

#include <algorithm>

#include "elgen/references.hpp"
#include "inspect/checks.hpp"
#include "inspect/samples.hpp"
#include "numbers/exact_number.hpp"

namespace elgen {
namespace {

using cln::cl_R;
using Direction = std::array<cl_R, 3>;

/// The points whose components an expression refers to, directly or through names.
std::vector<std::uint32_t> points_in(const Model& model, ExpressionId root) {
  std::vector<std::uint32_t> points;
  for (const ExpressionId id : reached(model, {root})) {
    const Expression& e = model.expressions[id];
    if (e.kind == ExpressionKind::point_component) points.push_back(e.index / 3);
  }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

/// Against gravity, or the last axis of the point.
std::optional<Direction> upward(const Inspected& subject, const Point& point) {
  Direction up{0, 0, 0};
  if (!subject.model.gravity) {
    up[point.dimension - 1] = 1;
    return up;
  }
  const State state = nominal_state(subject.model, subject.scene);
  for (std::size_t c = 0; c < 3; ++c) {
    const auto component = oracle_expression(subject.model, (*subject.model.gravity)[c], state);
    if (!component) return std::nullopt;
    up[c] = -*component;
  }
  return up;
}

ExpressionId append(Model& model, Expression expression) {
  model.expressions.push_back(std::move(expression));
  return static_cast<ExpressionId>(model.expressions.size() - 1);
}

ExpressionId node(Model& model, ExpressionKind kind, std::vector<ExpressionId> operands) {
  return append(model, {.kind = kind, .operands = std::move(operands)});
}

ExpressionId number(Model& model, const cl_R& value) {
  return append(model, {.number = cln::rational(value)});
}

/// The model with one more coordinate that moves the point along `up`.
Model liftable(const Model& model, std::uint32_t point, const Direction& up) {
  Model result = model;
  const std::uint32_t coordinate = append_coordinate(result, {});
  const ExpressionId lift = append(
      result, {.kind = ExpressionKind::leaf, .leaf = Opcode::coordinate, .index = coordinate});
  for (std::size_t c = 0; c < 3; ++c) {
    if (cln::zerop(up[c])) continue;
    const ExpressionId scale = number(result, up[c]);
    const ExpressionId shift = node(result, ExpressionKind::multiply, {scale, lift});
    ExpressionId& at = result.points[point].at[c];
    at = node(result, ExpressionKind::add, {at, shift});
  }
  return result;
}

/// dV/d(lift) at a sampled state, all else at rest.
std::optional<cl_R> slope(const Model& liftable, ExpressionId potential, State state) {
  state.v.assign(liftable.velocities.size(), cl_R(0));
  state.a = state.v;
  state.q.emplace_back(0);
  const auto at_rest = oracle_rate(liftable, potential, state);
  state.v.back() = 1;
  const auto rising = oracle_rate(liftable, potential, state);
  if (!at_rest || !rising) return std::nullopt;
  return *rising - *at_rest;
}

bool has_mass(const Model& model, std::uint32_t point) {
  if (model.points[point].mass) return true;
  if (!model.energies.T) return false;
  const std::vector<std::uint32_t> moving = points_in(model, *model.energies.T);
  return std::find(moving.begin(), moving.end(), point) != moving.end();
}

bool falls_steadily(const Inspected& subject, std::uint32_t point, const Direction& up) {
  const Model lifted = liftable(subject.model, point, up);
  std::optional<cl_R> first;
  for (unsigned seed = 0; seed < zero_samples; ++seed) {
    const auto here = slope(lifted, *subject.model.energies.V, sampled_state(subject, seed));
    if (!here || *here >= 0) return false;
    if (!first) first = here;
    // Equal to 50 digits: what a weight does and a spring does not.
    if (cln::abs(*here - *first) > -*first * power_of_ten(-50)) return false;
  }
  return true;
}

/// 2 or 3; 0 where nothing has a place.
std::uint32_t dimension_of(const Model& model) {
  if (!model.points.empty()) return model.points.front().dimension;
  return model.bodies.empty() ? 0 : model.bodies.front().dimension;
}

/// "y" or "z": the last axis of points and bodies, which most models draw upwards.
Diagnostics gravity_along_last_axis(const Inspected& subject) {
  const Model& model = subject.model;
  const std::uint32_t dimension = dimension_of(model);
  if (!model.gravity || dimension == 0) return {};
  const std::uint32_t last = dimension - 1;
  const State state = nominal_state(model, subject.scene);
  const auto component = oracle_expression(model, (*model.gravity)[last], state);
  if (!component || *component <= 0) return {};
  return {{Code::E512, model.expressions[(*model.gravity)[last]].span,
           fmt::format("gravity pulls along +{}", last == 1 ? "y" : "z"),
           "a weight that pulls down is negative where the axis points up: sign mistake?"}};
}

}  // namespace

Diagnostics inspect_potential(const Inspected& subject) {
  const Model& model = subject.model;
  Diagnostics diagnostics = gravity_along_last_axis(subject);
  if (!model.energies.V || model.velocities.size() > most_coordinates_sampled) {
    return diagnostics;
  }
  for (const std::uint32_t index : points_in(model, *model.energies.V)) {
    const Point& point = model.points[index];
    const auto up = has_mass(model, index) ? upward(subject, point) : std::nullopt;
    if (!up || !falls_steadily(subject, index, *up)) continue;
    diagnostics.push_back({Code::E512, model.expressions[*model.energies.V].span,
                           fmt::format("V falls as `{}` rises", point.name),
                           "a weight is `m*g*height`: sign mistake?"});
  }
  return diagnostics;
}

}  // namespace elgen
