// Entries: reads the keys of one instance of an entry into its row of the Model, `target`.
#pragma once

#include "check/expressions/values.hpp"

namespace elgen {

void read_coordinate(ValueReader& values, const EntrySyntax& entry, std::uint32_t target);
void read_input(ValueReader& values, const EntrySyntax& entry, std::uint32_t target);

/// Reads the key `of` of a [[function]], open or closed. Must precede the resolution of every
/// expression that names the function. E104.
void read_arguments(ValueReader& values, const EntrySyntax& entry, std::uint32_t target);
/// Reads the unit of a [[function]], and its sample or the expression that replaces the function.
void read_function(ValueReader& values, const EntrySyntax& entry, std::uint32_t target);

void read_prescribed(ValueReader& values, const EntrySyntax& entry, std::uint32_t target);

/// Reads the transforms from the parent, and derives the pose in the world.
void read_frame(ValueReader& values, const EntrySyntax& entry, std::uint32_t target);

/// If vectors have 2 components, reports E516 for every frame step that leaves the plane: a turn
/// about an axis other than z, or a shift along z.
void check_plane(Context& context);

void read_point(ValueReader& values, const EntrySyntax& entry, std::uint32_t target);
void read_body(ValueReader& values, const EntrySyntax& entry, std::uint32_t target);

/// Reads a [[force]]. The units of all velocities must have been read.
void read_force(ValueReader& values, const EntrySyntax& entry, std::uint32_t target);
/// Adds the forces of an input that declares a wrench or a point force (wrench_input.hpp).
void read_wrench_input(ValueReader& values, const EntrySyntax& entry, std::uint32_t first);
/// Replaces each entry in Model::constraints by its equations, in the order of the file.
void read_constraints(Context& context, const std::vector<EntryInstance>& instances);
void read_output(ValueReader& values, const EntrySyntax& entry, std::uint32_t target);

/// Reads an [[equilibrium]]: E201, E517, E612. The units of all coordinates and inputs must have
/// been read.
void read_equilibrium(ValueReader& values, const EntrySyntax& entry, std::uint32_t target);

/// Reads a table that is not repeated: [model], [define], [gravity], [energy] or [outputs].
void read_table(Context& context, const EntrySyntax& entry);

/// Unit of the generalised force on a velocity: force times velocity is in W.
[[nodiscard]] std::optional<Unit> force_unit(const Velocity& velocity);

}  // namespace elgen
