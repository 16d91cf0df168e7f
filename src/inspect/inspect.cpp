// Inspection: one check after another. Most ask the oracle for values at sampled states; names that
// are never used, inertias and points in an energy are read off the model.
#include "elgen/inspect.hpp"

#include <utility>

#include "base/report.hpp"
#include "inspect/checks.hpp"

namespace elgen {

Diagnostics inspect(const Model& model, const Scene& scene) {
  Model exact = model;
  exact.approximation.reset();
  const Inspected subject{exact, scene};
  Diagnostics all;
  const auto add = [&](Diagnostics found) { all.insert(all.end(), found.begin(), found.end()); };
  add(inspect_unused(subject));
  add(inspect_left_out(subject));
  add(inspect_constants(subject));
  // A model with a constant that has no value has none at sampled states, and one with a constant
  // that is too large takes forever.
  if (has_errors(all)) return all;
  add(inspect_inertias(subject));
  add(inspect_spins(subject));
  add(inspect_mass_matrix(subject));
  // A matrix that is singular everywhere would be reported again at every special configuration.
  if (!has_errors(all)) add(inspect_charts(subject));
  if (!has_errors(all)) add(inspect_constraints(subject));
  if (!has_errors(all)) add(inspect_tasks(subject));
  if (!has_errors(all)) add(inspect_signs(subject));
  add(inspect_potential(subject));
  add(inspect_weights(subject));
  add(inspect_kinetic_energies(subject));
  add(inspect_smoothed(subject));
  if (!has_errors(all)) add(inspect_equilibria(subject));
  if (!has_errors(all)) add(inspect_equilibrium({model, scene}));
  // Entries of a repetition make the same mistake each.
  Report once;
  for (Diagnostic& diagnostic : all) once.add(std::move(diagnostic));
  return once.sorted();
}

}  // namespace elgen
