// Lagrangian: T, V, D, Q over definitions; the owner of all symbols.
//
// A definition is a *small* GiNaC expression over leaves (q, v, a, u, t, parameters) and earlier
// definitions. Nothing is ever substituted into one big expression: derivatives go through the list
// by the chain rule, so their cost stays proportional to the cost of the energy itself.
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

/// Where a rotation stands in q and v.
struct RotationPlace {
  std::uint32_t first_coordinate = 0;
  std::uint32_t first_velocity = 0;
};

/// The leaves, in the order of declaration.
struct Symbols : LeafValues<GiNaC::ex> {
  std::vector<GiNaC::ex> q_rates = {};  ///< dq/dt, of q and v
  std::vector<RotationPlace> rotations = {};
};

struct Definition {
  GiNaC::ex symbol;
  GiNaC::ex value;
  std::string name;                 ///< C++ identifier for a reader ("bob_x"), or empty
  Entity origin;                    ///< the entry of the model that it came from
  std::vector<std::uint32_t> uses;  ///< indices of the definitions in `value`, ascending
  LeafSet depends = {};             ///< through `uses` too
  /// dvalue/dleaf of every leaf that it depends on, where `value` is a leaf itself, whose
  /// expression is not known here; else empty.
  std::vector<std::pair<GiNaC::ex, GiNaC::ex>> slopes = {};
};

struct ExpressionHash {
  std::size_t operator()(const GiNaC::ex& e) const { return e.gethash(); }
};
struct ExpressionEqual {
  bool operator()(const GiNaC::ex& a, const GiNaC::ex& b) const { return a.is_equal(b); }
};
template <class Value>
using ExpressionMap = std::unordered_map<GiNaC::ex, Value, ExpressionHash, ExpressionEqual>;

/// A symbol's place in elgen's own order: leaves first, as declared, then definitions.
struct SymbolPlace {
  bool is_definition = false;
  std::uint32_t index = 0;  ///< of the definition, or the rank of the leaf
  LeafSet depends = {};     ///< of a definition as there
};

/// The values being defined now, for the names of temporaries (derive/formulate/telling.hpp).
struct Wording {
  std::string kind = {};  ///< "moment"; "" tells nothing
  std::string frame = {};
  std::string axis = {};
};

/// Definitions by what they were when an output used them first: "moment_link5_y", and
/// "moment_link5_y_2", … of others that the same words are for.
struct ToldDefinitions {
  ExpressionMap<std::string> names = {};   ///< by symbol
  std::map<std::string, int> counts = {};  ///< of definitions with the same words
};

/// An ordered list of definitions; every value uses earlier ones only. Append by define().
struct Definitions {
  std::vector<Definition> list = {};
  ExpressionMap<SymbolPlace> places = {};  ///< of leaves and definitions
  ExpressionMap<GiNaC::ex> known_values =
      {};  ///< value -> symbol, so that one value is defined once
  Wording wording = {};
  ToldDefinitions told = {};  ///< of the output that is derived
};

/// How a new definition is called, and where it comes from.
struct Label {
  std::string name = {};
  Entity origin = {};
};

/// The symbol standing for `value`: `value` itself where it is a number, a symbol or a symbol's
/// negative; the symbol of an equal definition where there is one; otherwise a new definition.
GiNaC::ex define(Definitions& definitions, const GiNaC::ex& value, Label label = {});

/// Registers a leaf.
void add_leaf(Definitions& definitions, const GiNaC::ex& symbol, Opcode kind);

/// The leaves that `value` depends on.
[[nodiscard]] LeafSet dependence(const Definitions& definitions, const GiNaC::ex& value);

/// The symbols of `value`, each once, in elgen's order.
[[nodiscard]] std::vector<GiNaC::ex> symbols_of(const Definitions& definitions,
                                                const GiNaC::ex& value);

/// GiNaC expressions as text with terms and factors sorted and signs in one place, so that two runs
/// print the same although GiNaC orders by address. Leaves print under their names, definitions as
/// d0, d1, … in the order of the list.
[[nodiscard]] std::string expression_text(const Definitions& definitions, const GiNaC::ex& value);

