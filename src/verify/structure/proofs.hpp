// Proofs of [[expect]] by closed forms. The written form comes from the model's expressions, the
// derived form from the program; both share only the ring in which they are compared.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "analyse/formulas.hpp"
#include "elgen/closed_forms.hpp"
#include "program/evaluate/subject.hpp"

namespace elgen {

class ExpectationProver {
 public:
  /// If `forms` is null, nothing is proved.
  ExpectationProver(const SystemUnderTest& subject, ClosedForms* forms)
      : subject_(subject), forms_(forms) {}

  /// True if the entry is proved, with the usual forms or with forms for proofs: the entry of an
  /// output equals the derived entry; a `conserved` entry is constant along the motion at u = 0; an
  /// equation holds along the motion. False proves nothing.
  [[nodiscard]] bool is_proved(const Expectation& expectation, std::size_t entry);

  /// The closed form of an entry as written in the file, and as derived. None if there is no closed
  /// form, or if the derived entry relies on sampled zeros.
  [[nodiscard]] std::optional<Fraction> written_form(const Expectation& expectation,
                                                     std::size_t entry);
  [[nodiscard]] std::optional<Fraction> derived_form(const Expectation& expectation,
                                                     std::size_t entry) const;

  /// The closed forms of a field of an output, by default the first; none if an entry has no closed
  /// form or relies on sampled zeros.
  [[nodiscard]] std::optional<std::vector<Fraction>> entry_forms(OutputKind kind,
                                                                 std::string_view field = "") const;

  /// The form, with the accelerations of the motion inserted; none if they have no closed form.
  /// Also inserts the multipliers if they have closed forms.
  [[nodiscard]] std::optional<Fraction> substitute_motion(const Fraction& form) const;

  /// The rate of the form along the motion at u = 0; none if the accelerations have no closed form.
  [[nodiscard]] std::optional<Fraction> free_rate(const Fraction& form) const;

  [[nodiscard]] const SystemUnderTest& subject() const { return subject_; }
  /// The forms for proofs, which contain quotients. Null if no proof has needed these forms so far,
  /// or if they contain powers of exponentials, because no author types such powers.
  [[nodiscard]] ClosedForms* quotient_forms();
  /// The algebra of the closed forms; null if there are no forms.
  [[nodiscard]] Algebra* algebra() const { return forms_ == nullptr ? nullptr : &forms_->algebra; }

 private:
  [[nodiscard]] const Fraction* find_form(const OutputRequest& request, std::string_view field,
                                          std::size_t entry) const;
  [[nodiscard]] Replacements momentum_replacements() const;
  [[nodiscard]] bool is_proved_conserved(const Expectation& expectation, std::size_t entry);
  [[nodiscard]] bool is_proved_by_forms(const Expectation& expectation, std::size_t entry);

  const SystemUnderTest& subject_;
  ClosedForms* forms_;
  std::optional<ClosedForms> proof_forms_ = {};  ///< built by the first proof that needs them
};

}  // namespace elgen
