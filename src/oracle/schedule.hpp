// Schedule: the expressions that some roots need, operands first, each with how often it is
// differentiated by time above it.
//
// The order is found once per output; an evaluation then walks a list.
#pragma once

#include <cstdint>
#include <vector>

#include "elgen/model.hpp"

namespace elgen::oracle {

/// An expression whose value (order 0), rate (order 1) or second rate (order 2) is wanted.
struct Root {
  ExpressionId expression = 0;
  unsigned time_order = 0;
};

struct Schedule {
  std::vector<ExpressionId> order = {};  ///< operands precede their users
  std::vector<std::uint32_t> slots =
      {};  ///< position in `order`, for every expression of the model that is in it
  std::vector<unsigned> time_orders =
      {};  ///< of each position: order of the time derivative needed
};

[[nodiscard]] Schedule make_schedule(const Model& model, const std::vector<Root>& roots);

}  // namespace elgen::oracle
