// Accuracy: a program's values in double and float against the 60-digit oracle. Wrong values fail;
// the digits that rounding takes are a figure.
#pragma once

#include <vector>

#include "elgen/certificate.hpp"
#include "verify/bounds/visits.hpp"

namespace elgen {

/// One row per output and field, one of the code as users compile it where there is such code, and
/// one per output of the digits that it loses where options.visit.losing says so. A state fails
/// where the exact value of the program is not the oracle's (to 50 digits of E + |x*|) or, at a
/// nominal state, is undefined where the oracle has one, where the rounded value is no finite
/// number, and where the code of users is further from the program than most_of_users allows.
template <class Scalar>
[[nodiscard]] std::vector<CertificateRow> check_accuracy(
    const Subject& subject, const std::vector<SampledState<Scalar>>& states,
    const AccuracyOptions& options = {});

}  // namespace elgen
