// remove_variables: takes variables out of every list of a Lagrangian; later entries move up.
#include <algorithm>
#include <optional>

#include "derive/specialise/passes.hpp"

namespace elgen {

namespace {

/// Removes the indices of velocities, or coordinates, from lists as long as all of them.
class Removal {
 public:
  explicit Removal(std::size_t size) : removed_(size) {}

  void mark(std::size_t first, std::size_t count) {
    std::fill_n(removed_.begin() + static_cast<std::ptrdiff_t>(first), count, true);
  }

  template <class List>
  void operator()(List& list) const {
    List left;
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (!removed_[i]) left.push_back(list[i]);
    }
    list = std::move(left);
  }

  [[nodiscard]] bool has(std::size_t index) const { return removed_[index]; }

  /// Where an index that is left goes.
  [[nodiscard]] std::uint32_t operator()(std::uint32_t index) const {
    const auto end = removed_.begin() + index;
    return index - static_cast<std::uint32_t>(std::count(removed_.begin(), end, true));
  }

 private:
  std::vector<bool> removed_;
};

}  // namespace

void remove_variables(Lagrangian& lagrangian, const std::vector<Held>& variables) {
  Symbols& symbols = lagrangian.symbols;
  Removal coordinates(symbols.q.size());
  Removal velocities(symbols.v.size());
  for (const Held& variable : variables) {
    coordinates.mark(variable.coordinate, variable.coordinate_count());
    velocities.mark(variable.velocity, variable.velocity_count());
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
    const bool is_gone = velocities.has(*step.rotation);
    step.rotation = is_gone ? std::nullopt : std::optional(velocities(*step.rotation));
  }
  for (CyclicVariable& cyclic : lagrangian.cyclic) {
    cyclic.coordinate = coordinates(cyclic.coordinate);
    cyclic.velocity = velocities(cyclic.velocity);
  }
}

}  // namespace elgen
