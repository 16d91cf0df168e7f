// What several outputs share; each part is made on first demand.
#include "derive/lagrangian/derivation.hpp"

#include "derive/lagrangian/rate_grades.hpp"
#include "derive/lagrangian/turning.hpp"

namespace elgen {

using GiNaC::ex;

namespace {

Seeds seeds(const Symbols& symbols, bool coordinates_move, bool time_passes) {
  Seeds result;
  for (std::size_t i = 0; coordinates_move && i < symbols.q.size(); ++i) {
    result.emplace(symbols.q[i], symbols.q_rates[i]);
  }
  if (time_passes) result.emplace(symbols.t, 1);
  return result;
}

void append_nonzero(Terms& terms, const ex& term) {
  if (!term.is_zero()) terms.push_back(term);
}

}  // namespace

std::vector<Weighted> weighted(const Terms& terms, int weight) {
  std::vector<Weighted> result;
  for (const ex& term : terms) result.push_back({term, weight});
  return result;
}

void append(std::vector<Weighted>& to, const std::vector<Weighted>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

Derivation::Derivation(const Lagrangian& source)
    : lagrangian(source),
      definitions(lagrangian.definitions),
      symbols(lagrangian.symbols),
      motion(definitions, motion_seeds(symbols), "_dot"),
      coasting(definitions, seeds(symbols, true, true), "_dot"),
      frozen(definitions, seeds(symbols, true, false), "_dot"),
      passing(definitions, seeds(symbols, false, true), "_by_t") {
  append(other_, weighted(lagrangian.kinetic, 1));
  append(other_, weighted(lagrangian.potential, -1));
  append(other_, weighted(lagrangian.lagrangian, 1));
}

Tangent Derivation::displacement(std::size_t velocity) {
  return {definitions, displacement_seeds(symbols, velocity)};
}

Tangent Derivation::unit_velocity(std::size_t velocity) {
  return {definitions, Seeds{{symbols.v[velocity], 1}}};
}

std::string Derivation::velocity_identifier(std::size_t velocity) const {
  return identifier_of(lagrangian.leaves.v[velocity]);
}

const GradedEnergies& Derivation::graded() {
  if (graded_) return *graded_;
  GradedEnergies energies;
  RateGrades grades(definitions, symbols.v);
  for (const ex& term : lagrangian.kinetic) {
    const auto parts = grades(term);
    append_nonzero(energies.kinetic0, parts[0]);
    append_nonzero(energies.kinetic1, parts[1]);
    append_nonzero(energies.kinetic2, parts[2]);
  }
  for (const ex& term : lagrangian.potential) {
    const auto parts = grades(term);
    append_nonzero(energies.potential0, parts[0]);
    append_nonzero(energies.potential1, parts[1]);
  }
  for (const ex& term : lagrangian.lagrangian) {
    const auto parts = grades(term);
    append_nonzero(energies.potential0, -parts[0]);
    append_nonzero(energies.potential1, -parts[1]);
    append_nonzero(energies.kinetic2, parts[2]);
  }
  graded_ = std::move(energies);
  return *graded_;
}

Vector Derivation::by_position(const std::vector<Weighted>& sum) {
  return along_velocities(*this, gradient(definitions, sum, symbols.q));
}

Vector Derivation::by_velocity(const std::vector<Weighted>& sum) {
  Vector momentum = gradient(definitions, sum, symbols.v);
  for (ex& entry : momentum) entry = define(definitions, entry);
  return momentum;
}

}  // namespace elgen
