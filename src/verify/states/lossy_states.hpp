// States at which the program loses digits, found by a search from random states. Zeros of typed
// sums (near_zeros.hpp) explain most losses; this search also finds places at which parts of
// different sums cancel. Unlike all other states, these depend on the program.
#pragma once

#include <vector>

#include "program/evaluate/subject.hpp"
#include "sample/states.hpp"

namespace elgen {

/// The four worst results of eight searches in each function, inside the ranges; at most
/// min(sampling.count, 64) states. A search starts at the worst of a few random states, and
/// maximises the estimated loss E / (|x| + K) of one entry x (accuracy/running_errors.hpp,
/// accuracy/conditioning.hpp) by random steps: a (1+1) evolution strategy with the 1/5 success rule
/// (Rechenberg 1973). Every second search stays at rest; t does not move. Fewer searches in long
/// functions. None with constraints, because steps leave them. Cost: a second for 256 states, in
/// double.
template <class Scalar>
[[nodiscard]] std::vector<SampledState<Scalar>> lossy_states(const SystemUnderTest& subject,
                                                             const SamplingOptions& sampling);

}  // namespace elgen
