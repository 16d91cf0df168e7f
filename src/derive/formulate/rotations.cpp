// The rates of quaternions: de/dt = 1/2 e (0, w), a product of quaternions.
#include "derive/formulate/rotations.hpp"

namespace elgen {

using GiNaC::ex;

std::array<std::array<ex, 3>, 4> rate_matrix(const Symbols& symbols,
                                             const RotationPlace& rotation) {
  const std::size_t first = rotation.first_coordinate;
  const ex w = symbols.q[first] / 2;
  const ex x = symbols.q[first + 1] / 2;
  const ex y = symbols.q[first + 2] / 2;
  const ex z = symbols.q[first + 3] / 2;
  return {{{-x, -y, -z}, {w, -z, y}, {z, w, -x}, {-y, x, w}}};
}

void add_coordinate_rates(const Model& model, Lagrangian& lagrangian) {
  Symbols& symbols = lagrangian.symbols;
  for (const Coordinate& coordinate : model.coordinates) {
    symbols.q_rates.push_back(symbols.v[coordinate.velocity]);
  }
  for (const Rotation& rotation : model.rotations) {
    const RotationPlace place{rotation.first_coordinate, rotation.first_velocity};
    symbols.rotations.push_back(place);
    const auto n = rate_matrix(symbols, place);
    for (std::uint32_t i = 0; i < quaternion_size; ++i) {
      const std::uint32_t component = place.first_coordinate + i;
      GiNaC::exvector terms;
      for (std::uint32_t k = 0; k < axis_count; ++k) {
        terms.push_back(n[i][k] * symbols.v[place.first_velocity + k]);
      }
      symbols.q_rates[component] = define(
          lagrangian.definitions, GiNaC::add(terms),
          {model.coordinates[component].identifier + "_dot", {EntityKind::coordinate, component}});
    }
  }
}

}  // namespace elgen
