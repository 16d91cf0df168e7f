// Poses: the steps of a frame multiplied out, and the spin from the rates of the rotation.
#include "check/entries/pose.hpp"

#include "check/entries/in_frame.hpp"

namespace elgen {
namespace {

/// Rodrigues: cos 1 + sin [n]x + (1 - cos) n n^T
Matrix3 turn_matrix(NodeBuilder& nodes, const FrameStep& step) {
  const ExpressionId cosine = nodes.call(FunctionId::cos, step.angle);
  const ExpressionId sine = nodes.call(FunctionId::sin, step.angle);
  const ExpressionId one = nodes.number(1);
  const ExpressionId versine = nodes.subtract(one, cosine);
  Matrix3 result{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const bool is_unit = nodes.is_one(step.vector[i]) && i == j;
      const ExpressionId along = nodes.multiply({versine, step.vector[i], step.vector[j]});
      if (i == j) {
        result[3 * i + j] = is_unit ? one : nodes.add({cosine, along});
        continue;
      }
      const std::size_t k = 3 - i - j;
      const ExpressionId across = nodes.multiply({sine, step.vector[k]});
      const bool is_positive = (i + 2) % 3 == j;  // rows 0 1 2 have -z +y, +z -x, -y +x
      const ExpressionId signed_across = is_positive ? across : nodes.negate(across);
      result[3 * i + j] = nodes.add({along, signed_across});
    }
  }
  return result;
}

/// The homogeneous quadratic form of (w, e): (w^2 - e.e) 1 + 2 e e^T + 2 w [e]x.
Matrix3 quaternion_matrix(NodeBuilder& nodes, const std::array<ExpressionId, 4>& q,
                          bool is_scaled) {
  std::array<ExpressionId, 4> squares{};
  for (std::size_t i = 0; i < 4; ++i) squares[i] = nodes.power(q[i], 2);
  const ExpressionId length = nodes.add({squares[0], squares[1], squares[2], squares[3]});
  const ExpressionId two = nodes.number(2);
  Matrix3 result{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t k = 3 - i - j;
      ExpressionId entry = no_expression;
      if (i == j) {
        const ExpressionId others = nodes.add({squares[(i + 1) % 3 + 1], squares[(i + 2) % 3 + 1]});
        const ExpressionId own = nodes.add({squares[0], squares[i + 1]});
        entry = nodes.subtract(own, others);
      } else {
        const ExpressionId along = nodes.multiply({two, q[i + 1], q[j + 1]});
        const ExpressionId across = nodes.multiply({two, q[0], q[k + 1]});
        entry = (i + 2) % 3 == j ? nodes.add({along, across}) : nodes.subtract(along, across);
      }
      result[3 * i + j] = is_scaled ? nodes.divide(entry, length) : entry;
    }
  }
  return result;
}

/// [w]x = R^T dR/dt: w_x = sum_k R_k2 dR_k1/dt and so on round.
Vector3 spin(NodeBuilder& nodes, const Matrix3& rotation) {
  const auto column = [&](std::size_t j) {
    return Vector3{rotation[j], rotation[3 + j], rotation[6 + j]};
  };
  Vector3 result{};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3 turning = column((i + 1) % 3);
    const Vector3 rates{nodes.rate(turning[0]), nodes.rate(turning[1]), nodes.rate(turning[2])};
    result[i] = nodes.dot(column((i + 2) % 3), rates);
  }
  return result;
}

}  // namespace

void write_pose(Context& context, Frame& frame) {
  NodeBuilder nodes(context, frame.span);
  // The pose of the parent by its names, not as copies.
  Matrix3 rotation = frame.parent ? rotation_of(nodes, *frame.parent) : nodes.identity();
  Vector3 origin = frame.parent ? origin_of(nodes, *frame.parent) : Vector3{};
  for (const FrameStep& step : frame.steps) {
    if (step.kind == FrameStepKind::translation) {
      const Vector3 offset = nodes.apply(rotation, step.vector);
      origin = nodes.add(origin, offset);
    } else {
      const Matrix3 turn = step.kind == FrameStepKind::turn
                               ? turn_matrix(nodes, step)
                               : quaternion_matrix(nodes, step.quaternion, !step.rotation);
      rotation = nodes.multiply(rotation, turn);
    }
  }
  frame.rotation = rotation;
  frame.origin = origin;
  frame.spin = spin(nodes, rotation);
}

}  // namespace elgen
