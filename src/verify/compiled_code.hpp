// Compiled code against the program: the emitted headers must compute what the interpreter
// computes, bit by bit, and sines of packs must be within the error that a scene asks for.
#pragma once

#include <vector>

#include "elgen/certificate.hpp"
#include "program/evaluate/subject.hpp"
#include "sample/states.hpp"

namespace elgen {

/// One row per function, for one scalar: all entries at all states, NaN equal to NaN.
template <class Scalar>
[[nodiscard]] std::vector<CertificateRow> check_compiled(
    const Subject& subject, const CompiledHeader& compiled,
    const std::vector<SampledState<Scalar>>& states);

/// One row per scalar of a header in packs, in any Build: its sines and cosines at angles up to 4
/// and up to the end of the domain, spread evenly, against 64 digits.
[[nodiscard]] std::vector<CertificateRow> check_sines(const Subject& subject,
                                                      const CompiledHeader& compiled);

/// One row per scalar and function that code brings with it (stumpff), as the program calls it: its
/// value at 256 arguments against 64 digits. Bits say nothing of it, for code and interpreter share
/// the algorithm.
[[nodiscard]] std::vector<CertificateRow> check_helpers(const Subject& subject);

/// The row of a header that lacks its functions: skipped, with the reason.
[[nodiscard]] CertificateRow without_code(const CompiledHeader& compiled);

/// One row: the numbers that the header declares are the model's.
[[nodiscard]] CertificateRow check_declared(const std::vector<DeclaredNumber>& numbers);

}  // namespace elgen
