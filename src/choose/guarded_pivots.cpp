// guarded_pivots: two instructions per pivot, but where M_ii is a number, or divides already.
#include "choose/guarded_pivots.hpp"

#include <utility>

#include "lower/graph/prune.hpp"
#include "lower/network/instructions.hpp"

namespace elgen {
namespace {

bool has_diagonal(const Function& function) {
  return !function.fields.empty() && function.fields.back().name == diagonal_field;
}

}  // namespace

Function without_diagonal(Function forward_dynamics) {
  if (!has_diagonal(forward_dynamics)) return forward_dynamics;
  forward_dynamics.fields.pop_back();
  const auto count = static_cast<std::uint32_t>(entry_count(forward_dynamics));
  std::erase_if(forward_dynamics.sampled_zeros,
                [count](std::uint32_t entry) { return entry >= count; });
  return pruned(forward_dynamics);
}

Function with_guarded_pivots(Function forward_dynamics, std::vector<Constant>& constants) {
  if (!has_diagonal(forward_dynamics)) return forward_dynamics;
  const std::vector<std::uint32_t> diagonal = forward_dynamics.fields.back().entries;
  std::vector<std::uint32_t>& pivots = forward_dynamics.fields[1].entries;
  Instructions instructions(forward_dynamics);
  const Instruction zero{.opcode = Opcode::constant,
                         .a = position_of(rational_constant(0), constants)};
  for (std::size_t i = 0; i < diagonal.size(); ++i) {
    const Instruction pivot = forward_dynamics.instructions[pivots[i]];
    const bool is_guarded = pivot.opcode == Opcode::divide && pivot.b == diagonal[i];
    const bool is_number = forward_dynamics.instructions[diagonal[i]].opcode == Opcode::constant;
    if (is_guarded || is_number) continue;
    const std::uint32_t guard =
        instructions.add(Opcode::divide, instructions.add(zero), diagonal[i]);
    pivots[i] = instructions.add(Opcode::add, pivots[i], guard);
  }
  return without_diagonal(std::move(forward_dynamics));
}

}  // namespace elgen
