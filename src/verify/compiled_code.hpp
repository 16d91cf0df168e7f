// Compiled code against the program. Emitted headers must give the interpreter's values bit by bit.
// Sines of packs must meet the error that the scene asks for.
#pragma once

#include <vector>

#include "elgen/certificate.hpp"
#include "program/evaluate/subject.hpp"
#include "sample/states.hpp"

namespace elgen {

/// One row per function for one scalar: all entries at all states; NaN equals NaN.
template <class Scalar>
[[nodiscard]] std::vector<CertificateRow> check_compiled(
    const Subject& subject, const CompiledHeader& compiled,
    const std::vector<SampledState<Scalar>>& states);

/// One row per scalar of a header in packs, for any Build. Its sines and cosines are compared with
/// 64 digits, at angles up to 4 and up to the end of the domain, evenly spread.
[[nodiscard]] std::vector<CertificateRow> check_sines(const Subject& subject,
                                                      const CompiledHeader& compiled);

/// One row per scalar and function that the code defines itself (stumpff), for the orders that the
/// program calls: 256 values against 64 digits. Comparing bits would show nothing, because code and
/// interpreter share the algorithm.
[[nodiscard]] std::vector<CertificateRow> check_helpers(const Subject& subject);

/// The row of a header without functions: skipped, with the reason.
[[nodiscard]] CertificateRow missing_code_row(const CompiledHeader& compiled);

/// One row: the declared numbers are the model's.
[[nodiscard]] CertificateRow check_declared(const std::vector<DeclaredNumber>& numbers);

}  // namespace elgen
