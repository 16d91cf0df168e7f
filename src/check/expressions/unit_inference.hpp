// Units of expressions: inferred from the leaves, compared where terms meet and where a place asks.
#pragma once

#include <cstdint>
#include <vector>

#include "check/names/context.hpp"

namespace elgen {

/// E401, E403, E404, and one note E520 that lists what has no unit. `order` as for find_traits.
void check_units(Context& context, const std::vector<std::uint32_t>& order);

}  // namespace elgen
