// states: exact ones of a model, and those that programs are checked at: random ones over the
// declared ranges, tiny and huge ones, and a fixed list of extremes. Deterministic for a seed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "elgen/domain.hpp"
#include "elgen/oracle.hpp"
#include "elgen/real.hpp"
#include "sample/points.hpp"

namespace elgen {

/// Everything but parameters and h: in the declared range; else angles anywhere in a turn, and all
/// others, momenta among them, up to 1, 1e-3 or 1e3 in magnitude, in turn; quaternions of length 1.
/// Outside of its domain a model has no value, and callers draw again.
void draw_motion(const Model& model, Sampler& draw, std::size_t turn, State& state);

/// The same of a new state. Parameters that are not fixed have their own values in turn 0, zeros
/// too; else in even turns half to twice their value inside their range, or a positive number up to
/// 1 where that is 0; in odd turns any in the range, where one is declared.
[[nodiscard]] State drawn_state(const Model& model, const Scene& scene, Sampler& draw,
                                std::size_t turn);

/// Gives every quaternion the length 1, by the oracle.
void scale_to_length_one(const Model& model, State& state);

/// A state in which these leaves have these values, and quaternions the length 1. Momenta that are
/// not among them are those of the rates, where they have a value.
[[nodiscard]] State with_leaves(const Model& model, State state,
                                const std::vector<StatedLeaf>& leaves);

/// The state moved onto the constraints to all digits: one more step of Newton than a pose asks
/// for. The state itself without constraints; none if no steps lead there.
[[nodiscard]] std::optional<State> on_constraints(const Model& model, const State& state);

/// Whether values of an output are compared at states on the constraints. constraint_residual and
/// projected would be 0 and the state itself there.
[[nodiscard]] bool is_compared_on_constraints(const Model& model, OutputKind output);

/// The state at which values of such an output are compared, from a drawn state and the same on the
/// constraints: `completed` takes the rates that were drawn, and functions of momenta take the
/// momenta of the rates.
[[nodiscard]] State compared_state(const Model& model, OutputKind output, const State& drawn,
                                   State kept);

enum class Region : std::uint8_t {
  nominal,    ///< uniform over the ranges; parameters at their value
  near_zero,  ///< the same, but near a zero of a sum that was typed (verify/states)
  small,      ///< magnitudes 1e-12 … 1e-3
  large,      ///< magnitudes 1e-8 … 1e8
  extreme,  ///< ends of ranges, denormals, big angles and rates, parameter ratios, singular charts,
            ///< and ratios together with angles at which sums cancel
};

template <class Scalar>
struct SampledState {
  Region region = Region::nominal;
  std::string name = {};  ///< of an extreme: "rates 1e+60"
  LeafValues<Scalar> values = {};
};

/// About 0.618 of `count` and without a divisor in common with it: taken again and again it meets
/// all regions, which take turns, and the extremes, which come last. The first state is ordinary.
[[nodiscard]] std::size_t golden_step(std::size_t count);

struct Sampling {
  /// Random states: half nominal, a quarter small, a quarter large. There are at most as many
  /// extremes of parameters and angles.
  std::size_t count = 256;
  std::uint64_t seed = 1;
  bool extremes = true;
};

/// The ranges that the model declares; else the value of a parameter, a turn or a unit of a
/// coordinate, and 10 of rates, accelerations, inputs, open values and time.
[[nodiscard]] LeafValues<Range> ranges_of(const StateSpace& space);

/// Gives every quaternion the length 1, each component rounded once; (1, 0, 0, 0) where there is no
/// direction. Number: double or Real.
template <class Number>
void scale_quaternions(const Model& model, LeafValues<Number>& values);

/// Uniform inside these ranges, parameters at their values; quaternions of length 1.
[[nodiscard]] LeafValues<double> drawn_within(const StateSpace& space,
                                              const LeafValues<Range>& ranges, Sampler& draw);

/// The same rounded; what is finite in double stays so in float. Scalar: double or float.
template <class Scalar>
[[nodiscard]] LeafValues<Scalar> nearest_finite(const LeafValues<double>& values);

/// The states of sample_states one after another, where it is not known how many are needed.
template <class Scalar>
class StateSequence {
 public:
  /// The model, the scene and the leaves outlive it.
  StateSequence(const StateSpace& space, const Sampling& sampling);

  /// None where all have been given.
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
  std::optional<std::vector<SampledState<double>>> extremes_ = {};  ///< once it is their turn
};

/// A missing range is [-pi, pi] for coordinates in rad, [-1, 1] for others, [-10, 10] for rates,
/// accelerations, inputs, open values and time. Scalar: double or float; the list of extremes is
/// the scalar's own.
template <class Scalar>
[[nodiscard]] std::vector<SampledState<Scalar>> sample_states(const StateSpace& space,
                                                              const Sampling& sampling);

}  // namespace elgen
