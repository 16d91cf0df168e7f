// SpeltName: what a value is made of, as a name.
//
//     m*l*cos(theta)     m_l_cos_theta          x/l                x_over_l
//     M + m              M_plus_m               1 - cos(theta)     one_minus_cos_theta
//
// Names stand before calls, so that q_sin_p is no sine of p + q. What has more than four names, or
// would read as something else, has no spelling.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "elgen/program.hpp"

namespace elgen {

struct SpeltName {
  enum class Begin : std::uint8_t { name, number, call };
  enum class End : std::uint8_t { name, call, divisor, sum };

  std::string text = {};  ///< "" for none
  std::size_t names = 1;
  bool is_told = false;  ///< some names are those of values, not of leaves
  Begin begin = Begin::name;
  End end = End::name;
};

/// Spells a constant; none but 1, 2, 3, 4 and 1/2.
[[nodiscard]] SpeltName spelt(const ConstantForm& form);

/// Spells an operation on spelt values; `b` where it has two operands.
[[nodiscard]] SpeltName spelt(const Instruction& operation, const SpeltName& a, const SpeltName& b);

}  // namespace elgen
