// [[expect]]: the closed forms an author writes down, proved equal to what was derived, or compared
// with the oracle at random exact points.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "elgen/certificate.hpp"
#include "program/evaluate/subject.hpp"

namespace elgen {

struct ExpectationReport {
  std::vector<CertificateRow> rows = {};
  /// One E510 at each entry that is wrong or has no value at any point, E540 at equations that do
  /// not determine the accelerations.
  Diagnostics diagnostics = {};
};

/// One entry of an expectation about a system.
struct ExpectedEntry {
  const Expectation& of;
  std::size_t index;
  const Subject& subject;

  [[nodiscard]] ExpressionId expression() const { return of.entries[index]; }
  [[nodiscard]] Span span() const { return index < of.spans.size() ? of.spans[index] : of.span; }
};

/// "gravity[2]": as the file calls it.
[[nodiscard]] std::string name_of(const ExpectedEntry& entry);

/// Its row of the certificate, without a verdict.
[[nodiscard]] CertificateRow blank_row(const ExpectedEntry& entry);

/// Entries that `forms` (may be null) does not prove are sampled, and the row says so: 64 points
/// with rational coordinates, rates and inputs (in their ranges) and parameters (from half to twice
/// their value, with the sign they have; fixed ones too, since an expectation speaks of the model).
/// `conserved` entries: their rate along the motion with u = 0 is zero. `equations`: left - right
/// is zero along the motion. Those `at` a state are judged there. Hints tell in closed form how a
/// wrong one differs.
[[nodiscard]] ExpectationReport check_expectations(const Subject& subject, ClosedForms* forms,
                                                   std::uint64_t seed);

}  // namespace elgen
