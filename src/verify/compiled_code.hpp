// Compiled code against the program: the emitted header must compute what the interpreter computes,
// bit by bit.
#pragma once

#include <vector>

#include "elgen/certificate.hpp"
#include "evaluate/states.hpp"

namespace elgen {

/// One row per function, for one scalar: all entries at all states, NaN equal to NaN.
template <class Scalar>
[[nodiscard]] std::vector<CertificateRow> check_compiled(
    const Subject& subject, const CompiledHeader& compiled,
    const std::vector<SampledState<Scalar>>& states);

/// One row: the numbers that the header declares are the model's.
[[nodiscard]] CertificateRow check_declared(const std::vector<DeclaredNumber>& numbers);

}  // namespace elgen
