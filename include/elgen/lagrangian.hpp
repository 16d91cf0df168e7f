// Lagrangian: T, V, D and Q over a list of definitions. The Lagrangian owns all symbols.
//
// A definition is a *small* GiNaC expression over leaves (q, v, a, u, t, parameters) and earlier
// definitions. Definitions are never substituted into one big expression. The chain rule is applied
// to the list, so that derivatives cost a constant multiple of the energy.
#pragma once

#include <ginac/ginac.h>

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "elgen/inertial_parameters.hpp"
#include "elgen/leaf_names.hpp"
#include "elgen/leaves.hpp"
#include "elgen/model.hpp"
#include "elgen/references.hpp"

namespace elgen {

/// The position of a rotation in q and v.
struct RotationPlace {
  std::uint32_t first_coordinate = 0;
  std::uint32_t first_velocity = 0;
};

/// The symbols of the leaves, in the order of declaration.
struct Symbols : LeafValues<GiNaC::ex> {
  std::vector<GiNaC::ex> q_rates = {};  ///< dq/dt as functions of q and v
  std::vector<RotationPlace> rotations = {};
};

struct Definition {
  GiNaC::ex symbol;
  GiNaC::ex value;
  std::string name;  ///< a readable C++ identifier ("bob_x"), or empty
  Entity origin;     ///< the entry of the model from which `value` comes
  std::vector<std::uint32_t>
      used_definitions;  ///< indices of the definitions in `value`, ascending
  /// Kinds of leaves in `value`, directly or through `used_definitions`.
  LeafSet leaf_dependence = {};
  /// If `value` is an opaque leaf, such as V: its derivatives by leaves, as (leaf, derivative).
  /// Otherwise empty.
  std::vector<std::pair<GiNaC::ex, GiNaC::ex>> derivatives = {};
};

struct ExpressionHash {
  std::size_t operator()(const GiNaC::ex& e) const { return e.gethash(); }
};
struct ExpressionEqual {
  bool operator()(const GiNaC::ex& a, const GiNaC::ex& b) const { return a.is_equal(b); }
};
template <class Value>
using ExpressionMap = std::unordered_map<GiNaC::ex, Value, ExpressionHash, ExpressionEqual>;

/// The position of a symbol in elgen's order: leaves as declared, then definitions.
struct SymbolPlace {
  bool is_definition = false;
  std::uint32_t index = 0;       ///< index in Definitions::list, or rank among the leaves
  LeafSet leaf_dependence = {};  ///< Definition::leaf_dependence, or the kind of the leaf
};

/// The physical meaning of the values that are being defined, for names of temporaries
/// (derive/formulate/name_scope.hpp).
struct ValueMeaning {
  std::string kind = {};  ///< "moment"; "": no name
  std::string frame = {};
  std::string axis = {};
};

/// Names of definitions, from the meaning at their first use in an output: "moment_link5_y", and
/// "moment_link5_y_2", … for further definitions with the same meaning.
struct ValueNames {
  ExpressionMap<std::string> names = {};   ///< symbol of a definition -> name
  std::map<std::string, int> counts = {};  ///< name without suffix -> number of definitions
};

/// An ordered list of definitions, each over earlier definitions only. Append with define().
struct Definitions {
  std::vector<Definition> list = {};
  ExpressionMap<SymbolPlace> places = {};  ///< symbol of a leaf or definition -> position
  /// Value -> symbol, so that no value is defined twice.
  ExpressionMap<GiNaC::ex> known_values = {};
  ValueMeaning meaning = {};
  ValueNames value_names = {};  ///< names in the output that is being derived
};

/// The name and origin of a new definition.
struct Label {
  std::string name = {};
  Entity origin = {};
};

/// Returns the symbol for `value`: `value` itself if it is a number, a symbol or a negated symbol;
/// the symbol of an equal definition; else the symbol of a new definition.
GiNaC::ex define(Definitions& definitions, const GiNaC::ex& value, Label label = {});

/// Adds `symbol`, a leaf of this kind, to `definitions.places` with the next rank among leaves.
void add_leaf(Definitions& definitions, const GiNaC::ex& symbol, Opcode kind);

/// The kinds of leaves that `value` depends on, directly or through definitions.
[[nodiscard]] LeafSet dependence(const Definitions& definitions, const GiNaC::ex& value);

/// The symbols of `value`, each once, in elgen's order.
[[nodiscard]] std::vector<GiNaC::ex> symbols_of(const Definitions& definitions,
                                                const GiNaC::ex& value);

/// A GiNaC expression as text. Terms, factors and signs are sorted, because GiNaC orders by
/// address, which differs between runs. Leaves are printed by name, definitions as d0, d1, … in the
/// order of the list.
[[nodiscard]] std::string expression_text(const Definitions& definitions, const GiNaC::ex& value);

/// One line per definition: `d3 = l*sin(theta)    ; bob_x`.
[[nodiscard]] std::string dump(const Definitions& definitions);

/// A point with a mass: adds 1/2 m |dp/dt|^2 to T, and -m gravity.p to V.
struct PointMass {
  GiNaC::ex mass;
  std::array<GiNaC::ex, 3> position;
  Entity origin;
};

/// The rotational part of a body outside frames: adds 1/2 w.I w to T. The inertia I is in the axes
/// of the angular velocity w.
struct RotatingBody {
  std::vector<GiNaC::ex> spin;     ///< {w_x, w_y, w_z}, or {w_z} if planar
  std::vector<GiNaC::ex> inertia;  ///< {xx, yy, zz, xy, xz, yz}, or {zz} if planar
  Entity origin;
};

/// A force F at the position p, both in world axes. Its generalised force is (dp/dq)^T F.
struct PointForce {
  std::array<GiNaC::ex, 3> position;
  std::array<GiNaC::ex, 3> force;
};

using ExVector3 = std::array<GiNaC::ex, 3>;

/// One elementary transform (see ElementaryTransform): x_parent = R x + p, with R = 1 or p = 0.
struct TreeTransform {
  std::optional<std::uint32_t> parent = {};  ///< index of the previous transform; none: the world
  TransformKind kind = TransformKind::translation;
  ExVector3 vector;  ///< p in the axes of the parent, or the unit axis of the turn
  GiNaC::ex angle = 0;
  /// A quaternion of any length except 0; for a rotation of the model a unit quaternion.
  std::array<GiNaC::ex, 4> quaternion;
  std::optional<std::uint32_t> rotation = {};  ///< index of a rotation's first velocity; else none
  std::string name = {};                       ///< identifier of the frame or point
  Entity origin = {};
};

/// A rigid body in the frame that results from a transform: mass m, centre of mass c, and inertia I
/// (xx yy zz xy xz yz; empty for a point). v is the velocity of the origin of the frame, w the
/// angular velocity, v_c the velocity of c. Its kinetic energy is
///
///     I about the centre of mass   T = 1/2 m v_c^2 + 1/2 w.I w
///     I about the origin           T = 1/2 m v^2 + v.(w x h) + 1/2 w.I w,   h = m c
struct RigidBody {
  std::optional<std::uint32_t> transform = {};  ///< index in FrameTree::transforms; none: world
  GiNaC::ex mass = 0;
  ExVector3 com;
  std::vector<GiNaC::ex> inertia = {};
  bool is_about_origin = false;
  /// h, if I is about the origin and regrouping (derive/tree/regroup.cpp) made h differ from m c.
  std::optional<ExVector3> moment = {};
  Entity origin = {};
};

/// A force and a moment on the frame that results from `transform`. The force acts at the point
/// `at`, given in this frame. Force and moment are in the axes of the frame that results from the
/// transform `axes` (none: world axes).
struct Wrench {
  std::optional<std::uint32_t> transform = {};
  std::optional<std::uint32_t> axes = {};
  ExVector3 at;
  ExVector3 force;
  ExVector3 moment;
};

/// The frames as a tree of elementary transforms, parents first, with their bodies and wrenches.
struct FrameTree {
  std::vector<TreeTransform> transforms = {};
  std::vector<RigidBody> bodies = {};
  std::vector<Wrench> wrenches = {};
};

/// The twist of the frame that results from a transform: its angular velocity, and the velocity of
/// its origin.
struct TwistOutput {
  std::optional<std::uint32_t> transform = {};  ///< index in FrameTree::transforms; none: world
  bool is_in_world = true;  ///< true: in world axes; false: in the axes of the frame
};

struct NamedOutput {
  std::string name;
  std::vector<GiNaC::ex> values;
  std::optional<TwistOutput> twist = {};
  /// True: a and lambda in `values` solve the equations of motion. False: a is an argument.
  bool solves_motion = false;
};

/// f(q, t) = 0, or phi(q, v, t) = 0 affine in v. Along the motion dr/dt = -damping r - stiffness f,
/// r = df/dt or phi (see Constraint).
struct ConstraintEquation {
  GiNaC::ex value;
  bool is_position = true;
  GiNaC::ex damping = 0;    ///< 2 zeta omega
  GiNaC::ex stiffness = 0;  ///< omega^2 for f(q, t), 0 for phi
  Entity origin = {};
};

/// A held variable. `values` has s(t) for a locked coordinate, a constant unit quaternion for a
/// locked rotation, and the parameter that is the momentum for a cyclic coordinate.
struct HeldCoordinateMotion : HeldCoordinate {
  std::vector<GiNaC::ex> values = {};
};

struct Lagrangian;

/// The data from which the forces that hold locked coordinates are derived: the Lagrangian in which
/// these coordinates still move, and their motion. `unreduced` and the Lagrangian without these
/// coordinates share one list of definitions.
struct ReactionSource {
  std::shared_ptr<const Lagrangian> unreduced = {};
  /// q, v and a of the locked variables -> functions of time; each held input -> 0.
  ExpressionMap<GiNaC::ex> values = {};
  /// Indices, in `unreduced`, of the velocities whose holding force the output `reaction` returns.
  std::vector<std::uint32_t> velocities = {};
};

/// A leaf in which energies and forces are expanded: leaf - value is small.
struct SmallLeaf {
  GiNaC::ex leaf;
  GiNaC::ex value;
};

/// The expansion that specialise() makes in the deviations of all small leaves. Energies are
/// expanded to the joint order `order` + 1. Forces on small coordinates are expanded to `order`,
/// all other forces to `order` + 1.
struct Expansion {
  std::uint32_t order = 1;
  std::vector<SmallLeaf> small = {};
};

/// The source of a term of an energy.
enum class EnergyOrigin : std::uint8_t {
  energy,    ///< a term of `[energy]`
  spin,      ///< 1/2 w.I w of a body outside frames
  armature,  ///< 1/2 J v^2
  mass,      ///< 1/2 m |dp/dt|^2 or -m gravity.p of a point mass; added by specialise()
  momentum   ///< -1/2 w.v_c of Routh's function (derive/specialise/routh.cpp)
};

struct EnergyTerm {
  GiNaC::ex value;
  EnergyOrigin origin = EnergyOrigin::energy;
};
using EnergyTerms = std::vector<EnergyTerm>;

[[nodiscard]] std::vector<GiNaC::ex> values_of(const EnergyTerms& terms);

struct Lagrangian {
  Symbols symbols = {};
  LeafNames leaves = {};
  Definitions definitions = {};
  std::vector<PointMass> masses = {};
  std::optional<std::array<GiNaC::ex, 3>> gravity = {};
  EnergyTerms kinetic = {};      ///< terms of T that `masses` and `tree` do not contain
  EnergyTerms potential = {};    ///< terms of V that `masses` and `tree` do not contain
  EnergyTerms dissipation = {};  ///< terms of D
  EnergyTerms lagrangian = {};  ///< terms of L instead of T and V, if the file or `[routh]` gives L
  /// The generalised force on each velocity, inputs included; without -dD/dv, `point_forces` and
  /// the wrenches of `tree`.
  std::vector<GiNaC::ex> forces = {};
  std::vector<PointForce> point_forces = {};
  /// For the regressor: the data of terms that `kinetic` already contains. `armatures` has J of
  /// 1/2 J v_i^2 for each velocity v_i, or 0 without an armature.
  std::vector<RotatingBody> rotating_bodies = {};
  std::vector<GiNaC::ex> armatures = {};
  std::vector<InertialParameter> inertial = {};  ///< pi of the model without held variables
  /// The tree of frames. Under an expansion or `[routh]`, only the twists of outputs use `tree`.
  FrameTree tree = {};
  std::vector<ConstraintEquation> constraints = {};
  std::vector<NamedOutput> outputs = {};
  std::vector<GiNaC::ex> cyclic_rates = {};  ///< rates of the eliminated cyclic coordinates
  std::optional<ReactionSource> reaction_source = {};  ///< none: no lock has a reaction
  std::optional<Expansion> expansion = {};
  bool is_quadratic = true;
  bool eliminates_last_first = false;  ///< true: eliminates M from the last velocity to the first
};

/// A Lagrangian in which all variables still move, with the variables that specialise() removes.
struct UnreducedLagrangian : Lagrangian {
  std::vector<HeldCoordinateMotion> locked = {};
  std::vector<std::uint32_t> held_inputs = {};  ///< indices of the inputs removed with the locks
  std::vector<HeldCoordinateMotion> cyclic = {};
};

/// Sets the name of the definition of `symbol` to `text`, unless the definition already has a name.
void name_definition(Definitions& definitions, const GiNaC::ex& symbol, const std::string& text);

/// Builds the Lagrangian of a checked model. E312: an expression divides by 0 at every state. E313:
/// an expression has no value at any state.
[[nodiscard]] Result<UnreducedLagrangian> formulate(const Model& model);

/// A value of an open function f or of a derivative of f, as a GiNaC function. Operands: the leaf
/// number of f; the number of arguments of f; the derivative as digits in ascending order (0: f,
/// 1: df/dx_1, 12: d2f/dx_1 dx_2); the arguments of f, padded with 0 to four.
// NOLINTNEXTLINE(readability-function-size): GiNaC takes every operand by itself.
DECLARE_FUNCTION_7P(elgen_open)

/// The number of the open value that `value`, a call of elgen_open, represents; none beyond second
/// derivatives.
[[nodiscard]] std::optional<std::uint32_t> open_value_number(const GiNaC::ex& value);

/// elgen_log1p, …: the functions that GiNaC lacks (its abs is complex), with their derivatives from
/// function_derivatives.def. Functions with kinks have no derivatives.
#define ELGEN_FUNCTION(name, arity)
#define ELGEN_STANDARD_FUNCTION(name, arity) DECLARE_FUNCTION_##arity##P(elgen_##name)
#define ELGEN_OWN_FUNCTION(name, arity) DECLARE_FUNCTION_##arity##P(elgen_##name)
#include "elgen/functions.def"
#undef ELGEN_FUNCTION

}  // namespace elgen
