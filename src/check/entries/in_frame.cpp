// Positions, inertias and twists that entries state in the axes of a frame.
#include "check/entries/in_frame.hpp"

#include <algorithm>
#include <utility>

namespace elgen {
namespace {

/// I_com = I_origin - m (c.c 1 - c c^T); entries xx yy zz xy xz yz; in a plane only zz.
std::vector<ExpressionId> inertia_about_com(NodeBuilder& nodes, const LocalBody& body,
                                            ExpressionId mass) {
  const Vector3& c = body.com.position;
  const auto moment_about_com = [&](ExpressionId inertia, std::size_t i, std::size_t j) {
    ExpressionId moment = no_expression;
    if (i == j) {
      const ExpressionId u = nodes.multiply({mass, c[(i + 1) % 3], c[(i + 1) % 3]});
      const ExpressionId w = nodes.multiply({mass, c[(i + 2) % 3], c[(i + 2) % 3]});
      moment = nodes.add({u, w});
      return nodes.subtract(inertia, moment);
    }
    moment = nodes.multiply({mass, c[i], c[j]});
    return nodes.add({inertia, moment});
  };
  if (body.inertia.size() == 1) return {moment_about_com(body.inertia[0], 2, 2)};
  constexpr std::array<std::array<std::size_t, 2>, 6> places{
      {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};
  std::vector<ExpressionId> result;
  for (std::size_t k = 0; k < body.inertia.size(); ++k) {
    result.push_back(moment_about_com(body.inertia[k], places[k][0], places[k][1]));
  }
  return result;
}

}  // namespace

Vector3 world_position(NodeBuilder& nodes, const PointInFrame& place) {
  const Matrix3 rotation = frame_rotation_matrix(nodes, place.frame);
  const Vector3 offset = nodes.apply(rotation, place.position);
  const Vector3 origin = frame_vector(nodes, place.frame, frame_origin);
  return nodes.add(origin, offset);
}

void set_world_pose(Context& context, LocalBody local, Body& body) {
  NodeBuilder nodes(context, body.span);
  body.com = world_position(nodes, local.com);
  if (local.is_about_origin && body.mass)
    body.inertia = inertia_about_com(nodes, local, *body.mass);
  const bool is_planar = body.dimension == 2;
  const Vector3& spin = context.model.frames[local.com.frame].spin;
  body.spin = is_planar ? std::vector{spin[2]} : std::vector(spin.begin(), spin.end());
  if (body.inertia.empty()) body.spin.clear();
  body.local = std::move(local);
}

void set_frame_output(Context& context, UserOutput& output) {
  const std::uint32_t frame = *output.frame;
  NodeBuilder nodes(context, output.span);
  const Matrix3 rotation = frame_rotation_matrix(nodes, frame);
  const Vector3 origin = frame_vector(nodes, frame, frame_origin);
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      output.values.push_back(rotation[3 * row + column]);
    }
    output.values.push_back(origin[row]);
  }
  Vector3 angular = context.model.frames[frame].spin;
  Vector3 linear{};
  for (std::size_t k = 0; k < 3; ++k) linear[k] = nodes.rate(origin[k]);
  if (output.is_in_world) {
    angular = nodes.apply(rotation, angular);
  } else {
    linear = nodes.apply_transposed(rotation, linear);
  }
  output.twist.assign(angular.begin(), angular.end());
  output.twist.insert(output.twist.end(), linear.begin(), linear.end());
}

Vector3 pad_to_three(const std::vector<ExpressionId>& components) {
  Vector3 result{no_expression, no_expression, no_expression};
  std::copy_n(components.begin(), std::min(components.size(), result.size()), result.begin());
  return result;
}

}  // namespace elgen
