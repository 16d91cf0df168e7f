// written_out: one pass, operands before what they go into.
#include "program/graph/written_out.hpp"

#include <algorithm>

namespace elgen {

std::vector<std::size_t> written_out_sizes(const Function& function, std::size_t most) {
  std::vector<std::size_t> sizes;
  for (const Instruction& i : function.instructions) {
    const std::size_t operands = operand_count(i);
    std::size_t size = operands > 0 ? 1 + sizes[i.a] : 0;
    if (operands > 1) size += sizes[i.b];
    sizes.push_back(std::min(size, most + 1));
  }
  return sizes;
}

}  // namespace elgen
