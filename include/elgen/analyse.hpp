// Analysis: equilibria of a system, their stability, small motions about them, and symmetries.
//
//     equilibria    r(q) = bias(q, 0) - B(q) u = 0, u given
//     stability     K = dr/dq,  W = V0 - T0,  V0 and T0 the energies at v = 0
//     modes         M x'' + K x = 0,  K x = w^2 M x,  x a small displacement from rest
//     poles         eigenvalues of A in d(dx)/dt = A dx + B du,  dx a small change of (q, v)
//     symmetries    dL = dF/dt under dq = A q + b + c t,  dt constant (Noether)
#pragma once

#include <cln/real.h>

#include <complex>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "elgen/closed_forms.hpp"
#include "elgen/diagnostic.hpp"
#include "elgen/limits.hpp"
#include "elgen/model.hpp"
#include "elgen/oracle.hpp"
#include "elgen/program.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// The arguments of an analysis that needs no result of another analysis.
struct AnalysisInput {
  const CheckedModel& checked;
  const Program& recursive;  ///< recursive forms of the outputs of AnalysisRow::outputs
  /// The name of the only [[equilibrium]] to analyse. An empty name means the point at the start of
  /// the coordinates. None: all equilibria are analysed.
  const std::optional<std::string>& equilibrium_name;
  const Limits& limits;
};

/// The range in which equilibria are searched along a coordinate.
enum class SearchKind : std::uint8_t {
  none,   ///< no range: at these parameters no equation at rest contains the coordinate
  turn,   ///< one turn, or the declared range if it is narrower: the equations contain the
          ///< coordinate q only in e^(i k q), k integer
  range,  ///< the range that the model declares
  start,  ///< no range, only the start: for rotations, and for coordinates that share an equation
          ///< with a rotation
};

struct CosineAndSine {
  Fraction cosine = {};
  Fraction sine = {};
};

/// The value of a coordinate at an equilibrium, in 64 digits. `closed_form` is a closed form of the
/// value, valid at all values of the parameters at which the form is defined; none if no closed
/// form was found. If `is_arbitrary` is set, no equation at rest contains the coordinate, and
/// `value` is the start of the coordinate.
struct RestCoordinate {
  bool is_arbitrary = false;
  cln::cl_R value = 0;
  std::optional<Fraction> closed_form = {};
  /// If `closed_form` contains acos or asin: the argument of this function, which has to be in [-1,
  /// 1].
  std::optional<Fraction> inverse_argument = {};
  /// If `closed_form` contains acos or asin: the cosine and sine of the coordinate.
  std::optional<CosineAndSine> cosine_and_sine = {};
};

enum class Stability : std::uint8_t {
  minimum,  ///< stable: W has a strict minimum, L does not contain t, all forces are constant, and
            ///< the damping matrix D is positive semidefinite
  degenerate_minimum,  ///< stable: as `minimum`, but K is 0 along some coordinates
  decaying,            ///< stable: all poles have negative real parts
  unstable,            ///< unstable: a pole has a positive real part
  undecided,           ///< undecided: the linear equations do not determine the stability
};

[[nodiscard]] inline bool is_stable(Stability kind) {
  return kind != Stability::unstable && kind != Stability::undecided;
}

/// The leading term of W - W(q0) along a coordinate q, if K is 0 along q:
/// coefficient (q - q0)^order. q0 is the value of q at the point of rest.
struct LeadingTerm {
  std::uint32_t coordinate = 0;  ///< index of q in the coordinates
  std::uint32_t order = 0;
  Fraction coefficient = {};
};

struct StabilityVerdict {
  Stability kind = Stability::undecided;
  std::vector<double> growth_rates = {};  ///< positive real parts of the poles, in 1/s
  bool is_degenerate = false;             ///< true: K is exactly singular
  std::optional<LeadingTerm> leading = {};
};

/// A point of rest with its linear equations M x'' + (G + D) x' + K x = B du. For n velocities, M,
/// G + D and K are n x n, and B is n x inputs. All matrices are row-major, in 64 digits.
struct RestPoint {
  State state = {};  ///< the state at rest: v = 0, a = 0, u = Equilibria::inputs
  std::vector<RestCoordinate> coordinates = {};
  bool is_exact = true;  ///< true: closed forms prove r = 0 for all values of the parameters
  std::vector<cln::cl_R> mass = {};
  std::vector<cln::cl_R> stiffness = {};
  std::vector<cln::cl_R> damping = {};  ///< G + D = d bias/dv at v = 0
  std::vector<cln::cl_R> input_matrix = {};
  StabilityVerdict stability = {};
};

