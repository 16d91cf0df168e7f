// Model: what a system is. Sizes applied, repetitions expanded, names resolved, units agreed,
// constants exact.
//
// Expressions live in one arena (Model::expressions) and refer to each other, to coordinates,
// velocities, parameters, definitions and points by index, so shared parts stay shared. Operands
// precede their users.
//
// q lists the coordinates, v the velocities. A plain coordinate has one velocity, its rate; the
// four components of a rotation have three, the angular velocity in the axes of the body.
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

/// `name` is what the file says ("q[3]"), `identifier` the same as a C++ identifier ("q_3").
struct Coordinate {
  std::string name;
  std::string identifier;
  std::optional<Unit> unit = {};  ///< none: not checked
  std::string unit_text = {};     ///< as written
  std::optional<Interval> range = {};
  cln::cl_R start_value = 0;
  bool wrap = false;           ///< an angle that may turn all the way round
  std::uint32_t velocity = 0;  ///< of its rate in Model::velocities; the first one of its rotation
  std::optional<std::uint32_t> rotation = {};  ///< whose component it is, in Model::rotations
  std::optional<ExpressionId> armature = {};   ///< adds 1/2 J v^2 to T
  std::optional<ExpressionId> singular = {};   ///< the chart breaks where this is zero
  std::string latex = {};
  std::string doc = {};
  Span span = {};
};

/// One entry of v. `name` is what dot() is written around: "q[3]" for the rate of that coordinate,
/// "attitude[2]" for a component of the angular velocity of a rotation.
struct Velocity {
  std::string name;
  std::string identifier;
  std::uint32_t coordinate = 0;                ///< whose rate it is; the first one of its rotation
  std::optional<std::uint32_t> rotation = {};  ///< whose angular velocity it belongs to
  std::optional<Unit> unit = {};               ///< of the velocity itself; none: not checked
  std::optional<Interval> rate_range = {};
  cln::cl_R start_rate = 0;
  Span span = {};
};

/// A unit quaternion, scalar first, Hamilton, from the axes of the body to those of the parent:
/// four coordinates, three velocities.
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
  cln::cl_R value = 0;  ///< exact rational where it is one, else a float of 100 decimal digits
  Assumption assumption = Assumption::none;
  std::optional<Unit> unit = {};
  std::optional<ExpressionId> form = {};  ///< the value as written, where it is not rational
};

/// A parameter as declared: one number, or `size` of them.
struct ParameterArray {
  std::string name;
  std::uint32_t first = 0;  ///< index into Model::parameters
  std::uint32_t count = 1;
  bool is_array = false;
  std::string unit_text = {};
  std::optional<Interval> range = {};  ///< [min, max]
  std::string latex = {};
  std::string doc = {};
  Span span = {};
};

/// [define] and [[prescribed]]: a named expression.
struct NamedExpression {
  std::string name;
  std::string identifier;
  ExpressionId value = 0;
  std::string latex = {};
  std::string doc = {};
  Span span = {};
};

using Vector3 = std::array<ExpressionId, 3>;

enum class FrameStepKind : std::uint8_t {
  translation,  ///< by `vector`, in the axes reached so far
  turn,         ///< by `angle` about the unit axis `vector`
  quaternion,   ///< by `quaternion` of any length but 0
};

/// One elementary motion; those of a frame follow one another, each in the axes of the one before.
struct FrameStep {
  FrameStepKind kind = FrameStepKind::translation;
  Vector3 vector{};
  ExpressionId angle = 0;
  std::array<ExpressionId, 4> quaternion{};    ///< w, x, y, z
  std::optional<std::uint32_t> rotation = {};  ///< whose unit quaternion it is
};

/// A coordinate system. x_world = rotation x_frame + origin; `rotation` and `origin` are written
/// over those of the parent, so each is a few nodes.
struct Frame {
  std::string name;
  std::string identifier;
  std::optional<std::uint32_t> parent = {};  ///< none: the world
  std::vector<FrameStep> steps = {};         ///< from the parent to the frame
  std::array<ExpressionId, 9> rotation{};    ///< R, row-major
  Vector3 origin{};                          ///< in the world
  Vector3 spin{};              ///< angular velocity in the axes of the frame: [spin]x = R^T dR/dt
  Vector3 turning{};           ///< the same, from that of the parent and the steps
  Vector3 angular_velocity{};  ///< the same in the axes of the world: R turning
  std::string doc = {};
  Span span = {};
};

/// A point, or a centre of mass, as it was given: in the axes of a frame.
struct PlaceInFrame {
  std::uint32_t frame = 0;
  Vector3 at{};
};

