// Model: a mechanical system after check: sizes applied, repetitions expanded, names resolved,
// units checked, constants exact.
//
// Expressions form one arena (Model::expressions). They refer to each other, to coordinates,
// velocities, parameters, definitions and points by index, so common subexpressions are shared.
// Operands precede their users.
//
// q lists the coordinates, v the velocities. A plain coordinate has the velocity v_i = dq_i/dt. A
// rotation has four coordinates, its quaternion, and three velocities: the angular velocity in body
// axes.
#pragma once

#include <cln/real.h>

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "elgen/constraint.hpp"
#include "elgen/diagnostic.hpp"
#include "elgen/expectation.hpp"
#include "elgen/expression.hpp"
#include "elgen/open_functions.hpp"
#include "elgen/outputs.hpp"
#include "elgen/source_text.hpp"
#include "elgen/units.hpp"

namespace elgen {

struct Interval {
  cln::cl_R low;
  cln::cl_R high;
};

/// `name` as in the file ("q[3]"); `identifier` is its C++ identifier ("q_3").
struct Coordinate {
  std::string name;
  std::string identifier;
  std::optional<Unit> unit = {};  ///< none: units are not checked
  std::string unit_text = {};     ///< text of `unit` in the file
  std::optional<Interval> range = {};
  cln::cl_R start_value = 0;
  bool wraps = false;  ///< true: an angle that may make full turns and is compared modulo 2 pi
  /// Index of dq/dt in Model::velocities; for a component of a rotation, of its first velocity.
  std::uint32_t velocity = 0;
  std::optional<std::uint32_t> rotation = {};  ///< of a component: index in Model::rotations
  std::optional<ExpressionId> armature = {};   ///< J of the term 1/2 J v^2 of T
  std::optional<ExpressionId> singular_condition = {};  ///< M may lose rank if this expression is 0
  std::string latex = {};
  std::string doc = {};
  Span span = {};
};

/// One entry of v. `name` is the argument of dot(): "q[3]" for the rate of coordinate q[3],
/// "attitude[2]" for a component of the angular velocity of a rotation.
struct Velocity {
  std::string name;
  std::string identifier;
  std::uint32_t coordinate = 0;  ///< index of q_i with v_i = dq_i/dt, or of a rotation's NAME_w
  std::optional<std::uint32_t> rotation = {};  ///< of an angular velocity, as in Coordinate
  std::optional<Unit> unit = {};  ///< unit of the velocity; none: units are not checked
  std::optional<Interval> rate_range = {};
  cln::cl_R start_rate = 0;
  Span span = {};
};

/// A unit quaternion (Hamilton, w first) from body to parent axes: 4 coordinates, 3 velocities.
struct Rotation {
  std::string name;
  std::string identifier;
  std::uint32_t first_coordinate = 0;
  std::uint32_t first_velocity = 0;
  std::string latex = {};
  std::string doc = {};
  Span span = {};
};

enum class Assumption : std::uint8_t { none, positive, nonnegative };

/// A scalar parameter, or one element of an array parameter.
struct Parameter {
  std::string name;         ///< "m" or "m[2]"
  std::string identifier;   ///< "m" or "m_2"
  std::uint32_t array = 0;  ///< index into Model::parameter_arrays
  std::uint32_t element = 0;
  cln::cl_R value = 0;  ///< exact rational, or a float of 100 decimal digits if it is irrational
  Assumption assumption = Assumption::none;
  std::optional<Unit> unit = {};
  std::optional<ExpressionId> exact_expression = {};  ///< the expression of an irrational `value`
};

/// A parameter as declared: one number, or an array of `count` numbers.
struct ParameterArray {
  std::string name;
  std::uint32_t first = 0;  ///< index into Model::parameters
  std::uint32_t count = 1;
  bool is_array = false;
  std::string unit_text = {};
  std::optional<Interval> range = {};  ///< [min, max] for every element
  std::string latex = {};
  std::string doc = {};
  Span span = {};
};

/// A named expression of [define] or [[prescribed]].
struct NamedExpression {
  std::string name;
  std::string identifier;
  ExpressionId value = 0;
  std::string latex = {};
  std::string doc = {};
  Span span = {};
};

using Vector3 = std::array<ExpressionId, 3>;

enum class TransformKind : std::uint8_t {
  translation,  ///< translation by `vector`
  turn,         ///< rotation by `angle` about the unit axis `vector`
  quaternion,   ///< rotation by `quaternion`, of any length except 0
};

/// One elementary transform of a frame, in the axes that result from the previous transform.
struct ElementaryTransform {
  TransformKind kind = TransformKind::translation;
  Vector3 vector{};
  ExpressionId angle = 0;
  std::array<ExpressionId, 4> quaternion{};    ///< w, x, y, z
  std::optional<std::uint32_t> rotation = {};  ///< the rotation that is `quaternion`; else none
};

/// A coordinate system with x_world = rotation x_frame + origin. Rotation and origin refer to the
/// rotation and origin of the parent frame by name, so that each expression is small.
struct Frame {
  std::string name;
  std::string identifier;
  std::optional<std::uint32_t> parent = {};          ///< index in Model::frames; none: the world
  std::vector<ElementaryTransform> transforms = {};  ///< in order, from the parent to the frame
  std::array<ExpressionId, 9> rotation{};            ///< R, row-major
  Vector3 origin{};                                  ///< position in world axes
  Vector3 spin{};              ///< angular velocity in frame axes: [spin]x = R^T dR/dt
  Vector3 recursive_spin{};    ///< the vector `spin`, computed from the parent and the transforms
  Vector3 angular_velocity{};  ///< in world axes: R spin
  std::string doc = {};
  Span span = {};
};

/// A point or centre of mass in the axes of a frame, as declared.
struct PointInFrame {
  std::uint32_t frame = 0;
  Vector3 position{};
};

/// The other end of a line that a page draws: a point, or the origin of a frame; if neither is set,
/// the origin of the world.
struct LineEnd {
  std::optional<std::uint32_t> point = {};
  std::optional<std::uint32_t> frame = {};
};

/// A point. With a mass it adds 1/2 m v^2 to T and -m gravity.p to V.
struct Point {
  std::string name;
  std::string identifier;
  std::uint32_t dimension = 3;  ///< 2 or 3 declared components; `position` is padded with 0
  Vector3 position{};           ///< in world axes
  std::optional<PointInFrame> local = {};  ///< none: the point is declared in the world
  std::optional<ExpressionId> mass = {};
  std::vector<LineEnd> line_ends = {};  ///< other ends of the lines that a page draws
  bool has_springs = false;             ///< true: the lines are springs; false: rods
  bool is_named = true;  ///< false: an unnamed point at the origin of a frame, for a wrench
  std::string doc = {};
  Span span = {};
};

/// A body as declared in a frame. `is_about_origin`: the inertia is about the origin of the frame,
/// not about the centre of mass.
struct LocalBody {
  PointInFrame com = {};
  std::vector<ExpressionId> inertia = {};
  bool is_about_origin = false;
};

/// A body: its centre of mass in world coordinates, its inertia I about the centre of mass, and its
/// angular velocity `spin` in the axes of I. T = 1/2 m v_com^2 + 1/2 spin.I spin. A body without
/// mass may have no com. For a body in a frame, com, spin and inertia are computed from the frame.
struct Body {
  std::string name;
  std::string identifier;
  std::uint32_t dimension = 3;
  Vector3 com{};
  std::optional<ExpressionId> mass = {};
  std::vector<ExpressionId> inertia = {};  ///< empty, {Izz} if planar, or {xx yy zz xy xz yz}
  std::vector<ExpressionId> spin = {};     ///< empty, {wz} if planar, or {wx wy wz}
  std::optional<LocalBody> local = {};     ///< the same body as declared in a frame
  std::string doc = {};
  Span span = {};
};

struct Input {
  std::string name;
  std::string identifier;
  std::string indexed_name = {};  ///< "hand[1]" for the component "hand_tx" of a wrench; else ""
  /// Index of the velocity on which the input acts; none: the input acts through `forces`.
  std::optional<std::uint32_t> velocity = {};
  bool is_external = false;  ///< true: a component of an external force or torque; false: a motor
  std::optional<Interval> limits = {};
  std::optional<Unit> unit = {};
  std::string unit_text = {};
  std::string doc = {};
  Span span = {};
};

/// A generalised force on `velocity`, a force in N at `point`, or a torque in N m on `frame`. If
/// `reaction_point` (or `reaction_frame`) is set, the opposite force (or torque) acts there. Forces
/// are affine in the inputs.
struct Force {
  std::string name;
  /// One number for a generalised force. Otherwise three components, padded with 0: a force in
  /// world axes, or a torque in the axes of its frame.
  std::vector<ExpressionId> value = {};
  std::optional<std::uint32_t> velocity = {};  ///< index of the velocity of a generalised force
  std::optional<std::uint32_t> point = {};
  std::optional<std::uint32_t> reaction_point = {};
  std::optional<std::uint32_t> frame = {};
  std::optional<std::uint32_t> reaction_frame = {};
  std::vector<ExpressionId> reaction = {};  ///< torque in axes of reaction_frame, not negated
  /// The components as declared, in the axes of the frame `declared_axes` (none: world axes).
  std::vector<ExpressionId> declared_value = {};
  std::optional<std::uint32_t> declared_axes = {};
  Span span = {};
};

/// An [[output]]: its value y; with `has_jacobian` also J = dy/dq and the bias, d2y/dt2 at a = 0.
/// The value of a frame is its pose [R p], 3 x 4. The Jacobian of a frame is d twist/dv with twist
/// = (angular velocity, velocity of the origin); its bias is d twist/dt at a = 0.
struct UserOutput {
  std::string name;
  std::vector<ExpressionId> values = {};  ///< row-major
  std::optional<std::uint32_t> frame = {};
  bool is_in_world = true;               ///< true: the twist is in world axes; false: frame axes
  std::vector<ExpressionId> twist = {};  ///< (angular velocity, velocity of the origin)
  bool has_jacobian = false;
  bool solves_motion = false;  ///< true: a, lambda solve the equations of motion; false: a is given
  bool is_requested = true;    ///< true: requested by the scene; locks keep the inputs in `values`
  LeafSet argument_kinds = {};  ///< kinds of arguments besides q: v, a, u; on pages also t
  std::string doc = {};
  Span span = {};
};

/// The energies of `[energy]`, in addition to the energies of points and bodies.
struct Energies {
  std::optional<ExpressionId> T = {};
  std::optional<ExpressionId> V = {};
  std::optional<ExpressionId> D = {};
  std::optional<ExpressionId> L = {};
};

/// A condition on the parameters: `excess` > 0 if `is_strict` is set, otherwise `excess` >= 0.
struct Condition {
  ExpressionId excess = 0;
  bool is_strict = true;
  std::string text = {};  ///< as in the file: "R*Omega^2 > g"
};

/// A stated point of rest, for all parameters that meet `condition`. The coordinates and inputs are
/// expressions of parameters.
struct OperatingPoint {
  std::vector<std::optional<ExpressionId>> coordinates = {};  ///< by coordinate; none: any value
  std::vector<std::optional<ExpressionId>> inputs = {};       ///< by input; none: 0
  std::optional<Condition> condition = {};                    ///< none: all parameter values
};

/// An [[equilibrium]]: a point of rest, and the squares w_i^2 of the frequencies of small motions
/// about this point, with det(x M - K)/det M = product of (x - w_i^2), K as in elgen/analyse.hpp.
struct Equilibrium : OperatingPoint {
  std::string name = {};
  std::vector<ExpressionId> frequencies_squared = {};  ///< one per velocity; empty: not stated
  std::string doc = {};
  Span span = {};
};

/// `[approximate]` of a scene: the expansion point and the small coordinates. The expansion
/// variables are the deviations, rates and accelerations of the small coordinates and, if
/// `has_small_inputs` is set, the deviations of the inputs. Energies become polynomials of joint
/// degree order + 1 in these variables. Forces on small coordinates become polynomials of degree
/// `order`, all other forces of degree order + 1.
struct Approximation : OperatingPoint {
  std::uint32_t order = 1;
  std::vector<bool> small = {};   ///< true for each small coordinate
  bool has_small_inputs = false;  ///< true if every coordinate that is not held is small
  Span span = {};                 ///< place of the key `about` in the file
};

inline constexpr std::uint32_t max_expansion_order = 5;

struct Model {
  SourcePointer source = {};
  std::string canonical_text = {};  ///< canonical text of the file; stamps contain its hash
  std::string name;
  Span name_span = {};
  std::string title = {};
  std::string description = {};
  std::string reference = {};
  std::vector<Expression> expressions = {};
  /// Each expression that the stage check rewrote, as the author wrote it, for pages and messages:
  /// sin(q)/q if `expressions` has stumpff(q, 1) at the same index.
  std::map<ExpressionId, Expression> original_expressions = {};
  std::vector<Coordinate> coordinates = {};  ///< q
  std::vector<Velocity> velocities = {};     ///< v
  std::vector<Rotation> rotations = {};
  std::vector<Parameter> parameters = {};
  std::vector<ParameterArray> parameter_arrays = {};
  std::vector<OpenFunction> functions = {};
  /// The values of all open functions, in the order of the argument `f` of emitted code.
  std::vector<OpenValue> open_values = {};
  std::vector<NamedExpression> prescribed = {};
  std::vector<NamedExpression> definitions = {};  ///< in file order; acyclic
  std::vector<Frame> frames = {};
  std::vector<Point> points = {};
  std::vector<Body> bodies = {};
  std::optional<std::array<ExpressionId, 3>> gravity = {};
  Energies energies = {};
  std::vector<Input> inputs = {};
  std::vector<Force> forces = {};
  std::vector<Constraint> constraints = {};
  std::vector<UserOutput> outputs = {};
  std::vector<Equilibrium> equilibria = {};
  std::vector<Expectation> expectations = {};
  std::optional<Approximation> approximation = {};  ///< `[approximate]`; [[output]] stays exact