/// The index of a coordinate, and its value at a point with r = 0 and a singular M.
struct ChartSingularity {
  std::uint32_t coordinate = 0;
  RestCoordinate value = {};
};

/// A box that the search leaves undecided: index of a coordinate -> interval, for some coordinates
/// that share equations. The list of equilibria may lack an equilibrium inside the box.
using UndecidedBox = std::map<std::uint32_t, Interval>;

/// Whether a list of equilibria is complete at the values of the parameters.
enum class Completeness : std::uint8_t {
  proved,     ///< no other equilibrium exists in the search ranges
  undecided,  ///< any other equilibrium is inside one of the `undecided_boxes`
  searched,   ///< Newton's method found some equilibria from starts; others may exist anywhere
};

struct Equilibria {
  /// The closed forms of r, M and W at rest. All Fractions below are over forms.algebra.
  ClosedForms forms = {};
  std::vector<SearchKind> kinds = {};    ///< kind of the search range of each coordinate
  bool has_rest_kinetic_energy = false;  ///< false: T = 0 at v = 0 is proved
  std::vector<RestPoint> points = {};
  /// Values of coordinates at which M is singular, inside and outside the search ranges.
  std::vector<ChartSingularity> chart_singularities = {};
  Completeness completeness = Completeness::proved;
  std::vector<UndecidedBox> undecided_boxes = {};
  std::uint64_t boxes = 0;   ///< number of boxes that the search examined
  std::uint64_t starts = 0;  ///< number of starts of Newton's method
  /// The limit that ended the search: "enclosures=420000000"; "" if no limit ended the search.
  std::string limit = {};
  std::vector<cln::cl_R> inputs = {};  ///< u at all points of rest
  /// True: `points` has only the point that AnalysisInput::equilibrium_name selects.
  bool has_given_point = false;
};

/// The requests of the functions that find_equilibria() needs.
[[nodiscard]] std::vector<OutputRequest> outputs_for_equilibria(const Model& model);

/// All equilibria with a regular M at the parameter values of the scene, or only the given point.
/// input.recursive has the functions of outputs_for_equilibria(). Inputs are 0 or the values of
/// their laws. Errors: E530, E531, E606 (a law is no number at rest), E910 (more than 256
/// equilibria). For a given point: E201, and E532 if the point has no value or the forces do not
/// balance. Cost: at most limits.boxes boxes and limits.enclosures interval operations.
[[nodiscard]] Result<Equilibria> find_equilibria(const AnalysisInput& input);

/// A motion x = shape sin(w t + phase) about a point of rest. If w^2 < 0, the motion grows or
/// decays instead.
struct NormalMode {
  cln::cl_R omega_squared = 0;  ///< w^2 in 1/s^2
  /// One component per velocity, scaled so that the largest is 1 (the first, if several are
  /// largest).
  std::vector<double> shape = {};
  /// Number of modes with this w^2; only the span of the shapes of these modes is unique.
  std::size_t multiplicity = 1;
};

/// The linear motions about a point of rest: d(dx)/dt = A dx + B du, x = (q, v).
struct LinearMotions {
  RestPoint point = {};
  /// In ascending order of w^2; empty if G + D is not 0 or K is not symmetric.
  std::vector<NormalMode> modes = {};
  std::vector<std::complex<double>> poles = {};  ///< poles in 1/s, by descending magnitude
  std::vector<double> a = {};                    ///< A, 2n x 2n for n velocities, row-major
  std::vector<double> b = {};                    ///< B, 2n x inputs, row-major
  /// The least rank of [A - p I, B] over the poles p, with the 2n x 2n unit matrix I. The system is
  /// controllable if and only if this rank is 2n. 0 if the model has no inputs.
  std::size_t controllable_rank = 0;
};

/// The linear motions about some points of rest.
struct Modes {
  ClosedForms forms = {};                   ///< a copy of Equilibria::forms
  std::vector<cln::cl_R> inputs = {};       ///< u at the points of rest
  std::vector<LinearMotions> motions = {};  ///< one entry for each point of rest
};

/// The linear motions about the given point of `equilibria`, or about every stable equilibrium.
/// E532: no equilibrium is known to be stable. E533: M is not positive definite.
[[nodiscard]] Result<Modes> find_modes(const CheckedModel& checked, const Equilibria& equilibria);

