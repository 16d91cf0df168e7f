// Signs that no system has: E523 a negative mass, E524 a kinetic energy and E525 a dissipation
// below 0. Masses are read at the parameters' values, M and D at sampled states.
#include <fmt/format.h>

#include "inspect/checks.hpp"
#include "inspect/null_space.hpp"
#include "inspect/readable.hpp"
#include "inspect/samples.hpp"

namespace elgen {
namespace {

using cln::cl_R;

void check_mass(const Model& model, const State& state, const std::string& name,
                const std::optional<ExpressionId>& mass, Diagnostics& found) {
  if (!mass) return;
  const auto value = oracle_expression(model, *mass, state);
  if (!value || *value >= 0) return;
  found.push_back({Code::E523, model.expressions[*mass].span,
                   fmt::format("the mass of `{}` is {}", name, as_typed(*value)), "sign mistake?"});
}

/// The first velocity, in the order of elimination, whose pivot of M = L D L^T is negative beyond
/// rounding; none where M is singular before.
std::optional<std::size_t> negative_pivot(std::vector<cl_R> m, std::size_t n) {
  const std::vector<cl_R> scales = row_scales(m, n);
  for (std::size_t k = 0; k < n; ++k) {
    const cl_R pivot = m[k * n + k];
    const cl_R least = rounding_share() * scales[k];
    if (pivot < -least) return k;
    if (pivot <= least) return std::nullopt;
    for (std::size_t i = k + 1; i < n; ++i) {
      const cl_R factor = m[i * n + k] / pivot;
      for (std::size_t j = k; j < n; ++j) m[i * n + j] = m[i * n + j] - factor * m[k * n + j];
    }
  }
  return std::nullopt;
}

Diagnostics inspect_dissipation(const Inspected& subject) {
  const Model& model = subject.model;
  if (!model.energies.D) return {};
  for (unsigned seed = 0; seed < zero_samples; ++seed) {
    const auto value = oracle_expression(model, *model.energies.D, sampled_state(subject, seed));
    if (!value || *value >= 0) continue;
    return {{Code::E525, model.expressions[*model.energies.D].span,
             "D is negative, so that it drives the motion",
             "a damper is `1/2*d*v^2` with a positive d: sign mistake?"}};
  }
  return {};
}

/// Each value takes a walk through the model: of long chains none is asked for.
Diagnostics negative_masses(const Inspected& subject) {
  const Model& model = subject.model;
  if (model.velocities.size() > most_coordinates_sampled) return {};
  const State state = nominal_state(model, subject.scene);
  Diagnostics found;
  for (const Point& point : model.points) check_mass(model, state, point.name, point.mass, found);
  for (const Body& body : model.bodies) check_mass(model, state, body.name, body.mass, found);
  return found;
}

}  // namespace

Diagnostics negative_kinetic_energy(const Inspected& subject, const MassSample& sample) {
  const Model& model = subject.model;
  const auto at = negative_pivot(sample.matrix, model.velocities.size());
  // A negative mass is named as such.
  if (!at || !negative_masses(subject).empty()) return {};
  const auto& written = model.energies.L ? model.energies.L : model.energies.T;
  const Span& span = written ? model.expressions[*written].span : model.velocities[*at].span;
  return {{Code::E524, span,
           fmt::format("M is not positive definite: motions of `{}` have negative kinetic energy",
                       model.velocities[*at].name),
           "sign mistake, or a square is missing?"}};
}

Diagnostics inspect_signs(const Inspected& subject) {
  Diagnostics found = negative_masses(subject);
  const Diagnostics driven = inspect_dissipation(subject);
  found.insert(found.end(), driven.begin(), driven.end());
  return found;
}

}  // namespace elgen
