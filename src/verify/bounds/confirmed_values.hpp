// confirmed_values: the values of a function in exact arithmetic, confirmed by the oracle. One
// projection per field costs a few evaluations of the energies; the oracle's entries of a
// derivative cost n^2 evaluations with n velocities.
#pragma once

#include <cln/real.h>

#include <optional>
#include <vector>

#include "verify/bounds/exact_run.hpp"

namespace elgen {

/// The entries of program.functions[function], whose exact run at `state` is `run`: correct to more
/// than 20 digits, and 0 if an entry is a rounding error. None unless the oracle has a value for
/// each field, and a random projection of each field agrees with it to 50 digits. Derivatives of
/// more than four velocities are confirmed at the accelerations of the program.
[[nodiscard]] std::optional<std::vector<cln::cl_R>> confirmed_values(const SystemUnderTest& subject,
                                                                     std::size_t function,
                                                                     const State& state,
                                                                     const ExactRun& run);

}  // namespace elgen
