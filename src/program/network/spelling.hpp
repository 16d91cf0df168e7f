// OperandName: a name built from the operands of a value.
//
//     m*l*cos(theta)     m_l_cos_theta          x/l                x_over_l
//     M + m              M_plus_m               1 - cos(theta)     one_minus_cos_theta
//
// Names precede calls, because sin_p_q reads as sin(p + q). A value with more than four names has
// no spelling, and neither has a value whose spelling would read as another value.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "elgen/program.hpp"

namespace elgen {

struct OperandName {
  enum class Begin : std::uint8_t { name, number, call };
  enum class End : std::uint8_t { name, call, divisor, sum };

  std::string text = {};  ///< "" if the value has no spelling
  std::size_t names = 1;
  bool has_intermediate = false;  ///< some names are of intermediate values, not of leaves
  Begin begin = Begin::name;
  End end = End::name;
};

/// Spells the constants 1, 2, 3, 4 and 1/2; other constants have no spelling.
[[nodiscard]] OperandName spell_name(const ConstantForm& form);

/// Spells an operation on values with the spellings `a` and `b`. If the operation has one operand,
/// `b` is not used, but must have a spelling.
[[nodiscard]] OperandName spell_name(const Instruction& operation, const OperandName& a,
                                     const OperandName& b);

}  // namespace elgen
