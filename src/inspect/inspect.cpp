// Inspection: runs all checks in order. Most checks evaluate the oracle at sampled states; the
// checks of unused names, inertias and points in an energy only read the model.
#include "elgen/inspect.hpp"

#include <utility>

#include "base/report.hpp"
#include "inspect/checks.hpp"

namespace elgen {

Diagnostics inspect(const Model& model, const Scene& scene) {
  Model exact = model;
  exact.approximation.reset();
  const InspectedModel subject{exact, scene};
  Diagnostics all;
  const auto add = [&](Diagnostics found) { all.insert(all.end(), found.begin(), found.end()); };
  add(inspect_unused_names(subject));
  add(inspect_omissions(subject));
  add(inspect_constants(subject));
  // If a constant has no value, the model has no values at sampled states. If a power is too large,
  // the evaluation takes too long.
  if (has_errors(all)) return all;
  add(inspect_inertias(subject));
  add(inspect_spins(subject));
  add(inspect_mass_matrix(subject));
  // If M is singular everywhere, it is singular at every special configuration.
  if (!has_errors(all)) add(inspect_charts(subject));
  if (!has_errors(all)) add(inspect_constraints(subject));
  if (!has_errors(all)) add(inspect_tasks(subject));
  if (!has_errors(all)) add(inspect_signs(subject));
  add(inspect_potential(subject));
  add(inspect_weights(subject));
  add(inspect_kinetic_energies(subject));
  add(inspect_smoothed_friction(subject));
  if (!has_errors(all)) add(inspect_equilibria(subject));
  if (!has_errors(all)) add(inspect_expansion_point({model, scene}));
  // If all entries of a repetition have the same mistake, the mistake is reported once.
  Report unique;
  for (Diagnostic& diagnostic : all) unique.add(std::move(diagnostic));
  return unique.sorted_diagnostics();
}

}  // namespace elgen