/// The other end of a line that a page draws: a point, the origin of a frame, or (neither) that of
/// the world.
struct JoinedPlace {
  std::optional<std::uint32_t> point = {};
  std::optional<std::uint32_t> frame = {};
};

/// A point with a mass adds 1/2 m v^2 to T and -m gravity.p to V.
struct Point {
  std::string name;
  std::string identifier;
  std::uint32_t dimension = 3;             ///< 2 or 3 components given; `at` is padded with 0
  Vector3 at{};                            ///< in the world
  std::optional<PlaceInFrame> local = {};  ///< where it was given in a frame
  std::optional<ExpressionId> mass = {};
  std::vector<JoinedPlace> joined_to = {};  ///< no equation depends on these two
  bool is_on_springs = false;               ///< what joins it is drawn as springs, not rods
  bool is_named = true;                     ///< false: the origin of a frame on which a wrench acts
  std::string doc = {};
  Span span = {};
};

/// How a body was given in a frame; about the frame's origin where `about_origin`.
struct BodyInFrame {
  PlaceInFrame com = {};
  std::vector<ExpressionId> inertia = {};
  bool about_origin = false;
};

/// A body written in world coordinates: centre of mass, angular velocity in the axes of its
/// inertia, which is about the com: T = 1/2 m v_com^2 + 1/2 w.I w. The com may be absent only
/// without a mass. Of a body in a frame com, spin and inertia follow from the frame.
struct Body {
  std::string name;
  std::string identifier;
  std::uint32_t dimension = 3;
  Vector3 com{};
  std::optional<ExpressionId> mass = {};
  std::vector<ExpressionId> inertia = {};  ///< {} | {Izz} planar | {xx yy zz xy xz yz}
  std::vector<ExpressionId> spin = {};     ///< {} | {wz} planar | {wx wy wz}
  std::optional<BodyInFrame> local = {};   ///< a body in a frame; the above says the same of it
  std::string doc = {};
  Span span = {};
};

struct Input {
  std::string name;
  std::string identifier;
  std::optional<std::uint32_t> on = {};  ///< velocity it acts on as a generalized force
  bool is_external = false;              ///< a component of a force of the world, no motor
  std::optional<Interval> limits = {};
  std::optional<Unit> unit = {};
  std::string unit_text = {};
  std::string doc = {};
  Span span = {};
};

/// A generalized force on a velocity, a force in N at a point (opposite on the point `from`), or
/// a torque in N m on a frame (opposite on the frame `from_frame`). Affine in the inputs.
struct Force {
  std::string name;
  /// One number; or the components (padded to 3): of a force in the world, of a torque in the axes
  /// of the frame it acts on.
  std::vector<ExpressionId> value = {};
  std::optional<std::uint32_t> on = {};  ///< velocity it does work on
  std::optional<std::uint32_t> at = {};
  std::optional<std::uint32_t> from = {};
  std::optional<std::uint32_t> frame = {};
  std::optional<std::uint32_t> from_frame = {};
  std::vector<ExpressionId> reaction = {};  ///< the torque's components in the axes of from_frame
  /// The components as they were given, and the frame they were given in (none: the world).
  std::vector<ExpressionId> written = {};
  std::optional<std::uint32_t> axes = {};
  Span span = {};
};

/// An [[output]]: its value, and with `jacobian` also d value/dq and the bias of its second rate. A
/// frame gives the pose [R p], 3 x 4; its Jacobian is d twist/dv (twist: angular velocity; velocity
/// of the origin), and its bias is d twist/dt at a = 0.
struct UserOutput {
  std::string name;
  std::vector<ExpressionId> values = {};  ///< row-major
  std::optional<std::uint32_t> frame = {};
  bool in_world = true;                  ///< axes of the twist: the world's, or the frame's
  std::vector<ExpressionId> twist = {};  ///< six entries, linear in the rates
  bool jacobian = false;
  bool motion = false;    ///< accelerations and multipliers are those of the motion
  bool is_wanted = true;  ///< by the scene: the inputs it names do not leave with locks
  LeafSet takes = {};     ///< rates, accelerations and inputs that the values name
  std::string doc = {};
  Span span = {};
};

/// The energies as given beside those of points and bodies.
struct Energies {
  std::optional<ExpressionId> T = {};
  std::optional<ExpressionId> V = {};
  std::optional<ExpressionId> D = {};
  std::optional<ExpressionId> L = {};
};

/// A condition on the parameters: `excess` > 0, or >= 0 where it is not strict.
struct Condition {
  ExpressionId excess = 0;
  bool is_strict = true;
  std::string text = {};  ///< as written: "R*Omega^2 > g"
};

