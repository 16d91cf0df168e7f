// states: exact states of a model, and the states at which programs are checked: random states in
// the declared ranges, random tiny and huge states, and a fixed list of extreme states. All are
// deterministic for a seed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "elgen/domain.hpp"
#include "elgen/oracle.hpp"
#include "elgen/real.hpp"
#include "sample/points.hpp"

namespace elgen {

/// Draws all leaves of `state` except parameters and h, as rational numbers in their declared
/// ranges. Without a range, angles are in one turn, and all other leaves have a magnitude of up to
/// 1, 1e-3 or 1e3, for `turn` mod 3 = 0, 1, 2. Quaternions have length 1. The state may be outside
/// the domain of the model; then callers draw again.
void draw_motion(const Model& model, Sampler& draw, std::size_t turn, State& state);

/// A new state with leaves from draw_motion(). Parameters that the scene does not fix are
///
///     turn 0      their values
///     even turn   half to twice their value, clamped to their range; for a value 0, in (0, 1]
///     odd turn    anywhere in the declared range; without a range, as in even turns
[[nodiscard]] State draw_state(const Model& model, const Scene& scene, Sampler& draw,
                               std::size_t turn);

/// Scales every quaternion to length 1, to the digits of the oracle.
void normalize_state_quaternions(const Model& model, State& state);

/// `state` with `leaves` set, and quaternions scaled to length 1. Momenta that are not in `leaves`
/// are computed from the rates if they have a value; reference velocities are the rates.
[[nodiscard]] State with_leaves(const Model& model, State state,
                                const std::vector<LeafAssignment>& leaves);

/// The state moved onto the constraints by Newton's method. One step is added after convergence, so
/// that all digits are correct. Without constraints, the state itself; none if the method does not
/// converge.
[[nodiscard]] std::optional<State> move_onto_constraints(const Model& model, const State& state);

/// True if an output is compared at states that satisfy the constraints. False without constraints,
/// and for constraint_residual and projected, which would be 0 and the state itself.
[[nodiscard]] bool is_compared_on_constraints(const Model& model, OutputKind output);

/// The state at which an output with is_compared_on_constraints() is compared. `kept` is the state
/// `drawn` after move_onto_constraints(). For `completed` the result has the rates of `drawn`; for
/// functions of momenta, it has the momenta that belong to the rates.
[[nodiscard]] State compared_state(const Model& model, OutputKind output, const State& drawn,
                                   State kept);

enum class Region : std::uint8_t {
  nominal,    ///< uniform in the ranges; parameters have their values
  near_zero,  ///< as nominal, but near a minimum of V or a zero of a typed sum (verify/states)
  remote,     ///< as nominal, but coordinates without a range have magnitudes of up to 1e8
  small,      ///< magnitudes 1e-12 … 1e-3
  large,      ///< magnitudes 1e-8 … 1e8
  extreme,  ///< ends of ranges, denormals, large angles and rates, multiplied parameters, singular
            ///< charts, and multiplied parameters with angles at which sums cancel
};

template <class Scalar>
struct SampledState {
  Region region = Region::nominal;
  std::string name = {};  ///< name of an extreme state: "rates 1e+60"; else empty
  LeafValues<Scalar> values = {};
};

/// A step s close to 0.618 count, coprime to count. The indices 0, s, 2 s, … modulo count visit
/// each of `count` states once and are spread evenly. The first states of this sequence thus
/// include all regions, although the regions alternate and the extremes are last. State 0 is
/// nominal.
[[nodiscard]] std::size_t golden_step(std::size_t count);

struct SamplingOptions {
  /// Number of random states: half nominal, a quarter small, a quarter large. Also the largest
  /// number of extremes that combine a parameter with angles.
  std::size_t count = 256;
  std::uint64_t seed = 1;
  bool extremes = true;
};

/// The ranges of all leaves: the declared range, else the value of a parameter, [-pi, pi] for an
/// angle, [-1, 1] for another coordinate, [0, 0.1] s for h, and [-10, 10] for all other leaves.
[[nodiscard]] LeafValues<Range> ranges_of(const StateSpace& space);

/// Scales every quaternion to length 1; each component is rounded once. A quaternion 0 becomes
/// (1, 0, 0, 0). Number: double or Real.
template <class Number>
void normalize_quaternions(const Model& model, LeafValues<Number>& values);

/// A random state, uniform in `ranges`, with the parameters at their values and quaternions of
/// length 1.
[[nodiscard]] LeafValues<double> draw_in_ranges(const StateSpace& space,
                                                const LeafValues<Range>& ranges, Sampler& draw);

/// The values rounded to Scalar (double or float). Values beyond the range of Scalar become the
/// largest finite number of Scalar, with the sign of the value.
template <class Scalar>
[[nodiscard]] LeafValues<Scalar> round_to_finite(const LeafValues<double>& values);

/// Generates the states of sample_states() one by one, for callers that do not know in advance how
/// many they need.
template <class Scalar>
class StateSequence {
 public:
  /// The model, the scene and the leaf names must outlive this object.
  StateSequence(const StateSpace& space, const SamplingOptions& sampling);

  /// The next state; none after the last state.
  [[nodiscard]] std::optional<SampledState<Scalar>> next();

 private:
  [[nodiscard]] std::optional<SampledState<double>> next_in_double();
  [[nodiscard]] SampledState<double> random_state(std::size_t number);

  StateSpace space_;
  SamplingOptions sampling_;
  Sampler draw_;
  LeafValues<double> nominal_values_;
  LeafValues<Range> ranges_;
  std::size_t drawn_ = 0;
  std::optional<std::vector<SampledState<double>>> extremes_ = {};  ///< built on demand
};

/// All states of `sampling`; nominal states are in ranges_of(). Scalar is double or float, which
/// have different lists of extremes.
template <class Scalar>
[[nodiscard]] std::vector<SampledState<Scalar>> sample_states(const StateSpace& space,
                                                              const SamplingOptions& sampling);

/// States of Region::remote, every second at rest; none if all coordinates are bounded
/// (unbounded_coordinates()).
template <class Scalar>
[[nodiscard]] std::vector<SampledState<Scalar>> remote_states(const StateSpace& space,
                                                              std::uint64_t seed);

}  // namespace elgen
