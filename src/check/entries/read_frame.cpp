// Frames: their transforms from the parent as given in the file, and the pose in the world as
// expressions in the parent's pose.
//
//     x_parent = translate + R x, with R from one of
//       rotate      R1(angle1) R2(angle2) ..., each about an axis of the frame already turned
//       rpy         Rz(y) Ry(p) Rx(r)
//       dh          standard Rz(theta) Tz(d) Tx(a) Rx(alpha),
//                   modified Rx(alpha) Tx(a) Rz(theta) Tz(d)
//       quaternion  (w, x, y, z), Hamilton, frame to parent; R is divided by w^2 + x^2 + y^2 + z^2
//       rotation    the unit quaternion of a coordinate
#include <algorithm>

#include "base/reason.hpp"
#include "check/entries/entries.hpp"
#include "check/entries/in_frame.hpp"
#include "check/expressions/node_builder.hpp"
#include "check/expressions/places.hpp"
#include "check/expressions/values.hpp"
#include "check/names/context.hpp"
#include "check/names/reserved_names.hpp"

namespace elgen {
namespace {

/// Rodrigues: R = cos 1 + sin [n]x + (1 - cos) n n^T
Matrix3 turn_matrix(NodeBuilder& nodes, const ElementaryTransform& transform) {
  const ExpressionId cosine = nodes.call(FunctionId::cos, transform.angle);
  const ExpressionId sine = nodes.call(FunctionId::sin, transform.angle);
  const ExpressionId one = nodes.number(1);
  const ExpressionId versine = nodes.subtract(one, cosine);
  Matrix3 result{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const bool is_unit = nodes.is_one(transform.vector[i]) && i == j;
      const ExpressionId along =
          nodes.multiply({versine, transform.vector[i], transform.vector[j]});
      if (i == j) {
        result[3 * i + j] = is_unit ? one : nodes.add({cosine, along});
        continue;
      }
      const std::size_t k = 3 - i - j;
      const ExpressionId across = nodes.multiply({sine, transform.vector[k]});
      const bool is_positive = (i + 2) % 3 == j;  // rows 0 1 2 have -z +y, +z -x, -y +x
      const ExpressionId signed_across = is_positive ? across : nodes.negate(across);
      result[3 * i + j] = nodes.add({along, signed_across});
    }
  }
  return result;
}

/// R = (w^2 - e.e) 1 + 2 e e^T + 2 w [e]x for q = (w, e), divided by w^2 + e.e if `is_scaled`.
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

/// [w]x = R^T dR/dt: w_x = sum_k R_kz dR_ky/dt, and cyclic permutations.
Vector3 spin_of_matrix(NodeBuilder& nodes, const Matrix3& rotation) {
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

/// The angular velocity that `transform` adds, in the axes after `transform`. For a turn about n:
/// n dangle/dt. For a quaternion (w, e): 2 (w de/dt - dw/dt e - e x de/dt)/|q|^2. For the rotation
/// of a coordinate: the three velocities of the coordinate.
Vector3 transform_spin(NodeBuilder& nodes, const Model& model,
                       const ElementaryTransform& transform) {
  Vector3 result{};
  if (transform.rotation) {
    const std::uint32_t first = model.rotations[*transform.rotation].first_velocity;
    for (std::uint32_t i = 0; i < 3; ++i) result[i] = nodes.leaf(Opcode::velocity, first + i);
    return result;
  }
  if (transform.kind == TransformKind::turn) {
    const ExpressionId rate = nodes.rate(transform.angle);
    for (std::size_t i = 0; i < 3; ++i) result[i] = nodes.multiply({rate, transform.vector[i]});
    return result;
  }
  const auto& q = transform.quaternion;
  std::vector<ExpressionId> squares;
  std::array<ExpressionId, 4> rates{};
  for (std::size_t i = 0; i < 4; ++i) {
    squares.push_back(nodes.power(q[i], 2));
    rates[i] = nodes.rate(q[i]);
  }
  const ExpressionId length = nodes.add(squares);
  const ExpressionId two = nodes.number(2);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3 + 1;
    const std::size_t k = (i + 2) % 3 + 1;
    const ExpressionId gained = nodes.add(
        {nodes.multiply({two, q[0], rates[i + 1]}), nodes.multiply({two, q[k], rates[j]})});
    const ExpressionId lost = nodes.add(
        {nodes.multiply({two, rates[0], q[i + 1]}), nodes.multiply({two, q[j], rates[k]})});
    const ExpressionId doubled = nodes.subtract(gained, lost);
    result[i] = nodes.divide(doubled, length);
  }
  return result;
}

/// Sets the pose and the angular velocities of `frame` from its transforms and its parent.
///
///     before    parent world, translate (l, 0, 0), turn by q about z
///     after     R = [cos(q), -sin(q), 0; sin(q), cos(q), 0; 0, 0, 1], origin (l, 0, 0),
///               angular velocity (0, 0, dot(q))
void derive_kinematics(Context& context, Frame& frame) {
  NodeBuilder nodes(context, frame.span);
  // The parent's motion is referred to by name, not copied.
  Matrix3 rotation = frame.parent ? frame_rotation_matrix(nodes, *frame.parent) : nodes.identity();
  Vector3 origin = frame.parent ? frame_vector(nodes, *frame.parent, frame_origin) : Vector3{};
  Vector3 turning =
      frame.parent ? frame_vector(nodes, *frame.parent, frame_recursive_spin) : Vector3{};
  for (const ElementaryTransform& transform : frame.transforms) {
    if (transform.kind == TransformKind::translation) {
      const Vector3 offset = nodes.apply(rotation, transform.vector);
      origin = nodes.add(origin, offset);
    } else {
      const Matrix3 turn =
          transform.kind == TransformKind::turn
              ? turn_matrix(nodes, transform)
              : quaternion_matrix(nodes, transform.quaternion, !transform.rotation);
      rotation = nodes.multiply(rotation, turn);
      const Vector3 carried = nodes.apply_transposed(turn, turning);
      turning = nodes.add(carried, transform_spin(nodes, context.model, transform));
    }
  }
  frame.rotation = rotation;
  frame.origin = origin;
  frame.spin = spin_of_matrix(nodes, rotation);
  frame.recursive_spin = turning;
  const auto index = static_cast<std::uint32_t>(&frame - context.model.frames.data());
  const Matrix3 named_rotation = frame_rotation_matrix(nodes, index);
  const Vector3 named_turning = frame_vector(nodes, index, frame_recursive_spin);
  frame.angular_velocity = nodes.apply(named_rotation, named_turning);
}

const RootRequest angle_request{{"an angle", place::configuration_terms}, find_unit("rad")};
const RootRequest length_request{{place::position, place::configuration_terms}, find_unit("m")};
constexpr std::array<std::string_view, 5> orientations{"rotate", "rpy", "dh", "quaternion",
                                                       "rotation"};

/// The key that gives the orientation; null if the entry has none, and after E112 if it has two.
const KeySyntax* find_orientation_key(const EntrySyntax& entry, Report& report) {
  const auto [first, second] = first_two_keys(entry, orientations);
  if (second == nullptr) return first;
  report.add(Reason::two_orientations, second->key_span,
             "a frame has at most one of `rotate`, `rpy`, `dh`, `quaternion` and `rotation`");
  return nullptr;
}

/// True if the list has `count` items; false after E104.
bool check_count(const ValueSyntax& value, std::size_t count, const std::string& noun,
                 Report& report) {
  if (value.items.size() == count) return true;
  report.add(Reason::wrong_component_count, value.span,
             count_text(value.items.size(), "component") + ", but " + noun + " has " +
                 std::to_string(count));
  return false;
}

/// The unit vector along the axis, exactly: irrational components are expressions. None after an
/// error.
std::optional<Vector3> read_unit_axis(ValueReader& values, const ValueSyntax& axis) {
  Context& context = values.context();
  NodeBuilder nodes(context, axis.span);
  Vector3 given{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::optional<FixedValue> value = values.read_exact_constant(axis.items[i]);
    if (!value) return std::nullopt;
    given[i] = value->exact_expression ? *value->exact_expression
                                       : nodes.number(cln::rational(value->number));
  }
  const ExpressionId squared = nodes.dot(given, given);
  if (context.constants[squared] == 0) {
    context.report.add(Reason::zero_direction, axis.span, "an axis of length 0 has no direction");
    return std::nullopt;
  }
  const ExpressionId scale = nodes.power(squared, cln::cl_RA(-1) / 2);
  for (ExpressionId& component : given) component = nodes.multiply({component, scale});
  return given;
}

class FrameReader {
 public:
  FrameReader(ValueReader& values, const EntrySyntax& entry, Frame& frame)
      : context_(values.context()),
        values_(values),
        entry_(entry),
        frame_(frame),
        report_(context_.report) {}

