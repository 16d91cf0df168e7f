// lock: locked coordinates become given functions of time, and are no unknowns any more.
//
//     before    x = l*cos(q1) + l*cos(q1 + q2)     q = (q1, q2)     q1 locked at 0
//     after     x = l + l*cos(q2)                  q = (q2)
#include <algorithm>
#include <memory>

#include "specialise/passes.hpp"

namespace elgen {

namespace {

using GiNaC::ex;

/// Where the locked variables and their rates stand.
Seeds values_of(Lagrangian& lagrangian) {
  const Symbols& symbols = lagrangian.symbols;
  Definitions& definitions = lagrangian.definitions;
  Tangent passing(definitions, {{symbols.t, 1}}, "_dot");
  Seeds values;
  for (const LockedVariable& locked : lagrangian.locked) {
    for (std::size_t i = 0; i < locked.values.size(); ++i) {
      values.emplace(symbols.q[locked.coordinate + i], locked.values[i]);
    }
    // A rotation is locked at constants.
    const ex rate =
        locked.is_rotation ? ex(0) : define(definitions, passing(locked.values.front()));
    const ex acceleration = define(definitions, passing(rate));
    for (std::uint32_t i = 0; i < locked.velocity_count(); ++i) {
      values.emplace(symbols.v[locked.velocity + i], rate);
      values.emplace(symbols.a[locked.velocity + i], acceleration);
    }
  }
  return values;
}

std::vector<std::uint32_t> held(const Lagrangian& lagrangian) {
  std::vector<std::uint32_t> velocities;
  for (const LockedVariable& locked : lagrangian.locked) {
    if (!locked.reaction) continue;
    for (std::uint32_t i = 0; i < locked.velocity_count(); ++i) {
      velocities.push_back(locked.velocity + i);
    }
  }
  return velocities;
}

/// The definitions stay where they are: later ones are appended to the same list.
std::shared_ptr<const Lagrangian> without_definitions(Lagrangian& lagrangian) {
  Definitions definitions = std::move(lagrangian.definitions);
  lagrangian.definitions = {};
  auto copy = std::make_shared<const Lagrangian>(lagrangian);
  lagrangian.definitions = std::move(definitions);
  return copy;
}

/// Removes the indices of locked velocities, or coordinates, from lists as long as all of them.
class Removal {
 public:
  explicit Removal(std::size_t size) : locked_(size) {}

  void mark(std::size_t first, std::size_t count) {
    std::fill_n(locked_.begin() + static_cast<std::ptrdiff_t>(first), count, true);
  }

  template <class List>
  void operator()(List& list) const {
    List left;
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (!locked_[i]) left.push_back(list[i]);
    }
    list = std::move(left);
  }

  [[nodiscard]] bool has(std::size_t index) const { return locked_[index]; }

  /// Where an index that is left goes.
  [[nodiscard]] std::uint32_t operator()(std::uint32_t index) const {
    const auto end = locked_.begin() + index;
    return index - static_cast<std::uint32_t>(std::count(locked_.begin(), end, true));
  }

 private:
  std::vector<bool> locked_;
};

void remove_variables(Lagrangian& lagrangian) {
  Symbols& symbols = lagrangian.symbols;
  Removal coordinates(symbols.q.size());
  Removal velocities(symbols.v.size());
  for (const LockedVariable& locked : lagrangian.locked) {
    coordinates.mark(locked.coordinate, locked.values.size());
    velocities.mark(locked.velocity, locked.velocity_count());
  }
  const auto remove = [&](const LeafRow& row, auto& list) {
    if (row.of == LeafOwner::coordinates) coordinates(list);
    if (row.of == LeafOwner::velocities) velocities(list);
  };
  for_each_list(remove, symbols);
  for_each_list(remove, lagrangian.leaves);
  coordinates(symbols.q_rates);
  velocities(lagrangian.forces);
  std::vector<RotationPlace> rotations;
  for (const RotationPlace& place : symbols.rotations) {
    if (coordinates.has(place.first_coordinate)) continue;
    rotations.push_back({coordinates(place.first_coordinate), velocities(place.first_velocity)});
  }
  symbols.rotations = std::move(rotations);
  for (TreeStep& step : lagrangian.tree.steps) {
    if (!step.rotation) continue;
    const bool is_locked = velocities.has(*step.rotation);
    step.rotation = is_locked ? std::nullopt : std::optional(velocities(*step.rotation));
  }
}

}  // namespace

void lock(Lagrangian& lagrangian) {
  for (const LockedVariable& locked : lagrangian.locked) {
    for (const ex& value : locked.values) {
      const bool moves = dependence(lagrangian.definitions, value).has_any(Opcode::time);
      lagrangian.leaves.uses_time = lagrangian.leaves.uses_time || moves;
    }
  }
  Holding holding;
  holding.velocities = held(lagrangian);
  holding.values = values_of(lagrangian);
  if (!holding.velocities.empty()) holding.whole = without_definitions(lagrangian);
  replace(lagrangian, holding.values);
  remove_variables(lagrangian);
  lagrangian.locked.clear();
  if (holding.whole) lagrangian.holding = std::move(holding);
}

}  // namespace elgen
