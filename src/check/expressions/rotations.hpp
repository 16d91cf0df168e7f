// Rotations: coordinates of `kind = "rotation"`, unit quaternions with angular velocities.
#pragma once

#include <cstdint>
#include <optional>

#include "check/expressions/values.hpp"
#include "check/names/context.hpp"
#include "elgen/syntax.hpp"

namespace elgen {

[[nodiscard]] bool is_rotation(const EntrySyntax& entry);

/// Declares NAME[1..3] and NAME_w … NAME_z and adds the rotation to the Model; its index. E112
/// where it is repeated, E203, E204, E205, E211.
[[nodiscard]] std::optional<std::uint32_t> declare_rotation(Context& context,
                                                            const EntrySyntax& entry,
                                                            const NewName& name);

/// Reads its keys. E112 for keys that only numbers have, and for a start of another length than 1;
/// E403 for a unit.
void read_rotation(ValueReader& values, const EntrySyntax& entry, std::uint32_t target);

/// E513 for a rotation that turns no frame, E112 where it turns two.
void check_rotations(Context& context);

}  // namespace elgen
