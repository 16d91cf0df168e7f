// Velocities: every coordinate comes with the entries of v that move it.
#include <utility>

#include "elgen/model.hpp"

namespace elgen {

std::uint32_t append_coordinate(Model& model, Coordinate coordinate) {
  const auto index = static_cast<std::uint32_t>(model.coordinates.size());
  coordinate.velocity = static_cast<std::uint32_t>(model.velocities.size());
  Velocity velocity;
  velocity.name = coordinate.name;
  velocity.identifier = coordinate.identifier;
  velocity.coordinate = index;
  velocity.unit_text = coordinate.unit_text;
  velocity.span = coordinate.span;
  if (coordinate.unit) velocity.unit = *coordinate.unit / *find_unit("s");
  model.velocities.push_back(std::move(velocity));
  model.coordinates.push_back(std::move(coordinate));
  return index;
}

}  // namespace elgen
