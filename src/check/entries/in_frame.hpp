// Quantities given in the axes of a frame, expressed in those of the world as well: the oracle and
// everything that needs positions reads them there.
#pragma once

#include "check/expressions/node_builder.hpp"
#include "check/names/context.hpp"

namespace elgen {

/// R x + origin.
[[nodiscard]] Vector3 world_position(NodeBuilder& nodes, const PlaceInFrame& place);

/// com and inertia of the body are in the axes of `local`'s frame, and stay so there; com, spin and
/// inertia about the com follow from it.
void put_in_frame(Context& context, BodyInFrame local, Body& body);

/// One to three components, and the 0 for those that are not there.
[[nodiscard]] Vector3 padded(const std::vector<ExpressionId>& components);

/// The pose as values and the twist (angular velocity; velocity of the origin) of a frame's output.
void write_frame_output(Context& context, UserOutput& output);

}  // namespace elgen
