// Shrinks a failing system while it fails in the same way.
#pragma once

#include <functional>

#include "random/model.hpp"

namespace elgen::test::random {

/// Removes entries, keys and parts of expressions from `system`, one at a time, as long as `fails`
/// remains true.
[[nodiscard]] System minimised(System system, const std::function<bool(const System&)>& fails);

}  // namespace elgen::test::random
