// Cycles among definitions, prescribed functions, points and frames.
#pragma once

#include "check/names/context.hpp"

namespace elgen {

/// False after E206, which prints the cycle: `a -> b -> a`.
[[nodiscard]] bool check_cycles(Context& context);

}  // namespace elgen
