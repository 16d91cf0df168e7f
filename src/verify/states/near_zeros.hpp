// States near zeros of the sums that a model's author typed, where code that multiplied them out
// loses digits: (x - 1)^2 + (y - 0.3)^2 near (1, 0.3). Found from the Model by the oracle alone.
#pragma once

#include <vector>

#include "program/evaluate/subject.hpp"
#include "sample/states.hpp"

namespace elgen {

/// At three distances from each zero, inside the ranges: first where as many sums vanish together
/// as can, then where each does along one coordinate. Every second state is at rest, for random
/// accelerations hide what a holding force loses. At most as many as random states, and 64.
template <class Scalar>
[[nodiscard]] std::vector<SampledState<Scalar>> states_near_zeros(const Subject& subject,
                                                                  const Sampling& sampling);

}  // namespace elgen
