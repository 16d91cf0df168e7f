// Like terms of a sum that `sum(i, low, high, ...)` writes out.
#pragma once

#include <vector>

#include "check/names/context.hpp"

namespace elgen {

/// Adds terms that differ in a rational factor only:
///
///     1*k*x + 2*k*x + 3*k*x + y   ->   6*k*x, y
///
/// Terms without a like one stay the nodes that they are, and so does a sum of many kinds of terms.
/// Without it each of ten thousand terms would be differentiated and compared for itself.
[[nodiscard]] std::vector<ExpressionId> with_like_terms_added(
    Context& context, const std::vector<ExpressionId>& terms);

}  // namespace elgen
