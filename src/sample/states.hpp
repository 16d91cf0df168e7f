// states: exact states of a model, and the states at which programs are checked. These are random
// over the declared ranges, tiny or huge, and a fixed list of extremes. Deterministic for a seed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "elgen/domain.hpp"
#include "elgen/oracle.hpp"
#include "elgen/real.hpp"
#include "sample/points.hpp"

namespace elgen {

/// Draws everything except parameters and h, inside the declared range. Without a range: angles in
/// one turn, all others (also momenta) up to 1, 1e-3 or 1e3 in magnitude, in turn. Quaternions have
/// length 1. Outside of its domain a model has no value; then callers draw again.
void draw_motion(const Model& model, Sampler& draw, std::size_t turn, State& state);

/// A new state, with a motion of draw_motion. Parameters that are not fixed: in turn 0 their own
/// value. In even turns half to twice their value, clamped to their range; if the value is 0, a
/// positive number up to 1. In odd turns anywhere in the declared range; without a range as in even
/// turns.
[[nodiscard]] State drawn_state(const Model& model, const Scene& scene, Sampler& draw,
                                std::size_t turn);

/// Gives every quaternion the length 1, by the oracle.
void scale_to_length_one(const Model& model, State& state);

/// `state` with these leaves set, and quaternions of length 1. Momenta that are not set follow from
/// the rates, if they have a value.
[[nodiscard]] State with_leaves(const Model& model, State state,
                                const std::vector<StatedLeaf>& leaves);

/// The state moved onto the constraints to all digits, with one step of Newton's method more than a
/// pose needs. Without constraints the state itself; none if the method does not converge.
[[nodiscard]] std::optional<State> move_onto_constraints(const Model& model, const State& state);

/// True if an output is compared at states on the constraints. Not for constraint_residual and
/// projected, which would be 0 and the state itself.
[[nodiscard]] bool is_compared_on_constraints(const Model& model, OutputKind output);

/// The state at which such an output is compared, from a drawn state and the same state moved onto
/// the constraints (`kept`). `completed` takes the drawn rates; functions of momenta take the
/// momenta of the rates.
[[nodiscard]] State compared_state(const Model& model, OutputKind output, const State& drawn,
                                   State kept);

enum class Region : std::uint8_t {
  nominal,    ///< uniform over the ranges; parameters at their value
  near_zero,  ///< as nominal, but near a zero of a typed sum (verify/states)
  small,      ///< magnitudes 1e-12 … 1e-3
  large,      ///< magnitudes 1e-8 … 1e8
  extreme,  ///< ends of ranges, denormals, big angles and rates, parameter ratios, singular charts,
            ///< and ratios with angles at which sums cancel
};

template <class Scalar>
struct SampledState {
  Region region = Region::nominal;
  std::string name = {};  ///< of an extreme: "rates 1e+60"
  LeafValues<Scalar> values = {};
};

/// A number near 0.618 `count` without a common divisor. Steps of this size reach all regions,
/// which take turns, and the extremes, which come last. The first state is nominal.
[[nodiscard]] std::size_t golden_step(std::size_t count);

struct Sampling {
  /// Random states: half nominal, a quarter small, a quarter large. At most this many extremes
  /// combine parameters and angles.
  std::size_t count = 256;
  std::uint64_t seed = 1;
  bool extremes = true;
};

/// The ranges that the model declares. Without one: the value of a parameter, [-pi, pi] for angles,
/// [-1, 1] for other coordinates, [-10, 10] for all others; [0, 0.1] s for h.
[[nodiscard]] LeafValues<Range> ranges_of(const StateSpace& space);

/// Gives every quaternion the length 1, each component rounded once; (1, 0, 0, 0) if it is 0.
/// Number: double or Real.
template <class Number>
void scale_quaternions(const Model& model, LeafValues<Number>& values);

/// Uniform inside these ranges, with nominal parameters and quaternions of length 1.
[[nodiscard]] LeafValues<double> drawn_within(const StateSpace& space,
                                              const LeafValues<Range>& ranges, Sampler& draw);

/// The values rounded; a finite double stays finite in float. Scalar: double or float.
template <class Scalar>
[[nodiscard]] LeafValues<Scalar> nearest_finite(const LeafValues<double>& values);

/// The states of sample_states one by one, for callers that do not know how many they need.
template <class Scalar>
class StateSequence {
 public:
  /// The model, the scene and the leaves must outlive this.
  StateSequence(const StateSpace& space, const Sampling& sampling);

  /// None after the last state.
  [[nodiscard]] std::optional<SampledState<Scalar>> next();

 private:
  [[nodiscard]] std::optional<SampledState<double>> next_in_double();
  [[nodiscard]] SampledState<double> random_state(std::size_t number);

  StateSpace space_;
  Sampling sampling_;
  Sampler draw_;
  LeafValues<double> at_value_;
  LeafValues<Range> ranges_;
  std::size_t drawn_ = 0;
  std::optional<std::vector<SampledState<double>>> extremes_ = {};  ///< built on demand
};

/// All states of `sampling`, inside the ranges of ranges_of. Scalar: double or float; each has its
/// own list of extremes.
template <class Scalar>
[[nodiscard]] std::vector<SampledState<Scalar>> sample_states(const StateSpace& space,
                                                              const Sampling& sampling);

}  // namespace elgen
