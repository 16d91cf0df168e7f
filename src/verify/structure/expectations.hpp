// [[expect]]: the closed forms an author writes down, proved equal to what was derived, or compared
// with the oracle at random exact points.
#pragma once

#include <cstdint>
#include <vector>

#include "elgen/certificate.hpp"
#include "program/evaluate/subject.hpp"

namespace elgen {

struct ExpectationReport {
  std::vector<CertificateRow> rows = {};
  /// One E510 at each entry that is wrong or has no value at any point.
  Diagnostics diagnostics = {};
};

/// Entries that `forms` (may be null) does not prove are sampled, and the row says so: 64 points
/// with rational coordinates, rates and inputs (in their ranges) and parameters (from half to twice
/// their value, with the sign they have; fixed ones too, since an expectation speaks of the model).
/// `conserved` entries: their rate along the motion with u = 0 is zero.
[[nodiscard]] ExpectationReport check_expectations(const Subject& subject, ClosedForms* forms,
                                                   std::uint64_t seed);

}  // namespace elgen
