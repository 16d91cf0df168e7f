// [[expect]]: the closed forms that a model's author expects. They are proved equal to the derived
// forms, or compared with the oracle at random exact points.
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
  /// E510 for each entry that is wrong or has no value at any point; E540 for equations that do not
  /// determine the accelerations.
  Diagnostics diagnostics = {};
};

/// One entry of an expectation.
struct ExpectedEntry {
  const Expectation& expectation;
  std::size_t index;
  const SystemUnderTest& subject;

  [[nodiscard]] ExpressionId expression() const { return expectation.entries[index]; }
  [[nodiscard]] Span span() const {
    return index < expectation.spans.size() ? expectation.spans[index] : expectation.span;
  }
};

/// The scene that fixes the parameters of an expectation: subject.scene, or for an expectation of
/// the model a scene that fixes none.
[[nodiscard]] const Scene& fixing_scene(const SystemUnderTest& subject,
                                        const Expectation& expectation);

/// The name of the entry in the file: "gravity[2]".
[[nodiscard]] std::string name_of(const ExpectedEntry& entry);

/// The row of the entry, without a verdict.
[[nodiscard]] CertificateRow unjudged_row(const ExpectedEntry& entry);

/// Proves each entry by `forms`. If `forms` is null or gives no proof, the entry is sampled at 64
/// points or more, and its row says so. Coordinates, rates and inputs are rational numbers in their
/// ranges. Parameters lie between half and twice their values; for an expectation of the model even
/// parameters that the scene fixes. A `conserved` entry holds if its rate along the motion at u = 0
/// is 0; an equation, if left - right is 0 along the motion. Expectations `at` a state are compared
/// at that state. If the scene adds inputs, the expectations of the model are sampled on
/// Scene::model_alone, because `forms` describe another system. If the scene expands the model,
/// only the expectations of the scene are judged. Hints give the difference of a wrong entry from
/// the derived one in closed form.
[[nodiscard]] ExpectationReport check_expectations(const SystemUnderTest& subject,
                                                   ClosedForms* forms, std::uint64_t seed);

}  // namespace elgen
