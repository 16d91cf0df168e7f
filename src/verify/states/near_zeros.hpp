// States near zeros of the sums that a model's author typed: (x - 1)^2 + (y - 0.3)^2 near (1, 0.3).
// Code that expanded such a sum loses digits near its zero. Near a minimum of V, several sums or
// all forces may vanish together, and no term hides the lost digits of another. The states depend
// on the model and the oracle only, not on the program.
#pragma once

#include <vector>

#include "program/evaluate/subject.hpp"
#include "sample/states.hpp"

namespace elgen {

/// States at three distances from each place, inside the ranges: first near minima of V if there
/// are several sums, then near zeros of each sum along one coordinate, or, without such a zero,
/// along all its coordinates. Near a place of several coordinates, some states differ from it in
/// one coordinate only. Every second state is at rest, because random accelerations hide the digits
/// that a holding force loses. At most min(sampling.count, 64) states.
template <class Scalar>
[[nodiscard]] std::vector<SampledState<Scalar>> states_near_zeros(const SystemUnderTest& subject,
                                                                  const SamplingOptions& sampling);

}  // namespace elgen
