// Expression: one node of the expression arena of a Model. Operands are indices of earlier nodes,
// so that common subexpressions are shared.
#pragma once

#include <cln/rational.h>

#include <cstdint>
#include <vector>

#include "elgen/functions.hpp"
#include "elgen/opcodes.hpp"
#include "elgen/source_text.hpp"

namespace elgen {

using ExpressionId = std::uint32_t;

enum class ExpressionKind : std::uint8_t {
  number,  ///< the value of member `number`
  pi,
  leaf,      ///< leaf `index` of the kind in member `leaf`; for an open value, the operands are the
             ///< arguments of its function
  named,     ///< the value of entry `index` of the NamedKind in member `named`
  negate,    ///< -operands[0]
  add,       ///< sum of all operands
  multiply,  ///< product of all operands
  divide,    ///< operands[0] / operands[1]
  power,     ///< operands[0] ^ number, rational exponent; sqrt is the power 1/2
  function,  ///< function(operands…)
  time_derivative,  ///< d/dt operands[0] along the motion: q -> v, v -> a, t -> 1
};

/// The kinds of entries to which an expression refers by name. `component` (Expression::component)
/// selects one number of a point, body or frame.
enum class NamedKind : std::uint8_t {
  prescribed,  ///< prescribed[index].value, a function of t
  definition,  ///< definitions[index].value
  point,       ///< points[index].position[component]
  body,        ///< bodies[index].com[component]
  frame,       ///< a number of frames[index], see FrameComponent
};

/// Values of Expression::component for a frame: the index of the first number of each vector or
/// matrix among the 18 numbers of the frame.
enum FrameComponent : std::uint32_t {
  frame_rotation = 0,  ///< Frame::rotation, row-major
  frame_origin = 9,
  frame_angular_velocity = 12,
  frame_recursive_spin = 15,  ///< Frame::recursive_spin
  components_per_frame = 18,
};

struct Expression {
  ExpressionKind kind = ExpressionKind::number;
  Opcode leaf = Opcode::parameter;  ///< kind of the leaf (leaves.def), if `kind` is `leaf`
  FunctionId function = FunctionId::sin;
  NamedKind named = NamedKind::definition;
  std::uint32_t index = 0;      ///< number of the leaf among its kind, or index of the named entry
  std::uint32_t component = 0;  ///< number of the component of a point, a body or a frame
  cln::cl_RA number = 0;
  std::vector<ExpressionId> operands = {};
  Span span = {};
};

[[nodiscard]] inline bool is_leaf(const Expression& expression, Opcode kind) {
  return expression.kind == ExpressionKind::leaf && expression.leaf == kind;
}

/// True if the expression refers to a named entry of this kind.
[[nodiscard]] inline bool refers_to_entry(const Expression& expression, NamedKind kind) {
  return expression.kind == ExpressionKind::named && expression.named == kind;
}

}  // namespace elgen
