// FrameQuantity: a quantity that the derivation lists for a frame, or for a body in a frame.
#pragma once

#include <cstdint>
#include <optional>

namespace elgen {

/// Angular velocity of a frame and velocity of its origin, in the axes of the frame; position,
/// velocity and kinetic energy of a body.
enum class FrameQuantityKind : std::uint8_t { spin, origin_velocity, position, velocity, energy };

struct FrameQuantity {
  FrameQuantityKind kind = {};
  /// For a position: index in Model::frames of the frame in which it is given; none: the world.
  std::optional<std::uint32_t> frame = {};
};

}  // namespace elgen
