// Converts positions, inertias and twists from the axes of a frame to world axes. The oracle and
// all other code expect positions in world axes.
#pragma once

#include "check/expressions/node_builder.hpp"
#include "check/names/context.hpp"

namespace elgen {

/// R x + origin of the frame.
[[nodiscard]] Vector3 world_position(NodeBuilder& nodes, const PointInFrame& place);

/// Sets com, spin and the inertia about the com of `body`. The com and inertia of `local` are in
/// the axes of its frame; the body also keeps `local`.
void set_world_pose(Context& context, LocalBody local, Body& body);

/// `components` (one to three), padded with zeros to three.
[[nodiscard]] Vector3 pad_to_three(const std::vector<ExpressionId>& components);

/// Sets the pose [R p] (row-major) and the twist (angular velocity, velocity of the origin) of a
/// frame's output.
void set_frame_output(Context& context, UserOutput& output);

}  // namespace elgen
