// Proofs of [[expect]] by closed forms. The author's form comes straight from the model, the
// derived one from the program, so that they share nothing but the ring they are compared in.
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

  /// An entry equals that of the output derived, is constant along the motion at u = 0, or vanishes
  /// along it, as the expectation says, by the forms or else by forms for proofs. False says
  /// nothing.
  [[nodiscard]] bool holds(const Expectation& expectation, std::size_t entry);

  /// The form of an entry as the file gives it, and as it is derived; none where there is none, or
  /// where it rests on zeros that were sampled.
  [[nodiscard]] std::optional<Fraction> written(const Expectation& expectation, std::size_t entry);
  [[nodiscard]] std::optional<Fraction> derived(const Expectation& expectation,
                                                std::size_t entry) const;

  /// The first field of an output; none where an entry has no such form.
  [[nodiscard]] std::optional<std::vector<Fraction>> entries(OutputKind kind) const;

  /// With the accelerations of the motion in place of all others.
  [[nodiscard]] std::optional<Fraction> along_motion(const Fraction& form) const;

  /// The rate along the motion at u = 0.
  [[nodiscard]] std::optional<Fraction> free_rate(const Fraction& form) const;

  [[nodiscard]] const Subject& subject() const { return subject_; }
  /// The forms with quotients; null until a proof has asked for forms for proofs, and if these hold
  /// powers of exponentials, which nobody has typed.
  [[nodiscard]] ClosedForms* quotients();
  /// Null: there are no forms.
  [[nodiscard]] Algebra* algebra() const { return forms_ == nullptr ? nullptr : &forms_->algebra; }

 private:
  [[nodiscard]] const Fraction* find(const OutputRequest& request, std::string_view field,
                                     std::size_t entry) const;
  [[nodiscard]] Replacements momenta() const;
  [[nodiscard]] bool conserved(const Expectation& expectation, std::size_t entry);
  [[nodiscard]] bool holds_as_it_is(const Expectation& expectation, std::size_t entry);

  const Subject& subject_;
  ClosedForms* forms_;
  std::optional<ClosedForms> other_forms_ = {};  ///< made for the first proof that asks for them
};

}  // namespace elgen
