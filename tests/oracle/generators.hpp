// The first two generators of jets.
#pragma once

#include "oracle/jet.hpp"

namespace elgen::test {

inline constexpr oracle::Generators e0 = oracle::generator(0);
inline constexpr oracle::Generators e1 = oracle::generator(1);

}  // namespace elgen::test
