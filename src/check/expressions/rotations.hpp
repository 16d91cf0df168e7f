// Rotations: coordinates of `kind = "rotation"`, unit quaternions with angular velocities.
#pragma once

#include <cstdint>
#include <optional>

#include "check/expressions/values.hpp"
#include "check/names/context.hpp"
#include "elgen/syntax.hpp"

namespace elgen {

[[nodiscard]] bool is_rotation(const EntrySyntax& entry);

/// Declares NAME[1..3] and NAME_w … NAME_z, and adds the rotation to the Model; returns its index.
/// E112 if the entry is repeated; E203, E204, E205, E211.
[[nodiscard]] std::optional<std::uint32_t> declare_rotation(Context& context,
                                                            const EntrySyntax& entry,
                                                            const NewName& name);

/// Reads the keys of a rotation. E104 for a start with a wrong number of components. E112 for a key
/// of plain coordinates, or a start quaternion of length 0; E403 for a unit other than 1.
void read_rotation(ValueReader& values, const EntrySyntax& entry, std::uint32_t target);

/// Reports E513 for a rotation that turns no frame, and E112 for a rotation that turns two frames.
void check_rotations(Context& context);

}  // namespace elgen
