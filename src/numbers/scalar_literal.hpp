// scalar_literal: what built-in scalars make of exact numbers, and the literals that they read.
//
//     9.81   9.81      1/3 in float   0.33333334      pi in double   3.141592653589793
#pragma once

#include <cln/real.h>

#include <optional>
#include <string>

#include "elgen/scalars.hpp"

namespace elgen {

/// How a value fares in a built-in scalar. `too_small` is 0 or a subnormal where the value is not
/// 0.
enum class Fit : std::uint8_t { fits, too_large, too_small };

[[nodiscard]] Fit fit(const cln::cl_R& value, ScalarKind scalar);

/// The shortest decimal that the scalar reads back as its nearest value; the value must fit.
[[nodiscard]] std::string shortest_literal(const cln::cl_R& value, ScalarKind scalar);

/// The same, but decimals of up to 17 digits stay as they are. Without a suffix.
[[nodiscard]] std::string scalar_literal(const cln::cl_R& value, ScalarKind scalar);

/// The same, behind the sign of the value.
[[nodiscard]] std::string signed_literal(const cln::cl_R& value, ScalarKind scalar);

/// The value itself where a float holds it exactly (0, 2, -1/2) and 17 digits write it.
[[nodiscard]] std::optional<std::string> exact_in_float(const cln::cl_R& value);

}  // namespace elgen
