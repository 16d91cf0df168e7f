// Converts entries given in the axes of a frame to the world, the axes that the oracle and every
// user of positions read.
#pragma once

#include "check/expressions/node_builder.hpp"
#include "check/names/context.hpp"

namespace elgen {

/// R x + origin of the frame.
[[nodiscard]] Vector3 world_position(NodeBuilder& nodes, const PlaceInFrame& place);

/// Sets com, spin and the inertia about the com from `local`, whose com and inertia are in the axes
/// of its frame. Keeps `local` in the body.
void set_world_pose(Context& context, BodyInFrame local, Body& body);

/// One to three components, padded with 0 to three.
[[nodiscard]] Vector3 pad_to_three(const std::vector<ExpressionId>& components);

/// Sets the pose [R p] (row-major) and the twist (angular velocity, velocity of the origin) of a
/// frame's output.
void write_frame_output(Context& context, UserOutput& output);

}  // namespace elgen
