// The symmetries at the values of the parameters: the conditions on a generator at random states in
// 160 digits. Every symmetry solves them, so that there are never fewer of
// these.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "analyse/generators.hpp"
#include "elgen/program.hpp"
#include "elgen/scene.hpp"
#include "numbers/echelon.hpp"
#include "program/evaluate/exact_values.hpp"

namespace elgen {

/// Digits beyond the 64 that Real has: 160 in all.
inline constexpr unsigned sampling_digits = 96;

/// Real numbers as those of generators.hpp.
using RealField = Operators<Real>;

struct SampledGenerators {
  std::vector<std::vector<cln::cl_R>> basis = {};
  std::vector<State> states = {};                 ///< at which they were found
  std::vector<std::vector<cln::cl_R>> rows = {};  ///< the conditions there
};

/// At random states with the parameters of one at rest. `moving` has the functions of
/// outputs_of_symmetries. None where too few states have a value. Cost: that of 3 n + 1 derivatives
/// of the inverse dynamics at each of (unknowns / n + 4) states, and an elimination.
[[nodiscard]] std::optional<SampledGenerators> sampled_generators(const CheckedModel& checked,
                                                                  const Program& moving,
                                                                  const State& resting);

/// Generators at up to three sets of random values of the parameters, but for those that are fixed.
/// Empty where they have no values. Cost: three times that of sampled_generators(), or up to 20
/// times where ranges leave the domain.
[[nodiscard]] std::vector<SampledGenerators> generators_elsewhere(const CheckedModel& checked,
                                                                  const Program& moving);

/// Whether a generator solves the conditions of others: those at other values of the parameters.
[[nodiscard]] bool solves(const SampledGenerators& sampled,
                          const std::vector<cln::cl_R>& generator);

/// The point of a state, with R there.
[[nodiscard]] MotionPoint<Real> sampled_point(ExactValues& values);

}  // namespace elgen