  void read() {
    if (frame_.name == world) {
      report_.add(Code::E204, frame_.span, "`world` is reserved for the frame that does not move",
                  free_name_hint(world, frame_.span));
    }
    if (const KeySyntax* parent = entry_.find("parent")) {
      frame_.parent = values_.resolve_frame_or_world(parent->value);
    }
    if (const KeySyntax* translate = entry_.find("translate")) read_translation(translate->value);
    if (const KeySyntax* turned = find_orientation_key(entry_, report_)) read_orientation(*turned);
    derive_kinematics(context_, frame_);
  }

 private:
  /// The request for a value of this frame. A frame of a scene is fixed to its parent.
  [[nodiscard]] RootRequest request(const RootRequest& usual) const {
    if (!is_of_scene(context_.model, frame_.span)) return usual;
    return {{"a frame of a scene", place::parameters_only}, usual.unit};
  }

  void read_translation(const ValueSyntax& value) {
    if (!values_.check_vector(value)) return;
    const Vector3 offset = pad_to_three(values_.read_roots(value, request(length_request)));
    frame_.transforms.push_back({TransformKind::translation, offset});
  }

  void read_orientation(const KeySyntax& turned) {
    const auto& [key, span, value] = turned;
    if (key == "rotate") read_turns(value);
    if (key == "rpy") read_rpy(value);
    if (key == "dh") read_dh(value);
    if (key == "quaternion") read_quaternion(value);
    if (key == "rotation") read_rotation(value);
  }