/// A point at which the system stays at rest, whatever the parameters are that meet `condition`;
/// its values are made of parameters.
struct StatedPoint {
  std::vector<std::optional<ExpressionId>> coordinates = {};  ///< none: anywhere
  std::vector<std::optional<ExpressionId>> inputs = {};       ///< none: 0
  std::optional<Condition> condition = {};                    ///< none: for all values
};

/// An [[equilibrium]]: its point, and w^2 of small motions about it: det(x M - K)/det M is the
/// product of x - w^2.
struct Equilibrium : StatedPoint {
  std::string name = {};
  std::vector<ExpressionId> frequencies_squared = {};  ///< one per velocity, or none
  std::string doc = {};
  Span span = {};
};

/// The point a scene expands about, and what is small there. Deviations of small coordinates,
/// their rates and accelerations (and of the inputs, where all coordinates are small) count
/// jointly: energies become polynomials of degree order + 1 in them, forces of degree order.
struct Approximation : StatedPoint {
  std::uint32_t order = 1;
  std::vector<bool> small = {};  ///< which coordinates
  bool small_inputs = false;     ///< where every coordinate is that is not locked
  Span span = {};                ///< of `about`
};

inline constexpr std::uint32_t highest_order = 5;

struct Model {
  SourcePointer source = {};
  std::string canonical = {};  ///< the canonical text of its file, for stamps
  std::string name;
  Span name_span = {};
  std::string title = {};
  std::string description = {};
  std::string reference = {};
  std::vector<Expression> expressions = {};
  /// Rewritten expressions as they were typed, for pages: sin(q)/q of stumpff(q, 1).
  std::map<ExpressionId, Expression> typed = {};
  std::vector<Coordinate> coordinates = {};  ///< q
  std::vector<Velocity> velocities = {};     ///< v
  std::vector<Rotation> rotations = {};
  std::vector<Parameter> parameters = {};
  std::vector<ParameterArray> parameter_arrays = {};
  std::vector<OpenFunction> functions = {};
  std::vector<OpenValue> open_values = {};  ///< of each function all, in the order of the header
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
  std::optional<Approximation> approximation = {};  ///< of the scene; outputs stay exact

  /// The Model that every stage works on is without what the scene holds: functions of time have
  /// taken the place of locked variables, and 0 that of cyclic ones, where the Lagrangian is R of
  /// the whole model.
  Variant variant = {};
  std::vector<std::uint32_t> regressed = {};  ///< parameters in which forces are affine together

  bool quadratic = true;        ///< T - V (or L) is at most quadratic in the rates
  bool without_pivots = false;  ///< of forward_dynamics, unless a scene says otherwise
  bool uses_time = false;       ///< in an energy, a point, a force or an output: functions take t
  /// T may have terms of degree 1 or 0 in the rates, or V of degree 1; otherwise drift is 0
  bool may_drift = false;
};

/// rad is the unit 1, so what is written tells angles from pure numbers.
[[nodiscard]] inline bool is_angle(const Coordinate& coordinate) {
  return coordinate.unit_text == "rad";
}

/// Adds a coordinate with its rate; its index.
std::uint32_t append_coordinate(Model& model, Coordinate coordinate);

/// Adds a rotation with its coordinates NAME_w, NAME_x, NAME_y, NAME_z and its velocities NAME[1],
/// NAME[2], NAME[3]; its index.
std::uint32_t append_rotation(Model& model, Rotation rotation);

/// The model in which everything moves that a scene holds.
[[nodiscard]] inline const Model& whole_of(const Model& model) {
  return model.variant.whole ? *model.variant.whole : model;
}

/// The velocities of the whole model that `reaction` has a row for, in the order of v.
[[nodiscard]] inline std::vector<std::uint32_t> held_velocities(const Model& model) {
  return model.variant.whole ? velocities_with_reaction(model.variant.locks)
                             : std::vector<std::uint32_t>{};
}

/// Where variables of the whole model go as held ones leave. Inputs leave that act on locks alone,
/// with their wrench, unless a wanted output names them.
[[nodiscard]] VariablesLeft variables_left(const Model& whole);

/// Whether the Lagrangian is R: cyclic coordinates have been taken out.
[[nodiscard]] inline bool has_routhian(const Model& model) {
  return model.variant.whole && !model.variant.cyclic.empty();
}

/// Whether the Lagrangian is one function, which has no T and V: L as given, or R.
[[nodiscard]] inline bool has_whole_lagrangian(const Model& model) {
  return model.energies.L.has_value() || has_routhian(model);
}

/// The properties that equations of outputs depend on.
[[nodiscard]] inline EquationSetting setting_of(const Model& model) {
  return {!model.rotations.empty(), !model.constraints.empty()};
}

/// Prints an expression in the model language, as it is typed, with the names of the model.
[[nodiscard]] std::string to_string(const Model& model, ExpressionId expression);

}  // namespace elgen
