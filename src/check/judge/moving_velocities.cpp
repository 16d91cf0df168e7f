// Which velocities move something: those that an energy has, and those of every coordinate that is
// below a time derivative in one or moves a mass.
#include <algorithm>

#include "check/judge/mechanics.hpp"
#include "elgen/references.hpp"

namespace elgen {
namespace {

using Expressions = std::vector<ExpressionId>;

template <class Ids>
void append(Expressions& all, const Ids& ids) {
  all.insert(all.end(), ids.begin(), ids.end());
}

/// What kinetic energy is made of, as it stands.
Expressions in_energies(const Model& model) {
  Expressions roots;
  for (const auto& energy : {model.energies.T, model.energies.L}) {
    if (energy) roots.push_back(*energy);
  }
  for (const Body& body : model.bodies) append(roots, body.spin);
  return reached(model, roots);
}

/// What is differentiated there by time, and the places of masses.
Expressions differentiated(const Model& model, const Expressions& energies) {
  Expressions roots;
  std::copy_if(energies.begin(), energies.end(), std::back_inserter(roots), [&](ExpressionId id) {
    return model.expressions[id].kind == ExpressionKind::time_derivative;
  });
  for (const Point& point : model.points) {
    if (has_energy(point)) append(roots, point.at);
  }
  for (const Body& body : model.bodies) {
    if (body.mass) append(roots, body.com);
  }
  return reached(model, roots);
}

}  // namespace

std::vector<bool> moving_velocities(const Model& model) {
  std::vector<bool> moving(model.velocities.size(), false);
  const auto mark = [&](const Coordinate& coordinate) {
    std::fill_n(moving.begin() + coordinate.velocity, coordinate.rotation ? axis_count : 1, true);
  };
  const auto mark_rates = [&](const Expressions& all) {
    for (const ExpressionId id : all) {
      const Expression& node = model.expressions[id];
      // E502 says what is wrong with an acceleration.
      const bool is_rate =
          node.kind == ExpressionKind::rate || node.kind == ExpressionKind::acceleration;
      if (is_rate) moving[node.index] = true;
    }
  };
  const Expressions energies = in_energies(model);
  const Expressions moved = differentiated(model, energies);
  mark_rates(energies);
  mark_rates(moved);
  for (const ExpressionId id : moved) {
    const Expression& node = model.expressions[id];
    if (node.kind == ExpressionKind::coordinate) mark(model.coordinates[node.index]);
  }
  for (const Coordinate& coordinate : model.coordinates) {
    if (coordinate.armature) mark(coordinate);
  }
  return moving;
}

}  // namespace elgen
