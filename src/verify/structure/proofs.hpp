// Proofs of [[expect]]: what the author wrote and what was derived are one canonical sum.
#pragma once

#include "elgen/closed_forms.hpp"
#include "evaluate/subject.hpp"

namespace elgen {

class Proofs {
 public:
  /// Without `forms` nothing is proved.
  Proofs(const Subject& subject, ClosedForms* forms) : subject_(subject), forms_(forms) {}

  /// The entry equals that of the output derived. False says nothing.
  [[nodiscard]] bool equal(const Expectation& expectation, std::size_t entry);

  /// The rate of a `conserved` entry along the motion at u = 0 is the empty sum.
  [[nodiscard]] bool conserved(const Expectation& expectation, std::size_t entry);

 private:
  [[nodiscard]] const ClosedFunction* derived(OutputKind kind, std::uint32_t user) const;
  std::optional<Fraction> written(const Expectation& expectation, std::size_t entry);

  const Subject& subject_;
  ClosedForms* forms_;
};

}  // namespace elgen
