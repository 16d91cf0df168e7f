// Unit expressions: `kg*m^2/s`, `N/(m*s)`, `m^(1/2)`, `1`.
#pragma once

#include <optional>

#include "base/report.hpp"
#include "elgen/syntax.hpp"
#include "elgen/units.hpp"

namespace elgen {

/// The unit a string names; nothing after E402. `*` and `/` bind from left to right. `value` is
/// what is given in it, where that is known.
[[nodiscard]] std::optional<Unit> read_unit(const ValueSyntax& unit, Report& report,
                                            const ValueSyntax* value = nullptr);

}  // namespace elgen
