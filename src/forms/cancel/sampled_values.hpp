// Sampled values: whether the values of a function are 0 at a random point, in 64 digits.
//
// A value x is 0 if 64 digits cannot tell it from 0: |x| <= 1e-40 E, with E the running error of x,
// and 1e-40 E is at most 1e-20 of the largest operand. Later instructions then use exactly 0.
#pragma once

#include <cln/rational.h>

#include <optional>
#include <vector>

#include "elgen/leaves.hpp"
#include "elgen/program.hpp"

namespace elgen {

/// The values of the leaves, and of the instructions that count as variables.
struct RandomPoint {
  LeafValues<cln::cl_RA> leaves = {};
  std::vector<std::optional<cln::cl_RA>> variables = {};  ///< by instruction
};

enum class SampledValue : std::uint8_t {
  nonzero,  ///< or undecided, because digits are lost
  zero,
  undefined,
};

/// For each instruction: its value at `point`; `nonzero` if the instruction is not `needed`. Values
/// have 64 digits, their running errors are computed in double. If these errors are too rough for a
/// comparison, or if digits are lost, sample_in_64_digits() decides. Cost per needed
/// instruction: one operation of Real; about ten more if sample_in_64_digits() decides.
[[nodiscard]] std::vector<SampledValue> sample_values(const Program& program,
                                                      const Function& function,
                                                      const std::vector<bool>& needed,
                                                      const RandomPoint& point);

/// The same values, with errors in 64 digits.
[[nodiscard]] std::vector<SampledValue> sample_in_64_digits(const Program& program,
                                                            const Function& function,
                                                            const std::vector<bool>& needed,
                                                            const RandomPoint& point);

}  // namespace elgen
