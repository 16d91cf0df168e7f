// exact_value: the way back from binary numbers.
#pragma once

#include <cln/real.h>

namespace elgen {

/// The rational a binary number is; 0 where it is none.
[[nodiscard]] cln::cl_R exact_value(double value);

}  // namespace elgen
