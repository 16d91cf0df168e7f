// Looks up the derived forms in the program's closed forms. A proof shows that a difference is the
// empty sum.
#include "verify/structure/proofs.hpp"

#include <algorithm>
#include <utility>

#include "elgen/references.hpp"
#include "model/requests.hpp"

namespace elgen {

namespace {

/// True if forms for proofs would differ from the usual forms, in the program or in the file's
/// expectations.
bool has_other_forms(const Subject& subject) {
  const auto is_other = [](const Expression& e) {
    return e.kind == ExpressionKind::function && is_rewritten_for_proofs(e.function);
  };
  return std::ranges::any_of(subject.model.expressions, is_other) ||
         calls(subject.program, FunctionId::stumpff);
}

}  // namespace

const Fraction* Proofs::find(const OutputRequest& request, std::string_view field,
                             std::size_t entry) const {
  const std::vector<Function>& functions = subject_.program.functions;
  for (std::size_t i = 0; forms_ != nullptr && i < forms_->functions.size(); ++i) {
    if (functions[i].kind != request.kind || functions[i].user != request.user) continue;
    if (!field.empty()) entry += first_entry_of(functions[i], field);
    if (std::ranges::count(functions[i].sampled_zeros, entry) > 0) return nullptr;
    for (const ClosedField& closed : forms_->functions[i].fields) {
      if (entry < closed.entries.size()) {
        return closed.entries[entry] ? &*closed.entries[entry] : nullptr;
      }
      entry -= closed.entries.size();
    }
    return nullptr;
  }
  return nullptr;
}

std::optional<Fraction> Proofs::written(const Expectation& expectation, std::size_t entry) {
  if (forms_ == nullptr) return std::nullopt;
  return closed_form(*forms_, subject_.model, subject_.scene.specialisation.fixed,
                     expectation.entries[entry]);
}

std::optional<Fraction> Proofs::derived(const Expectation& expectation, std::size_t entry) const {
  const auto request = find_request(subject_.model, expectation.output);
  const Fraction* const form = request ? find(*request, expectation.field, entry) : nullptr;
  return form == nullptr ? std::nullopt : std::optional(*form);
}

std::optional<std::vector<Fraction>> Proofs::entries(OutputKind kind) const {
  const Function* const function = find_function(subject_.program, kind);
  if (function == nullptr) return std::nullopt;
  std::vector<Fraction> result;
  for (std::size_t i = 0; i < function->fields.front().entries.size(); ++i) {
    const Fraction* const form = find({.kind = kind}, "", i);
    if (form == nullptr) return std::nullopt;
    result.push_back(*form);
  }
  return result;
}

/// The known closed forms of p and E, to be inserted into `conserved` entries.
Replacements Proofs::momenta() const {
  Replacements result;
  for (const auto& [leaf, kind] : {std::pair{Opcode::momentum, OutputKind::momentum},
                                   std::pair{Opcode::energy, OutputKind::energy_function}}) {
    const auto forms = entries(kind);
    for (std::uint32_t i = 0; forms && i < forms->size(); ++i)
      result[{leaf, i}].value = (*forms)[i];
  }
  return result;
}

std::optional<Fraction> Proofs::free_rate(const Fraction& form) const {
  const auto accelerations = entries(OutputKind::forward_dynamics);
  if (!accelerations) return std::nullopt;
  const std::vector<Fraction> rates = coordinate_rates(*forms_, subject_.model);
  const OpenTerms open_values =
      open_terms(*forms_, subject_.model, subject_.scene.specialisation.fixed);
  return elgen::free_rate(*forms_, form, *accelerations, rates, open_values);
}

bool Proofs::conserved(const Expectation& expectation, std::size_t entry) {
  auto own = written(expectation, entry);
  const bool has_momenta =
      contains_leaf(subject_.model, expectation.entries[entry], Opcode::momentum | Opcode::energy);
  if (own && has_momenta) own = substituted(forms_->algebra, *own, momenta());
  const std::optional<Fraction> rate = own ? free_rate(*own) : std::nullopt;
  return rate && rate->numerator.empty();
}

std::optional<Fraction> Proofs::along_motion(const Fraction& form) const {
  const auto accelerations = entries(OutputKind::forward_dynamics);
  if (!accelerations) return std::nullopt;
  Replacements motion;
  for (std::uint32_t i = 0; i < accelerations->size(); ++i) {
    motion[{Opcode::acceleration, i}].value = (*accelerations)[i];
  }
  return substituted(forms_->algebra, form, motion);
}

bool Proofs::holds(const Expectation& expectation, std::size_t entry) {
  if (holds_in_forms(expectation, entry)) return true;
  if (forms_ == nullptr || !has_other_forms(subject_)) return false;
  if (!other_forms_) {
    Program derived = subject_.program;
    derived.functions.resize(forms_->functions.size());  // steps come last and have no forms
    other_forms_ = present_for_proofs(derived);
  }
  return Proofs(subject_, &*other_forms_).holds_in_forms(expectation, entry);
}

ClosedForms* Proofs::quotients() {
  const auto is_power = [](const Atom& atom) {
    return atom.kind == AtomKind::call && has_exponential_form(atom.function);
  };
  const bool is_typed = other_forms_ && std::ranges::none_of(other_forms_->algebra.atoms, is_power);
  return is_typed ? &*other_forms_ : nullptr;
}

bool Proofs::holds_in_forms(const Expectation& expectation, std::size_t entry) {
  if (expectation.is_conserved()) return conserved(expectation, entry);
  const bool is_equation = expectation.is_equations();
  const std::optional<Fraction> right = is_equation ? std::nullopt : derived(expectation, entry);
  if (!is_equation && !right) return false;
  const std::optional<Fraction> own = written(expectation, entry);
  if (!own) return false;
  if (!is_equation) return is_proved_equal(*forms_, *own, *right);
  const std::optional<Fraction> rest = along_motion(*own);
  return rest && rest->numerator.empty();
}

}  // namespace elgen