  void add_turn(std::size_t axis, ExpressionId angle) {
    ElementaryTransform transform{TransformKind::turn};
    transform.vector[axis] = NodeBuilder(context_, frame_.span).number(1);
    transform.angle = angle;
    frame_.transforms.push_back(transform);
  }

  /// Reports E405 for a number above one turn (2 pi < 7), which is probably in degrees.
  void report_angle_in_degrees(const ValueSyntax& value, ExpressionId angle) {
    const Expression& e = context_.model.expressions[angle];
    if (e.kind != ExpressionKind::number || cln::abs(e.number) <= 7) return;
    elgen::report_degrees(report_, value.span, e.number);
  }

  void read_turns(const ValueSyntax& turns) {
    for (const ValueSyntax& turn : turns.items) {
      const ValueSyntax& axis = turn.items[0];
      const ExpressionId angle = values_.root(turn.items[1], request(angle_request));
      report_angle_in_degrees(turn.items[1], angle);
      if (axis.kind == ValueKind::list) {
        const std::optional<Vector3> direction = read_unit_axis(values_, axis);
        if (direction) frame_.transforms.push_back({TransformKind::turn, *direction, angle});
      } else if (axis.text == "x" || axis.text == "y" || axis.text == "z") {
        add_turn(static_cast<std::size_t>(axis.text.front() - 'x'), angle);
      } else {
        report_.add(
            Reason::unknown_axis, axis.span,
            quote_text(axis.text) + " is no axis: an axis is `x`, `y`, `z` or three constants");
      }
    }
  }

  void read_rpy(const ValueSyntax& value) {
    if (!check_count(value, 3, "`rpy`", report_)) return;
    const std::vector<ExpressionId> angles = values_.read_roots(value, request(angle_request));
    for (const std::size_t axis : {2U, 1U, 0U}) {
      if (value.kind == ValueKind::list) report_angle_in_degrees(value.items[axis], angles[axis]);
      add_turn(axis, angles[axis]);
    }
  }

  /// Adds a turn about an axis and a shift along the same axis, which commute.
  void add_screw(std::size_t axis, std::optional<ExpressionId> angle,
                 std::optional<ExpressionId> length) {
    if (angle) add_turn(axis, *angle);
    if (!length) return;
    ElementaryTransform transform{TransformKind::translation};
    transform.vector[axis] = *length;
    frame_.transforms.push_back(transform);
  }

  void read_dh(const ValueSyntax& table) {
    const auto a = values_.root(table, "a", request(length_request));
    const auto alpha = values_.root(table, "alpha", request(angle_request));
    const auto d = values_.root(table, "d", request(length_request));
    const auto theta = values_.root(table, "theta", request(angle_request));
    if (alpha) report_angle_in_degrees(table.find("alpha")->value, *alpha);
    if (theta) report_angle_in_degrees(table.find("theta")->value, *theta);
    const bool is_modified = text_value(table, "convention") == "modified";
    if (is_modified) add_screw(0, alpha, a);
    add_screw(2, theta, d);
    if (!is_modified) add_screw(0, alpha, a);
  }

  void read_quaternion(const ValueSyntax& value) {
    if (!check_count(value, 4, "a quaternion", report_)) return;
    const std::vector<ExpressionId> components =
        values_.read_roots(value, request({{"a quaternion", place::configuration_terms}, {}}));
    ElementaryTransform transform{TransformKind::quaternion};
    std::copy(components.begin(), components.end(), transform.quaternion.begin());
    const auto is_zero = [&](ExpressionId id) { return context_.constants[id] == 0; };
    if (std::ranges::all_of(components, is_zero)) {
      report_.add(Reason::zero_direction, value.span, "a quaternion of length 0 is no orientation");
      return;
    }
    frame_.transforms.push_back(transform);
  }

  void read_rotation(const ValueSyntax& value) {
    const std::optional<std::uint32_t> rotation = values_.resolve_rotation_name(value);
    if (!rotation) return;
    if (is_of_scene(context_.model, frame_.span)) {
      report_.add(Code::E319, value.span,
                  in_backticks(value.span) + " is a rotation, but a frame of a scene takes none");
      return;
    }
    NodeBuilder nodes(context_, frame_.span);
    ElementaryTransform transform{TransformKind::quaternion};
    for (std::uint32_t i = 0; i < quaternion_size; ++i) {
      const std::uint32_t coordinate = context_.model.rotations[*rotation].first_coordinate + i;
      transform.quaternion[i] = nodes.leaf(Opcode::coordinate, coordinate);
    }
    transform.rotation = rotation;
    frame_.transforms.push_back(transform);
  }

  Context& context_;
  ValueReader& values_;
  const EntrySyntax& entry_;
  Frame& frame_;
  Report& report_;
};

}  // namespace

void read_frame(ValueReader& values, const EntrySyntax& entry, std::uint32_t target) {
  FrameReader(values, entry, values.context().model.frames[target]).read();
}

}  // namespace elgen
