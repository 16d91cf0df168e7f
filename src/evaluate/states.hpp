// The states programs are checked at: random ones over the declared ranges, tiny and huge ones, and
// a fixed list of extremes. Deterministic for a seed.
#pragma once

#include <string>
#include <vector>

#include "evaluate/subject.hpp"

namespace elgen {

enum class Region : std::uint8_t {
  nominal,  ///< uniform over the ranges; parameters at their value
  small,    ///< magnitudes 1e-12 … 1e-3
  large,    ///< magnitudes 1e-8 … 1e8
  extreme,  ///< ends of ranges, denormals, big angles and rates, parameter ratios, singular charts,
            ///< and ratios together with angles at which sums cancel
};

template <class Scalar>
struct SampledState {
  Region region = Region::nominal;
  std::string name = {};  ///< of an extreme: "rates 1e+60"
  Arguments<Scalar> values = {};
};

/// About 0.618 of `count` and without a divisor in common with it: taken again and again it meets
/// all regions, which take turns, and the extremes, which come last. The first state is ordinary.
[[nodiscard]] std::size_t golden_step(std::size_t count);

struct Sampling {
  /// Of random states: half nominal, a quarter small, a quarter large. There are at most as many
  /// extremes of parameters together with angles.
  std::size_t count = 256;
  std::uint64_t seed = 1;
  bool extremes = true;
};

/// A scene that drops terms is sampled inside the ranges only, parameters too: elsewhere it
/// promises nothing. A missing range is [-pi, pi] for coordinates in rad, [-1, 1] for others, [-10,
/// 10] for rates, accelerations, inputs and time. Scalar: double or float; the list of extremes is
/// the scalar's own.
template <class Scalar>
[[nodiscard]] std::vector<SampledState<Scalar>> sample_states(const Subject& subject,
                                                              const Sampling& sampling);

}  // namespace elgen
