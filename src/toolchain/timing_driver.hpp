// The drivers that time: an emitted function on arrays of states, one by one or in packs, and an
// emitted step in loops.
#pragma once

#include "elgen/timing.hpp"
#include "toolchain/driver.hpp"

namespace elgen {

/// Number k of state i stands at [k * count + i] of every array.
template <class Scalar>
using TimingDriverFunction = void (*)(std::size_t count,
#define ELGEN_LEAVES(kind, member, ...) const Scalar *member,
#include "elgen/leaves.def"
#undef ELGEN_LEAVES
                                      Scalar* result);

/// Of a scene in C++, with its header of batches where a variant is in packs; the first function of
/// the program.
[[nodiscard]] Source timing_driver(const DriverInput& input,
                                   const std::vector<TimedVariant>& variants);

/// "elgen_timed_3" of variants[3].
[[nodiscard]] std::string timed_symbol(std::size_t variant);

/// Of a scene in C++ with its header of batches, a StepLoop of one state and one in packs, under
/// these names; the first function of the program is a `step`.
[[nodiscard]] Source step_driver(const DriverInput& input);
inline constexpr const char* step_loop_of_one = "elgen_step_loop";
inline constexpr const char* step_loop_in_packs = "elgen_step_loop_in_packs";

}  // namespace elgen
