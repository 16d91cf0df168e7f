// scalar_literal: exact numbers rounded to built-in scalars, and the literals for them.
//
//     9.81   9.81      1/3 in float   0.33333334      pi in double   3.141592653589793
#pragma once

#include <cln/real.h>

#include <optional>
#include <string>

#include "elgen/scalars.hpp"

namespace elgen {

/// Whether a built-in scalar can hold a value. `too_small`: a nonzero value becomes 0 or subnormal.
enum class ScalarFit : std::uint8_t { fits, too_large, too_small };

[[nodiscard]] ScalarFit scalar_fit(const cln::cl_R& value, ScalarKind scalar);

/// The shortest decimal that reads back as the number of the scalar type nearest to `value`; 40
/// digits for long double. The value must fit.
[[nodiscard]] std::string shortest_literal(const cln::cl_R& value, ScalarKind scalar);

/// Like shortest_literal, but an exact decimal of up to 17 digits is kept. No suffix.
[[nodiscard]] std::string scalar_literal(const cln::cl_R& value, ScalarKind scalar);

/// scalar_literal of the magnitude, after "-" if the value is negative.
[[nodiscard]] std::string signed_literal(const cln::cl_R& value, ScalarKind scalar);

/// The exact decimal if float represents the value exactly (0, 2, -1/2) and 17 digits suffice;
/// otherwise none.
[[nodiscard]] std::optional<std::string> exact_float_literal(const cln::cl_R& value);

}  // namespace elgen