/// The kind of a symmetry (see Symmetry), by the parts of its generator that are not 0.
enum class SymmetryKind : std::uint8_t {
  coordinate,     ///< only b, a unit vector: one coordinate shifts
  translation,    ///< only b: several coordinates shift by constants
  boost,          ///< only c: coordinates shift by constants times t
  rotation,       ///< only A, which is skew
  body_rotation,  ///< only s and sigma of rotation variables
  other,          ///< any other combination
  time,           ///< only dt
};

/// A change dq = A q + b + c t of the coordinates, with a constant dt, for which dL = dF/dt. A
/// rotation variable, with the matrix R from body to world axes, turns by R^T s + sigma in body
/// axes: s is a constant turn in world axes, sigma a constant turn in body axes. By Noether's
/// theorem,
///
///     I = dL/dv.dq - E dt - F,   dI/dt = (dq - v dt).(B u + Q - dD/dv)
///
/// For the kind `time` the sign of I is reversed, I = E + F, and so are the signs of
/// `momentum_form`, `velocity_form`, `gauge_function`, `unforced_rate` and `rate`.
struct Symmetry {
  SymmetryKind kind = SymmetryKind::other;
  std::vector<Fraction> generator = {};        ///< A by rows; c; b; s, sigma of each rotation; dt
  std::vector<Fraction> displacement = {};     ///< dq, one entry per velocity
  Fraction momentum_form = {};                 ///< I + F, over the leaves p and E instead of v
  std::optional<Fraction> velocity_form = {};  ///< I + F in closed form; none if no form is known
  /// F of dL = dF/dt; -F for the kind `time`; none if F has no closed form.
  std::optional<Fraction> gauge_function = {};
  std::optional<Fraction> unforced_rate = {};  ///< dI/dt at u = 0; none if it has no closed form
  std::optional<Fraction> rate = {};           ///< dI/dt; none if it has no closed form
  bool is_rounded = false;         ///< true: some entry of the generator is rounded to six digits
  bool is_at_values_only = false;  ///< true: dL = dF/dt only at the parameter values of the scene
  bool is_proved = false;          ///< true: closed forms prove dL = dF/dt
};

struct Symmetries {
  ClosedForms forms = {};    ///< all Fractions below are over forms.algebra
  std::size_t unknowns = 0;  ///< number of entries of a generator
  /// True: closed forms found the symmetries, for generic parameters. False: samples found the
  /// symmetries.
  bool is_exact = false;
  /// True: `symmetries` is complete, because closed forms use every relation between the functions
  /// in the equations.
  bool is_complete = false;
  std::size_t states = 0;  ///< number of states at which Lagrange's equations were sampled
  /// Number of symmetries found by samples at the parameter values of the scene.
  std::size_t sampled = 0;
  /// The number of symmetries found by samples at random parameters, the least over several sets of
  /// parameters. None if the list is complete.
  std::optional<std::size_t> sampled_elsewhere = {};
  bool loses_energy = false;  ///< true: E is conserved, but T + V is not
  std::vector<Symmetry> symmetries = {};
};

/// The requests of the functions that find_symmetries() needs.
[[nodiscard]] std::vector<OutputRequest> outputs_for_symmetries(const Model& model);

/// A basis of the symmetries of L; forces, dissipation and inputs are ignored. input.recursive has
/// the functions of outputs_for_symmetries(). E910: a generator has more than 500 entries. Cost for
/// n velocities: 3 n + 1 derivatives of the residual of Lagrange's equations; closed forms within
/// budgets of 4e6 term products; samples at up to four sets of parameters.
[[nodiscard]] Result<Symmetries> find_symmetries(const AnalysisInput& input);

/// The result of the check of a claim.
enum class ClaimStatus : std::uint8_t {
  proved,   ///< true for all values of the parameters, by closed forms
  sampled,  ///< true at random values of the parameters
  wrong,
  undecided,  ///< undecided: the claim has no value at any tried values of the parameters
};

/// The verdicts on the two claims of an [[equilibrium]]: bias(q, 0) = B u at the point; and
/// det(x M - K)/det M is the product of x - w^2 over the stated frequencies w.
struct EquilibriumVerdict {
  std::string name = {};
  ClaimStatus balance = ClaimStatus::undecided;
  std::optional<ClaimStatus> frequencies = {};  ///< none: the model states no frequencies
  std::string witness = {};  ///< a state at which the claim on frequencies is wrong
};

/// One verdict per [[equilibrium]], in the order of the model. Empty if a scene expands the
/// equations or a function is open.
[[nodiscard]] std::vector<EquilibriumVerdict> check_equilibria(const CheckedModel& checked,
                                                               const Program& recursive);

}  // namespace elgen
