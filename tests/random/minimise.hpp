// Shrinks a failing system while it fails in the same way.
#pragma once

#include <functional>

#include "random/model.hpp"

namespace elgen::test::random {

/// Removes entries, keys and parts of expressions, one at a time, while `fails` is true.
[[nodiscard]] System minimised(System system, const std::function<bool(const System&)>& fails);

}  // namespace elgen::test::random
