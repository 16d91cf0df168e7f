// homogeneous_terms: sums of sines and cosines that do not cancel where one of them is 1.
//
//     A + (C - A) cos(x)^2   ->   A sin(x)^2 + C cos(x)^2        1 - cos(x)   ->   2 sin(x/2)^2
//
// The factor of one product of other atoms is a sum of e^(i k x). With c = cos x and s = sin x,
// e^(i k x) = (c + i s)^((d + k)/2) (c - i s)^((d - k)/2) has d factors, whatever k is, where d is
// the largest k of the sum. Where both even and odd k occur, x/2 takes the place of x. Two sines,
// or two cosines, of different angles become one product:
//
//     sin(x) + sin(y)   ->   2 sin((x + y)/2) cos((x - y)/2)
#pragma once

#include <optional>
#include <vector>

#include "forms/write/real_terms.hpp"

namespace elgen {

/// None where there would be more than `most` terms, or high powers. A sum over several angles
/// keeps what has none of them as it is.
[[nodiscard]] std::optional<std::vector<RealTerm>> homogeneous_terms(const Algebra& algebra,
                                                                     const Polynomial& sum,
                                                                     std::size_t most);

}  // namespace elgen
