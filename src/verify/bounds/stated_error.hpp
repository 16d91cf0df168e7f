// Stated error: how far a reduced output may be from the exact model, beside rounding.
#pragma once

#include "elgen/evaluate.hpp"
#include "elgen/oracle.hpp"
#include "elgen/program.hpp"

namespace elgen {

/// Of one entry at a state inside the ranges, which rounding may have left by one part in 2^20; 0
/// where the output is exact.
[[nodiscard]] Real stated_error(const Program& program, OutputKind output, std::size_t entry,
                                const State& state);

}  // namespace elgen
