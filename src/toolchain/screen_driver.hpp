// The driver that screens states: the emitted C++ header in double or float beside itself in 50
// digits (templates/screen/number.hpp.mustache).
#pragma once

#include "toolchain/driver.hpp"

namespace elgen {

/// Judges all fields at one state: `figures` of the first field, of the second, ...
template <class Scalar>
using ScreenFunction = void (*)(
#define ELGEN_LEAVES(kind, member, ...) const Scalar *member,
#define ELGEN_LEAF(kind, member, ...) Scalar member,
#include "elgen/leaves.def"
#undef ELGEN_LEAVES
#undef ELGEN_LEAF
    double* figures);

/// Of a scene in C++.
[[nodiscard]] Driver screen_driver(const DriverInput& input);

/// "elgen_screen_double"
[[nodiscard]] std::string screen_symbol(std::string_view scalar);

}  // namespace elgen
