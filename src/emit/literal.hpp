// literal: an exact number -> the floating literal of C and C++ that a built-in scalar reads back
// as its nearest value.
//
//     9.81   9.81      1/3 in float   0.33333334      pi in double   3.141592653589793
#pragma once

#include <cln/real.h>

#include <string>

#include "elgen/scene.hpp"

namespace elgen {

/// Without a suffix; the value must fit the scalar. Decimals of up to 17 digits stay as they are.
[[nodiscard]] std::string scalar_literal(const cln::cl_R& value, ScalarKind scalar);

}  // namespace elgen
