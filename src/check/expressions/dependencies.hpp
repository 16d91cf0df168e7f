// Dependencies among definitions, prescribed functions, points and frames.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "check/names/context.hpp"

namespace elgen {

/// The roots in an order in which what is named comes before what names it; nothing after E206,
/// which prints the cycle: `a -> b -> a`.
[[nodiscard]] std::optional<std::vector<std::uint32_t>> dependency_order(Context& context);

}  // namespace elgen
