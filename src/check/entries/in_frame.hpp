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

/// Components in the axes of `from` (none: the world) as components in those of `to`: R_to^T R_from
/// x.
[[nodiscard]] Vector3 turned(NodeBuilder& nodes, const Vector3& x,
                             std::optional<std::uint32_t> from, std::optional<std::uint32_t> to);

/// The pose as values and the twist (angular velocity; velocity of the origin) of a frame's output.
void write_frame_output(Context& context, UserOutput& output);

/// The nine entries of the frame's rotation, and its origin, as leaves.
[[nodiscard]] Matrix3 rotation_of(NodeBuilder& nodes, std::uint32_t frame);
[[nodiscard]] Vector3 origin_of(NodeBuilder& nodes, std::uint32_t frame);

}  // namespace elgen
