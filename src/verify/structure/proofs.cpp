// Proofs: see proofs.hpp. The author's form comes straight from the model, the derived one from the
// program, so that they share nothing but the ring they are compared in.
#include "verify/structure/proofs.hpp"

#include <algorithm>

#include "check/names/requests.hpp"

namespace elgen {
namespace {

bool rests_on_samples(const Program& program, OutputKind kind, std::uint32_t user,
                      std::size_t entry) {
  const Function* function = find_function(program, kind, user);
  if (function == nullptr) return false;
  const auto& sampled = function->sampled_zeros;
  return std::find(sampled.begin(), sampled.end(), entry) != sampled.end();
}

/// Entries of all fields in order, as expectations count them.
const std::optional<Fraction>* entry_of(const ClosedFunction& function, std::size_t entry) {
  for (const ClosedField& field : function.fields) {
    if (entry < field.entries.size()) return &field.entries[entry];
    entry -= field.entries.size();
  }
  return nullptr;
}

}  // namespace

const ClosedFunction* Proofs::derived(OutputKind kind, std::uint32_t user) const {
  const std::vector<Function>& functions = subject_.program.functions;
  for (std::size_t i = 0; forms_ != nullptr && i < forms_->functions.size(); ++i) {
    if (functions[i].kind == kind && functions[i].user == user) return &forms_->functions[i];
  }
  return nullptr;
}

std::optional<Fraction> Proofs::written(const Expectation& expectation, std::size_t entry) {
  return closed_form(*forms_, subject_.model, subject_.scene.specialisation.fixed,
                     expectation.entries[entry]);
}

bool Proofs::equal(const Expectation& expectation, std::size_t entry) {
  const auto request = find_request(subject_.model, expectation.output);
  const ClosedFunction* function = request ? derived(request->kind, request->user) : nullptr;
  const std::optional<Fraction>* form = function == nullptr ? nullptr : entry_of(*function, entry);
  if (form == nullptr || !form->has_value()) return false;
  if (rests_on_samples(subject_.program, request->kind, request->user, entry)) return false;
  const auto own = written(expectation, entry);
  return own && proved_equal(*forms_, *own, **form);
}

bool Proofs::conserved(const Expectation& expectation, std::size_t entry) {
  const ClosedFunction* function = derived(OutputKind::forward_dynamics, 0);
  if (function == nullptr || function->fields.empty()) return false;
  std::vector<Fraction> accelerations;
  for (const std::optional<Fraction>& acceleration : function->fields[0].entries) {
    const bool is_sampled =
        rests_on_samples(subject_.program, OutputKind::forward_dynamics, 0, accelerations.size());
    if (!acceleration || is_sampled) return false;
    accelerations.push_back(*acceleration);
  }
  const auto own = written(expectation, entry);
  const std::vector<Fraction> rates = coordinate_rates(*forms_, subject_.model);
  return own && proved_conserved(*forms_, *own, accelerations, rates);
}

}  // namespace elgen
