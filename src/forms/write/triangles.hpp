// triangles: the law of cosines without what cancels where a and b are alike.
//
//     before    C a^2 + C b^2 - 2 C a b cos(c)
//     after     C ((a - b)^2 + 4 a b sin(c/2)^2)
//
// Where squares are taken apart it is C ((a - b)^2 cos(c/2)^2 + (a + b)^2 sin(c/2)^2), which has
// all digits whatever the signs of a and b are. With + the sine and the cosine of c/2 change
// places.
#pragma once

#include <vector>

#include "forms/write/kept_digits.hpp"

namespace elgen {

/// Puts three such terms together as one; false where there are none.
[[nodiscard]] bool replace_triangle(Graph& graph, Keeping keeping, std::vector<Ref>& terms);

}  // namespace elgen