/// One line per definition: `d3 = l*sin(theta)    ; bob_x`.
[[nodiscard]] std::string dump(const Definitions& definitions);

/// A point with a mass: adds 1/2 m |dp/dt|^2 to T, and -m gravity.p to V.
struct PointMass {
  GiNaC::ex mass;
  std::array<GiNaC::ex, 3> position;
  Entity origin;
};

/// The moments of inertia of a body outside of frames, about the axes of its angular velocity w:
/// adds 1/2 w.I w to T.
struct TurningBody {
  std::vector<GiNaC::ex> spin;     ///< w, or w_z
  std::vector<GiNaC::ex> inertia;  ///< xx yy zz xy xz yz, or zz
  Entity origin;
};

/// A force F in world axes at p: generalized force (dp/dq)^T F.
struct PointForce {
  std::array<GiNaC::ex, 3> position;
  std::array<GiNaC::ex, 3> force;
};

using ExVector3 = std::array<GiNaC::ex, 3>;

/// One elementary motion (see FrameStep): x_parent = R x + p, of which one is trivial.
struct TreeStep {
  std::optional<std::uint32_t> parent = {};  ///< the step before; none: the world
  FrameStepKind kind = FrameStepKind::translation;
  ExVector3 vector;  ///< p in the axes of the parent, or the unit axis of the turn
  GiNaC::ex angle = 0;
  std::array<GiNaC::ex, 4> quaternion;         ///< of any length; of a rotation of length one
  std::optional<std::uint32_t> rotation = {};  ///< of a rotation: its first velocity
  std::string name = {};                       ///< the frame's identifier
  Entity origin = {};
};

/// mass, com c and inertia (xx yy zz xy xz yz, empty for a point) in the axes after a step; the
/// inertia is about the origin there, or about the com. T = 1/2 m v_c^2 + 1/2 w.I_c w; about the
/// origin T = 1/2 m v^2 + v.(w x h) + 1/2 w.I w with h = m c.
struct RigidBody {
  std::optional<std::uint32_t> step = {};  ///< none: fixed to the world
  GiNaC::ex mass = 0;
  ExVector3 com;
  std::vector<GiNaC::ex> inertia = {};
  bool about_origin = false;
  /// h of an inertia about the origin, where derivation gave the body one that is no m c.
  std::optional<ExVector3> moment = {};
  Entity origin = {};
};

/// A force through the point `at` (axes after `step`) and a moment, acting on what moves with
/// `step`; force and moment have the axes after `axes` (none: the world).
struct Wrench {
  std::optional<std::uint32_t> step = {};
  std::optional<std::uint32_t> axes = {};
  ExVector3 at;
  ExVector3 force;
  ExVector3 moment;
};

/// Frames as a tree of elementary motions, parents first, and what moves with them.
struct FrameTree {
  std::vector<TreeStep> steps = {};
  std::vector<RigidBody> bodies = {};
  std::vector<Wrench> wrenches = {};
};

/// The twist (angular velocity; velocity of the origin) of what moves with a step.
struct TwistOutput {
  std::optional<std::uint32_t> step = {};  ///< none: the world, at rest
  bool in_world = true;                    ///< axes; otherwise those after the step
};

struct NamedOutput {
  std::string name;
  std::vector<GiNaC::ex> values;
  std::optional<TwistOutput> twist = {};
  bool motion = false;  ///< accelerations and multipliers are those of the motion
};

/// f(q, t) = 0, or phi(q, v, t) = 0 affine in v; along the motion its second rate, or its rate, is
/// -damping r - stiffness f (see Constraint).
struct ConstraintEquation {
  GiNaC::ex value;
  bool is_position = true;
  GiNaC::ex damping = 0;    ///< 2 zeta omega
  GiNaC::ex stiffness = 0;  ///< omega^2, of a position
  Entity origin = {};
};

/// A variable held at functions of time: s(t), or the four of a unit quaternion. A cyclic one is
/// held at its momentum, a parameter.
struct HeldVariable : Held {
  std::vector<GiNaC::ex> values = {};
};

struct Lagrangian;