  /// The held variables of the scene. The other members describe a Model without them: locked
  /// variables are replaced by functions of time, cyclic coordinates by 0. With `[routh]`, the
  /// Lagrangian is Routh's function R of the unreduced model.
  ModelReduction reduction = {};
  /// Indices of the parameters in pi; the forces are jointly affine in these parameters.
  std::vector<std::uint32_t> affine_parameters = {};

  bool is_quadratic = true;   ///< true: T - V (or L) is at most quadratic in the rates
  bool omits_pivots = false;  ///< true: forward_dynamics has no pivots unless a scene adds them
  /// True if t occurs in the equations of motion or in an output, so that functions take t.
  bool uses_time = false;
  /// False: `drift` is 0, because no t or L occurs, T has degree 2 in the rates, and V degree 0.
  bool may_drift = false;
};

/// True for a coordinate in rad. The unit rad equals 1, so the declared text of the unit decides.
[[nodiscard]] inline bool is_angle(const Coordinate& coordinate) {
  return coordinate.unit_text == "rad";
}

/// Adds a coordinate and its rate. Returns the index of the coordinate.
std::uint32_t append_coordinate(Model& model, Coordinate coordinate);

/// Adds a rotation, its coordinates NAME_w, NAME_x, NAME_y, NAME_z and its velocities NAME[1],
/// NAME[2], NAME[3]. Returns the index of the rotation.
std::uint32_t append_rotation(Model& model, Rotation rotation);

/// The model with the held variables; `model` itself if no variable is held.
[[nodiscard]] inline const Model& unreduced_model(const Model& model) {
  return model.reduction.unreduced ? *model.reduction.unreduced : model;
}

/// The velocities of the unreduced model for which the output `reaction` has a row, ascending.
[[nodiscard]] inline std::vector<std::uint32_t> reaction_row_velocities(const Model& model) {
  return model.reduction.unreduced ? velocities_with_reaction(model.reduction.locks)
                                   : std::vector<std::uint32_t>{};
}

/// The new indices in q, v and u of `whole` after its held variables are removed. Inputs that act
/// only on locked variables are also removed, except inputs that a requested output contains. An
/// input that does no work is removed if another input of the same wrench is removed.
[[nodiscard]] RemainingVariables remaining_variables(const Model& whole);

/// True if the Lagrangian is Routh's function R: cyclic coordinates are eliminated.
[[nodiscard]] inline bool has_routhian(const Model& model) {
  return model.reduction.unreduced && !model.reduction.cyclic.empty();
}

/// True if the Lagrangian is one function without separate T and V: a declared L, or R.
[[nodiscard]] inline bool has_combined_lagrangian(const Model& model) {
  return model.energies.L.has_value() || has_routhian(model);
}

/// True if no point and no body has a third component.
[[nodiscard]] bool has_plane_vectors(const Model& model);

/// The flags has_rotations and has_constraints of `model`, which select the equation of an output.
[[nodiscard]] inline EquationSetting setting_of(const Model& model) {
  return {!model.rotations.empty(), !model.constraints.empty()};
}

/// An expression in the model language, as typed, with the names of the model.
[[nodiscard]] std::string to_string(const Model& model, ExpressionId expression);

}  // namespace elgen
