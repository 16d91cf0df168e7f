// The table of identities between the functions of a program.
#pragma once

#include <string_view>
#include <vector>

#include "balance.hpp"
#include "exact_values.hpp"

namespace elgen {

struct Identity {
  std::string_view check;
  std::string_view formula;
  std::vector<OutputKind>
      functions;  ///< which the program must have; the first is the row's subject
  Balance (*balance)(ExactValues& at);  ///< the left side less the right side
};

[[nodiscard]] const std::vector<Identity>& identities();

/// J - dy/dq and bias - d^2 y/dt^2 (at a = 0) of the user's output. Of a frame y is a pose, and its
/// twist stands for dy/dt: quaternions must be of norm 1 then.
[[nodiscard]] Balance jacobian_balance(ExactValues& at, std::uint32_t user);
[[nodiscard]] Balance output_bias_balance(ExactValues& at, std::uint32_t user);

}  // namespace elgen
