// FrameQuantity: a quantity that the derivation lists for a frame, or for a body in a frame.
#pragma once

#include <cstdint>

namespace elgen {

/// A frame has an angular velocity and the velocity of its origin, in its axes. A centre of mass
/// has a position in the world, or a centre in the frame if the position is long, and a velocity in
/// the world or in the axes of the frame. A body has a kinetic energy.
enum class FrameQuantity : std::uint8_t { spin, origin_rate, position, centre, velocity, energy };

}  // namespace elgen
