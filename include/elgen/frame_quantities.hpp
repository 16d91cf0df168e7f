// FrameQuantity: a quantity that the derivation lists for a frame, or for a body in a frame.
#pragma once

#include <cstdint>

namespace elgen {

/// Of a frame, in its axes: angular velocity, and velocity of the origin. Of a centre of mass:
/// position in the world, or centre in the frame if the position is long; and velocity, in the
/// world or in the axes of the frame. Of a body: kinetic energy.
enum class FrameQuantity : std::uint8_t { spin, origin_rate, position, centre, velocity, energy };

}  // namespace elgen
