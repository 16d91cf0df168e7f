#include "analyse/generators.hpp"

namespace elgen {

GeneratorClass::GeneratorClass(const Model& model) : velocity_count(model.velocities.size()) {
  for (std::uint32_t i = 0; i < model.coordinates.size(); ++i) {
    if (model.coordinates[i].rotation) continue;
    coordinates.push_back(i);
    velocities.push_back(model.coordinates[i].velocity);
  }
  for (const Rotation& rotation : model.rotations) {
    rotations.push_back({rotation.first_coordinate, rotation.first_velocity});
  }
}

}  // namespace elgen
