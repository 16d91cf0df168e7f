// Makes a failing system smaller for as long as it fails in the same way.
#pragma once

#include <functional>

#include "random/model.hpp"

namespace elgen::random {

/// Leaves out entries, keys and parts of expressions, one at a time, while `fails` holds.
[[nodiscard]] System minimised(System system, const std::function<bool(const System&)>& fails);

}  // namespace elgen::random
