// Entries: reads the keys of one instance of an entry into its row of the Model, `target`.
#pragma once

#include "check/expressions/values.hpp"

namespace elgen {

void read_coordinate(ValueReader& values, const EntrySyntax& entry, std::uint32_t target);
void read_input(ValueReader& values, const EntrySyntax& entry, std::uint32_t target);

/// The key `of` of a [[function]], open or closed, before anything names it. E104.
void read_arguments(ValueReader& values, const EntrySyntax& entry, std::uint32_t target);
/// Its other keys; of a closed one the expression that its definition has.
void read_function(ValueReader& values, const EntrySyntax& entry, std::uint32_t target);

void read_prescribed(ValueReader& values, const EntrySyntax& entry, std::uint32_t target);

/// The steps from the parent, and the pose.
void read_frame(ValueReader& values, const EntrySyntax& entry, std::uint32_t target);

/// E516 for every step of a frame that leaves the plane of a model whose vectors have 2 components:
/// a turn about an axis other than z, or a shift along z.
void check_plane(Context& context);

void read_point(ValueReader& values, const EntrySyntax& entry, std::uint32_t target);
void read_body(ValueReader& values, const EntrySyntax& entry, std::uint32_t target);

/// Needs the units of velocities.
void read_force(ValueReader& values, const EntrySyntax& entry, std::uint32_t target);
/// Adds the forces of inputs that are components of a wrench or a force (wrench_input.hpp).
void read_wrench_input(ValueReader& values, const EntrySyntax& entry, std::uint32_t first);
/// Replaces the entries of the Model by their equations, in the order of the file.
void read_constraints(Context& context, const std::vector<Instance>& instances);
void read_output(ValueReader& values, const EntrySyntax& entry, std::uint32_t target);

/// Needs the units of coordinates and inputs. E201, E517, E612.
void read_equilibrium(ValueReader& values, const EntrySyntax& entry, std::uint32_t target);

/// [model], [define], [gravity], [energy]: the tables that are not repeated.
void read_table(Context& context, const EntrySyntax& entry);

/// Unit of the generalized force on a velocity, whose power is in W.
[[nodiscard]] std::optional<Unit> force_unit(const Velocity& velocity);

}  // namespace elgen
