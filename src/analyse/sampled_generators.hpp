// The symmetries at the values of the parameters, from conditions at random states in 160 digits.
// Every symmetry satisfies these conditions, so no symmetry is missed.
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

/// Digits beyond the 64 of Real: 160 in all.
inline constexpr unsigned sampling_digits = 96;

/// Real as the number type of generators.hpp.
using RealField = FieldOperations<Real>;

struct SampledGenerators {
  std::vector<std::vector<cln::cl_R>> basis = {};
  std::vector<State> states = {};                 ///< the sampled states
  std::vector<std::vector<cln::cl_R>> rows = {};  ///< conditions at these states
};

/// The generators at random states with the parameters of `rest_state`; none if too few states have
/// a value. `motion_program` has the functions of outputs_for_symmetries. Cost: 3 n + 1 derivatives
/// of the inverse dynamics at each of (unknowns / n + 4) states, and an elimination.
[[nodiscard]] std::optional<SampledGenerators> sample_generators(const CheckedModel& checked,
                                                                 const Program& motion_program,
                                                                 const State& rest_state);

/// Generators for up to three random draws of the parameters that are not fixed. A draw is omitted
/// if too few states have a value. Cost: up to 20 calls of sample_generators(), usually three.
[[nodiscard]] std::vector<SampledGenerators> sample_other_parameters(const CheckedModel& checked,
                                                                     const Program& moving);

/// True if a generator satisfies conditions that were sampled at other values of the parameters.
[[nodiscard]] bool satisfies_conditions(const SampledGenerators& sampled,
                                        const std::vector<cln::cl_R>& generator);

/// The point of a motion at the state of `values`, and R at this point.
[[nodiscard]] MotionPoint<Real> motion_point_at(ExactValues& values);

}  // namespace elgen
