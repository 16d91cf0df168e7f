// [[expect]]: the closed forms of a model's author, proved equal to the derived forms, or compared
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
  /// One E510 for each entry that is wrong or has no value at any point, E540 for equations that do
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

/// "gravity[2]": the name in the file.
[[nodiscard]] std::string name_of(const ExpectedEntry& entry);

/// The certificate row of the entry, without a verdict.
[[nodiscard]] CertificateRow blank_row(const ExpectedEntry& entry);

/// Entries that `forms` (may be null) does not prove are sampled, and the row says so. The 64
/// points have rational coordinates, rates and inputs in their ranges. Parameters lie between half
/// and twice their value, with its sign; fixed ones, too, because an expectation describes the
/// model. `conserved` entries: the rate along the motion with u = 0 is zero. `equations`:
/// left - right is zero along the motion. Expectations `at` a state are compared at that state.
/// Hints give the difference of a wrong entry in closed form.
[[nodiscard]] ExpectationReport check_expectations(const Subject& subject, ClosedForms* forms,
                                                   std::uint64_t seed);

}  // namespace elgen
