// Proofs of [[expect]] by closed forms. The author's form comes straight from the model, the
// derived form from the program; they share only the ring in which they are compared.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "analyse/formulas.hpp"
#include "elgen/closed_forms.hpp"
#include "program/evaluate/subject.hpp"

namespace elgen {

class Proofs {
 public:
  /// Without `forms` nothing is proved.
  Proofs(const Subject& subject, ClosedForms* forms) : subject_(subject), forms_(forms) {}

  /// True if the entry is proved, by the forms or by forms for proofs. Depending on the
  /// expectation, it equals the derived output, is constant along the motion at u = 0, or vanishes
  /// along the motion. False shows nothing.
  [[nodiscard]] bool holds(const Expectation& expectation, std::size_t entry);

  /// The form of an entry in the file, and the derived form. None if there is no form, or if it
  /// rests on sampled zeros.
  [[nodiscard]] std::optional<Fraction> written(const Expectation& expectation, std::size_t entry);
  [[nodiscard]] std::optional<Fraction> derived(const Expectation& expectation,
                                                std::size_t entry) const;

  /// The first field of an output; none if an entry has no such form.
  [[nodiscard]] std::optional<std::vector<Fraction>> entries(OutputKind kind) const;

  /// The form with the accelerations of the motion inserted.
  [[nodiscard]] std::optional<Fraction> along_motion(const Fraction& form) const;

  /// The rate along the motion at u = 0.
  [[nodiscard]] std::optional<Fraction> free_rate(const Fraction& form) const;

  [[nodiscard]] const Subject& subject() const { return subject_; }
  /// The forms with quotients. Null until a proof needs forms for proofs, and if they contain
  /// powers of exponentials, which no author typed.
  [[nodiscard]] ClosedForms* quotients();
  /// Null if there are no forms.
  [[nodiscard]] Algebra* algebra() const { return forms_ == nullptr ? nullptr : &forms_->algebra; }

 private:
  [[nodiscard]] const Fraction* find(const OutputRequest& request, std::string_view field,
                                     std::size_t entry) const;
  [[nodiscard]] Replacements momenta() const;
  [[nodiscard]] bool conserved(const Expectation& expectation, std::size_t entry);
  [[nodiscard]] bool holds_in_forms(const Expectation& expectation, std::size_t entry);

  const Subject& subject_;
  ClosedForms* forms_;
  std::optional<ClosedForms> other_forms_ = {};  ///< built by the first proof that needs them
};

}  // namespace elgen
