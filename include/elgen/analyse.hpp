// Analysis: where a system can be at rest, whether it stays there, how it moves about that, and
// what its symmetries keep.
//
//     equilibria    r(q) = bias(q, 0) - B(q) u = 0, u given
//     stability     K = dr/dq,  W = V0 - T0
//     modes         M x'' + K x = 0 about a point,  K x = w^2 M x
//     poles         of d(dx)/dt = A dx + B du
//     symmetries    dL = dF/dt under dq = A q + b + c t, dt constant
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

/// The arguments of an analysis that starts from the Lagrangian.
struct AnalysisInput {
  const CheckedModel& checked;
  const Program& recursive;  ///< the functions of AnalysisRow::outputs
  /// An [[equilibrium]] of the model, or with an empty name the start of the coordinates: the only
  /// point that is analysed. None: all equilibria.
  const std::optional<std::string>& about;
  const Limits& limits;
};

/// Where a coordinate is looked for.
enum class SearchKind : std::uint8_t {
  none,   ///< the equations at rest, at these parameters, do not hold it: it is any number
  turn,   ///< only in e^(i k q), k integers: modulo 2 pi, in the range where that is less
  range,  ///< the range that the model declares
  start,  ///< a rotation, or a coordinate that one shares an equation with: about its start
};

struct CosineAndSine {
  Fraction cosine = {};
  Fraction sine = {};
};

/// The value of a coordinate at an equilibrium: any, or a number of 64 digits, with its closed form
/// where that is known to hold for all values of the parameters at which it is defined. One that is
/// any has the value at which it stands.
struct CoordinateAtRest {
  bool is_any = false;
  cln::cl_R value = 0;
  std::optional<Fraction> form = {};
  /// The cosine or sine of an angle that exists where this is in [-1, 1], and both of them.
  std::optional<Fraction> sinusoid = {};
  std::optional<CosineAndSine> sinusoids = {};
};

enum class Stability : std::uint8_t {
  minimum,             ///< W has a strict minimum, nothing drives, D does not: stable
  degenerate_minimum,  ///< the same, though K is 0 along one coordinate
  decaying,            ///< all poles have negative real parts: stable
  unstable,            ///< a pole has a positive real part
  open,                ///< the linear part does not decide
};

[[nodiscard]] inline bool is_stable(Stability kind) {
  return kind != Stability::unstable && kind != Stability::open;
}

/// The first term of W along the coordinate in which K is 0: coefficient (q - q0)^order.
struct LeadingTerm {
  std::uint32_t coordinate = 0;
  std::uint32_t order = 0;
  Fraction coefficient = {};
};

struct StabilityVerdict {
  Stability kind = Stability::open;
  std::vector<double> growth_rates = {};  ///< 1/s, descending: positive real parts of poles
  bool is_degenerate = false;             ///< K is exactly singular
  std::optional<LeadingTerm> leading = {};
};

/// A point of rest with its linear equations M x'' + (G + D) x' + K x = B du; matrices row-major,
/// n x n for n velocities, B n x inputs, in 64 digits.
struct RestPoint {
  State state = {};  ///< v = 0, a = 0, u as given
  std::vector<CoordinateAtRest> coordinates = {};
  bool is_exact = true;  ///< r is 0 there for all values of the parameters, by closed forms
  std::vector<cln::cl_R> mass = {};
  std::vector<cln::cl_R> stiffness = {};
  std::vector<cln::cl_R> damping = {};  ///< d bias/dv at v = 0: gyroscopic terms among it
  std::vector<cln::cl_R> input_matrix = {};
  StabilityVerdict stability = {};
};

/// The value of a coordinate where r = 0 and M is singular.
struct ChartBreak {
  std::uint32_t coordinate = 0;
  CoordinateAtRest at = {};
};

/// Values of coordinates that share equations, which may hold an equilibrium that is not listed.
using UndecidedBox = std::map<std::uint32_t, Interval>;

/// How far a list of equilibria is known to be complete, at the values of the parameters.
enum class Completeness : std::uint8_t {
  proved,     ///< there are no others
  undecided,  ///< there are no others but in the undecided boxes
  searched,   ///< some were found from starts; there may be others, in the undecided boxes if any
};

struct Equilibria {
  ClosedForms forms = {};  ///< of r, M and W at rest: their algebra holds all forms below
  std::vector<SearchKind> kinds = {};    ///< by coordinate
  bool has_rest_kinetic_energy = false;  ///< T0 is not 0
  std::vector<RestPoint> points = {};
  std::vector<ChartBreak> breaks = {};  ///< inside and outside of ranges
  Completeness completeness = Completeness::proved;
  std::vector<UndecidedBox> undecided = {};
  std::uint64_t boxes = 0;   ///< that were looked at
  std::uint64_t starts = 0;  ///< of iterations
  std::string limit = {};    ///< that ended the search: "enclosures=420000000"
  std::vector<cln::cl_R> inputs = {};
  bool is_given = false;  ///< the input named the only point; the others are not looked for
};

/// The requests of the functions that equilibria need of a model.
[[nodiscard]] std::vector<OutputRequest> outputs_of_equilibria(const Model& model);

