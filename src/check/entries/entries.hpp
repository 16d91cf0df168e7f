// Entries: reads the keys of one instance of an entry into its row of the Model.
#pragma once

#include "check/expressions/expand.hpp"
#include "check/names/context.hpp"
#include "elgen/syntax.hpp"

namespace elgen {

/// Coordinates, inputs and prescribed functions: what other entries take units from.
void read_variable(Context& context, const Instance& instance);

/// Frames: the steps from the parent, and the pose.
void read_frame(Context& context, const Instance& instance);

/// Points and bodies.
void read_mass(Context& context, const Instance& instance);

/// Forces and outputs; needs the units of velocities.
void read_force_or_output(Context& context, const Instance& instance);

/// [model], [define], [gravity], [energy]: the tables that are not repeated.
void read_table(Context& context, const EntrySyntax& entry);

/// Unit of the generalized force on a velocity, whose power is in W.
[[nodiscard]] std::optional<Unit> force_unit(const Velocity& velocity);

}  // namespace elgen
