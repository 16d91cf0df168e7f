// Accuracy: a program's values in double and float against the 60-digit oracle, in units of an
// error bound: that of the closed form a function is emitted in, else the program's own.
#pragma once

#include <vector>

#include "elgen/certificate.hpp"
#include "verify/bounds/visits.hpp"

namespace elgen {

/// One row per output and field, and one per output of the digits that it loses where
/// options.visit.losing says so. A state fails where the exact value of the program is not the
/// oracle's (to 50 digits of its bound) or, at a nominal state, is undefined where the oracle has
/// one, and where the rounded value is no finite number. One that is further off than promised is
/// noted.
template <class Scalar>
[[nodiscard]] std::vector<CertificateRow> check_accuracy(
    const Subject& subject, const std::vector<SampledState<Scalar>>& states,
    const AccuracyOptions& options = {});

}  // namespace elgen
