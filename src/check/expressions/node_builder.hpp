// NodeBuilder: appends the nodes that check itself generates, such as the pose of a frame.
#pragma once

#include <cln/rational.h>

#include <array>
#include <optional>
#include <vector>

#include "check/names/context.hpp"

namespace elgen {

using Matrix3 = std::array<ExpressionId, 9>;  ///< row-major

/// Appends nodes, all with one span. Zeros, ones and exact constants are folded, so that vanishing
/// terms never enter the arena. Sines and cosines of multiples of pi/2 are exact.
class NodeBuilder {
 public:
  NodeBuilder(Context& context, const Span& span) : context_(context), span_(span) {}

  ExpressionId number(const cln::cl_RA& value);
  ExpressionId leaf(Opcode kind, std::uint32_t index);
  ExpressionId name_node(NamedKind kind, std::uint32_t index, std::uint32_t component);
  ExpressionId negate(ExpressionId a);
  ExpressionId add(const std::vector<ExpressionId>& terms);
  ExpressionId subtract(ExpressionId a, ExpressionId b);
  ExpressionId multiply(const std::vector<ExpressionId>& factors);
  ExpressionId divide(ExpressionId a, ExpressionId b);
  ExpressionId power(ExpressionId base, const cln::cl_RA& exponent);
  ExpressionId call(FunctionId function, ExpressionId argument);
  ExpressionId stumpff(ExpressionId argument, int order);
  ExpressionId rate(ExpressionId a);

  ExpressionId dot(const Vector3& a, const Vector3& b);
  Vector3 add(const Vector3& a, const Vector3& b);
  Vector3 apply(const Matrix3& m, const Vector3& x);
  Vector3 apply_transposed(const Matrix3& m, const Vector3& x);
  Matrix3 multiply(const Matrix3& a, const Matrix3& b);
  Matrix3 identity();

  [[nodiscard]] bool is_one(ExpressionId id) const { return is_number(id, 1); }

 private:
  [[nodiscard]] bool is_number(ExpressionId id, int value) const;
  ExpressionId push(Expression node);

  Context& context_;
  Span span_;
};

/// Nodes that refer by name to the rotation matrix of a frame (frame_rotation_matrix), or to three
/// components of the frame from `first` on (frame_vector).
[[nodiscard]] Matrix3 frame_rotation_matrix(NodeBuilder& nodes, std::uint32_t frame);
[[nodiscard]] Vector3 frame_vector(NodeBuilder& nodes, std::uint32_t frame, FrameComponent first);

/// R_to^T R_from x: the vector x, converted from the axes of `from` to the axes of `to` (none:
/// world axes).
[[nodiscard]] Vector3 change_axes(NodeBuilder& nodes, const Vector3& x,
                                  std::optional<std::uint32_t> from,
                                  std::optional<std::uint32_t> to);

}  // namespace elgen
