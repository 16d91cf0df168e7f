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
bool has_distinct_proof_forms(const SystemUnderTest& subject) {
  const auto is_other = [](const Expression& e) {
    return e.kind == ExpressionKind::function && is_rewritten_for_proofs(e.function);
  };
  return std::ranges::any_of(subject.model.expressions, is_other) ||
         calls_function(subject.program, FunctionId::stumpff);
}

}  // namespace

const Fraction* ExpectationProver::find_form(const OutputRequest& request, std::string_view field,
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

std::optional<Fraction> ExpectationProver::written_form(const Expectation& expectation,
                                                        std::size_t entry) {
  if (forms_ == nullptr) return std::nullopt;
  return closed_form(*forms_, subject_.model, subject_.scene.specialisation.fixed,
                     expectation.entries[entry]);
}

std::optional<Fraction> ExpectationProver::derived_form(const Expectation& expectation,
                                                        std::size_t entry) const {
  const auto request = find_request(subject_.model, expectation.output);
  const Fraction* const form = request ? find_form(*request, expectation.field, entry) : nullptr;
  return form == nullptr ? std::nullopt : std::optional(*form);
}

std::optional<std::vector<Fraction>> ExpectationProver::entry_forms(OutputKind kind,
                                                                    std::string_view field) const {
  const Function* const function = find_function(subject_.program, kind);
  if (function == nullptr) return std::nullopt;
  const auto found = field.empty() ? function->fields.begin()
                                   : std::ranges::find(function->fields, field, &Field::name);
  if (found == function->fields.end()) return std::nullopt;
  std::vector<Fraction> result;
  for (std::size_t i = 0; i < found->entries.size(); ++i) {
    const Fraction* const form = find_form({.kind = kind}, field, i);
    if (form == nullptr) return std::nullopt;
    result.push_back(*form);
  }
  return result;
}

/// The known closed forms of p and E, to be inserted into `conserved` entries.
Replacements ExpectationProver::momentum_replacements() const {
  Replacements result;
  for (const auto& [leaf, kind] : {std::pair{Opcode::momentum, OutputKind::momentum},
                                   std::pair{Opcode::energy, OutputKind::energy_function}}) {
    const auto forms = entry_forms(kind);
    for (std::uint32_t i = 0; forms && i < forms->size(); ++i)
      result[{leaf, i}].value = (*forms)[i];
  }
  return result;
}

std::optional<Fraction> ExpectationProver::free_rate(const Fraction& form) const {
  const auto accelerations = entry_forms(OutputKind::forward_dynamics);
  if (!accelerations) return std::nullopt;
  const std::vector<Fraction> rates = coordinate_rates(*forms_, subject_.model);
  const OpenValueRates open_values =
      open_value_rates(*forms_, subject_.model, subject_.scene.specialisation.fixed);
  return elgen::unforced_rate(*forms_, form, *accelerations, rates, open_values);
}

bool ExpectationProver::is_proved_conserved(const Expectation& expectation, std::size_t entry) {
  auto own = written_form(expectation, entry);
  const bool has_momenta =
      contains_leaf(subject_.model, expectation.entries[entry], Opcode::momentum | Opcode::energy);
  if (own && has_momenta) own = substitute(forms_->algebra, *own, momentum_replacements());
  const std::optional<Fraction> rate = own ? free_rate(*own) : std::nullopt;
  return rate && rate->numerator.empty();
}

std::optional<Fraction> ExpectationProver::substitute_motion(const Fraction& form) const {
  const auto accelerations = entry_forms(OutputKind::forward_dynamics);
  if (!accelerations) return std::nullopt;
  Replacements motion;
  for (std::uint32_t i = 0; i < accelerations->size(); ++i) {
    motion[{Opcode::acceleration, i}].value = (*accelerations)[i];
  }
  const auto multipliers = entry_forms(OutputKind::forward_dynamics, "multipliers");
  for (std::uint32_t i = 0; multipliers && i < multipliers->size(); ++i) {
    motion[{Opcode::multiplier, i}].value = (*multipliers)[i];
  }
  return substitute(forms_->algebra, form, motion);
}

bool ExpectationProver::is_proved(const Expectation& expectation, std::size_t entry) {
  if (is_proved_by_forms(expectation, entry)) return true;
  if (forms_ == nullptr || !has_distinct_proof_forms(subject_)) return false;
  if (!proof_forms_) {
    Program derived = subject_.program;
    derived.functions.resize(forms_->functions.size());  // steps come last and have no forms
    proof_forms_ = present_for_proofs(derived);
  }
  return ExpectationProver(subject_, &*proof_forms_).is_proved_by_forms(expectation, entry);
}

ClosedForms* ExpectationProver::quotient_forms() {
  const auto is_power = [](const Atom& atom) {
    return atom.kind == AtomKind::call && has_exponential_form(atom.function);
  };
  const bool is_typed = proof_forms_ && std::ranges::none_of(proof_forms_->algebra.atoms, is_power);
  return is_typed ? &*proof_forms_ : nullptr;
}

bool ExpectationProver::is_proved_by_forms(const Expectation& expectation, std::size_t entry) {
  if (expectation.claims_conservation()) return is_proved_conserved(expectation, entry);
  const bool is_equation = expectation.claims_equations();
  const std::optional<Fraction> right =
      is_equation ? std::nullopt : derived_form(expectation, entry);
  if (!is_equation && !right) return false;
  const std::optional<Fraction> own = written_form(expectation, entry);
  if (!own) return false;
  if (!is_equation) return is_proved_equal(*forms_, *own, *right);
  const std::optional<Fraction> rest = substitute_motion(*own);
  return rest && rest->numerator.empty();
}

}  // namespace elgen
