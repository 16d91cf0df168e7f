// Shrinks a failing system while it fails in the same way.
#pragma once

#include <functional>

#include "random/model.hpp"

namespace elgen::test::random {

/// `system` after every removal of a single entry, key or part of an expression that keeps `fails`
/// true.
[[nodiscard]] System minimised(System system, const std::function<bool(const System&)>& fails);

}  // namespace elgen::test::random