/// All equilibria at the values of the parameters that the scene has and at which M is regular, or
/// the given point; `recursive` has the functions of outputs_of_equilibria. Inputs are 0, or at
/// their laws. E530, E531; of a given point E201, and E532: the forces do not balance there. Cost:
/// at most limits.boxes boxes, and limits.enclosures.
[[nodiscard]] Result<Equilibria> find_equilibria(const AnalysisInput& input);

/// A motion x = shape sin(w t + phase) about a point of rest, or for w^2 < 0 one that grows.
struct NormalMode {
  cln::cl_R omega_squared = 0;     ///< 1/s^2
  std::vector<double> shape = {};  ///< by velocity; the largest component is 1, the first of equals
  std::size_t multiplicity = 1;    ///< modes with this w^2: their shapes span a space
};

/// The linear motions about a point of rest: d(dx)/dt = A dx + B du with x = (q, v).
struct LinearMotions {
  RestPoint point = {};
  std::vector<NormalMode> modes = {};  ///< w^2 ascending; none where damping or Q act on v
  std::vector<std::complex<double>> poles = {};  ///< 1/s, the fastest first
  std::vector<double> a = {};                    ///< 2n x 2n, row-major
  std::vector<double> b = {};                    ///< 2n x inputs
  std::size_t controllable = 0;  ///< least rank of [A - pole 1, B]: 2n where u reaches all states
};

/// The linear motions about some points of rest.
struct Modes {
  ClosedForms forms = {};                   ///< those of the equilibria
  std::vector<cln::cl_R> inputs = {};       ///< at rest
  std::vector<LinearMotions> motions = {};  ///< of each point
};

/// Motions about the given point, or about the stable equilibria. E532: no equilibrium is known to
/// be stable; E533: M has no inverse.
[[nodiscard]] Result<Modes> find_modes(const CheckedModel& checked, const Equilibria& equilibria);

/// The sort of a symmetry.
enum class SymmetryKind : std::uint8_t {
  coordinate,   ///< one coordinate moves alone
  translation,  ///< several move by constants
  boost,        ///< they move by constants times t
  rotation,     ///< A is skew, the rest is 0
  turn,         ///< rotations turn
  other,
  time,  ///< t alone moves
};

/// A change dq = A q + b + c t with a constant dt, of a rotation a turn R^T s + b, for which
/// dL = dF/dt. So dI/dt = (dq - v dt).(B u + Q - dD/dv) with I = dL/dv.dq - E dt - F (Noether). Of
/// the kind `time` I has the other sign: it is E + F.
struct Symmetry {
  SymmetryKind kind = SymmetryKind::other;
  std::vector<Fraction> generator = {};     ///< A by rows, c, b, s and b of each rotation, dt
  std::vector<Fraction> displacement = {};  ///< dq along every velocity
  Fraction by_names = {};                   ///< I + F over the leaves momentum and energy
  std::optional<Fraction> closed = {};      ///< the same in closed form
  std::optional<Fraction> total = {};       ///< F, for `time` -F; none: it has no closed form
  std::optional<Fraction> loss = {};        ///< dI/dt at u = 0, where known
  std::optional<Fraction> rate = {};        ///< dI/dt
  bool is_rounded = false;                  ///< the generator has six digits
  bool is_special = false;                  ///< none at other values of the parameters
  bool is_proved = false;                   ///< dL = dF/dt is, by closed forms
};

struct Symmetries {
  ClosedForms forms = {};    ///< their algebra holds all forms below
  std::size_t unknowns = 0;  ///< of the class
  bool is_exact = false;     ///< found by closed forms, for generic parameters
  bool is_complete = false;  ///< and no relation between functions was left out
  std::size_t states = 0;    ///< at which was sampled
  std::size_t sampled = 0;   ///< the number at the values of the parameters
  std::optional<std::size_t> sampled_elsewhere = {};  ///< at random values, where it is needed
  bool loses_energy = false;                          ///< E is conserved, T + V is not
  std::vector<Symmetry> all = {};
};

/// The functions that symmetries need of a model: their requests.
[[nodiscard]] std::vector<OutputRequest> outputs_of_symmetries(const Model& model);

/// A basis of the symmetries of L alone: forces, dissipation and inputs are taken off. `recursive`
/// has the functions of outputs_of_symmetries. E910: the class has more than 500 unknowns.
/// Cost: 3 n + 1 derivatives of R; closed forms within budgets of 4e6 term products, samples at up
/// to four sets of parameters.
[[nodiscard]] Result<Symmetries> find_symmetries(const AnalysisInput& input);

/// The evidence for a claim.
enum class ClaimStatus : std::uint8_t {
  proved,   ///< by closed forms, for all values of the parameters
  sampled,  ///< right at random values of the parameters
  wrong,
  open,  ///< no values of the parameters were found at which it can be judged
};

/// An [[equilibrium]] of a model: bias(q, 0) = B u there, and det(x M - K)/det M is the product of
/// x - w^2 over its frequencies.
struct JudgedEquilibrium {
  std::string name = {};
  ClaimStatus balance = ClaimStatus::open;
  std::optional<ClaimStatus> frequencies = {};  ///< none: the model states none
  std::string witness = {};                     ///< a state at which it is wrong
};

/// In the order of the model; empty where a scene expands the equations, or functions are open.
[[nodiscard]] std::vector<JudgedEquilibrium> judge_equilibria(const CheckedModel& checked,
                                                              const Program& recursive);

}  // namespace elgen