/// The source of the forces that hold locked coordinates: the Lagrangian in which they still move
/// (its definitions are those of the one that has this), and where they stand.
struct Holding {
  std::shared_ptr<const Lagrangian> whole = {};
  ExpressionMap<GiNaC::ex> values = {};        ///< q, v, a -> functions of time
  std::vector<std::uint32_t> velocities = {};  ///< of `whole`, held by a force that is wanted
};

/// A leaf whose deviation from a value is small.
struct SmallLeaf {
  GiNaC::ex leaf;
  GiNaC::ex value;
};

/// The expansion by specialise: energies to order + 1 jointly in all deviations, forces to order;
/// those on coordinates that are not small to order + 1.
struct Expansion {
  std::uint32_t order = 1;
  std::vector<SmallLeaf> small = {};
};

/// The source of a term of the energies.
enum class EnergyOrigin : std::uint8_t {
  energy,    ///< `[energy]`
  spin,      ///< 1/2 w.I w of a body outside of frames
  armature,  ///< 1/2 J v^2
  mass,      ///< 1/2 m |dp/dt|^2 and -m gravity.p, written by specialise
  momentum   ///< -1/2 w.v_c, written by specialise for `[routh]`
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
  EnergyTerms kinetic = {};      ///< further terms of T
  EnergyTerms potential = {};    ///< further terms of V
  EnergyTerms dissipation = {};  ///< terms of D
  EnergyTerms lagrangian = {};  ///< terms of L instead of T and V, if the file or `[routh]` gives L
  std::vector<GiNaC::ex> forces = {};  ///< generalized force on each velocity, inputs included
  std::vector<PointForce> point_forces = {};
  /// The parts of these terms, for the regressor: J by velocity, 0 where there is none.
  std::vector<TurningBody> turning_bodies = {};
  std::vector<GiNaC::ex> armatures = {};
  std::vector<InertialParameter> inertial = {};  ///< of the model without what it holds
  FrameTree tree = {};  ///< of an expansion or R it carries nothing but outputs
  std::vector<ConstraintEquation> constraints = {};
  std::vector<NamedOutput> outputs = {};
  std::vector<GiNaC::ex> cyclic_rates = {};  ///< of those that specialise took out
  std::optional<Holding> holding = {};       ///< where a reaction is wanted
  std::optional<Expansion> expansion = {};
  bool quadratic = true;
  bool eliminates_last_first = false;  ///< order of elimination of M; see Model
};

/// A Lagrangian in which everything still moves, with the variables that specialise() takes out.
struct WholeLagrangian : Lagrangian {
  std::vector<HeldVariable> locked = {};
  std::vector<std::uint32_t> held_inputs = {};  ///< that act on locked variables alone
  std::vector<HeldVariable> cyclic = {};
};

/// Gives a definition a name, where it has none yet.
void name(Definitions& definitions, const GiNaC::ex& symbol, const std::string& text);

/// Builds the Lagrangian of a checked model. E502: dot() of something that contains rates.
[[nodiscard]] Result<WholeLagrangian> formulate(const Model& model);

/// A value of an open function in GiNaC: the number of its undifferentiated value among the leaves,
/// how many arguments it has, the digits of the derivative (0, 1, 12), and four arguments, those
/// that the function does not have being 0. Derivatives insert a digit, in ascending order.
// NOLINTNEXTLINE(readability-function-size): GiNaC takes every operand by itself.
DECLARE_FUNCTION_7P(elgen_open)

/// The number of the leaf that an elgen_open is; none beyond second derivatives.
[[nodiscard]] std::optional<std::uint32_t> open_leaf(const GiNaC::ex& value);

/// elgen_log1p, …: the functions that are not taken from GiNaC, with the derivatives of the table.
/// GiNaC has abs of complex numbers. Functions with kinks have no derivatives.
#define ELGEN_FUNCTION(name, arity)
#define ELGEN_STANDARD_FUNCTION(name, arity) DECLARE_FUNCTION_##arity##P(elgen_##name)
#define ELGEN_OWN_FUNCTION(name, arity) DECLARE_FUNCTION_##arity##P(elgen_##name)
#include "elgen/functions.def"
#undef ELGEN_FUNCTION

}  // namespace elgen
