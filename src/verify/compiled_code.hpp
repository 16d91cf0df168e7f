// Compares compiled code with the program. Emitted headers must give the interpreter's values bit
// by bit. Sines of packs must have the accuracy that the scene requires.
#pragma once

#include <vector>

#include "elgen/certificate.hpp"
#include "program/evaluate/subject.hpp"
#include "sample/states.hpp"

namespace elgen {

/// One row per function for one scalar: compares all entries at all states; NaN equals NaN.
template <class Scalar>
[[nodiscard]] std::vector<CertificateRow> check_compiled_code(
    const SystemUnderTest& subject, const CompiledHeader& compiled,
    const std::vector<SampledState<Scalar>>& states);

/// One row per scalar of a header with packs, for any BuildFlags; none for other headers. Compares
/// sines and cosines with values of 64 digits, at equally distributed angles: half of the angles up
/// to 4 rad, half up to the end of the domain.
[[nodiscard]] std::vector<CertificateRow> check_pack_sines(const SystemUnderTest& subject,
                                                           const CompiledHeader& compiled);

/// One row per scalar, per function that the code itself defines (stumpff), and per order that the
/// program calls. Compares 256 values with values of 64 digits. A comparison of bits would show
/// nothing, because code and interpreter share the algorithm.
[[nodiscard]] std::vector<CertificateRow> check_helper_functions(const SystemUnderTest& subject);

/// The row of a header whose code does not exist: skipped, with the reason.
[[nodiscard]] CertificateRow missing_code_row(const CompiledHeader& compiled);

/// One row: compares the numbers that the code declares with the model's, bit by bit.
[[nodiscard]] CertificateRow check_declared_numbers(const std::vector<DeclaredNumber>& numbers);

}  // namespace elgen
