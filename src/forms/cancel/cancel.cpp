// cancel: see elgen/cancel.hpp. Treats one function at a time. A function without zeros is
// unchanged.
#include "elgen/cancel.hpp"

#include <algorithm>

#include "elgen/closed_forms.hpp"
#include "forms/cancel/vanishing.hpp"
#include "program/network/cheapest.hpp"
#include "program/network/linearise.hpp"

namespace elgen {
namespace {

using InstructionNumbers = std::vector<std::uint32_t>;

std::vector<bool> mark_instructions(const Function& function, const InstructionNumbers& places) {
  std::vector<bool> result(function.instructions.size(), false);
  for (const std::uint32_t at : places) result[at] = true;
  return result;
}

/// The instructions in `zeros` that are entries, or operands of instructions outside `zeros`.
InstructionNumbers outermost_zeros(const Function& function, const InstructionNumbers& zeros) {
  const std::vector<bool> is_zero = mark_instructions(function, zeros);
  std::vector<bool> used = mark_instructions(function, entries_of(function));
  for (std::size_t at = 0; at < used.size(); ++at) {
    const Instruction& i = function.instructions[at];
    if (is_zero[at]) continue;
    if (operand_count(i) > 0) used[i.a] = true;
    if (operand_count(i) > 1) used[i.b] = true;
  }
  InstructionNumbers result;
  std::copy_if(zeros.begin(), zeros.end(), std::back_inserter(result),
               [&used](std::uint32_t at) { return used[at]; });
  return result;
}

/// Instructions of a function that are 0, by kind of evidence.
struct Zeros {
  InstructionNumbers proved = {};   ///< the closed form is the empty sum
  InstructionNumbers sampled = {};  ///< analytic, and 0 at `zero_sample_count` points

  [[nodiscard]] InstructionNumbers all() const {
    InstructionNumbers places = proved;
    places.insert(places.end(), sampled.begin(), sampled.end());
    return places;
  }
};

Zeros classify_zeros(const Program& program, const Function& function,
                     const InstructionNumbers& places) {
  Zeros zeros;
  InstructionNumbers open;
  const std::vector<ZeroProof> proofs = prove_zeros(program, with_entries(function, places));
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (proofs[i] == ZeroProof::zero) zeros.proved.push_back(places[i]);
    if (proofs[i] == ZeroProof::undecided) open.push_back(places[i]);
  }
  const std::vector<bool> vanish = find_vanishing_entries(program, with_entries(function, open));
  for (std::size_t i = 0; i < open.size(); ++i) {
    if (vanish[i]) zeros.sampled.push_back(open[i]);
  }
  return zeros;
}

/// The outermost zeros. If an outermost candidate is not 0, one of its operands may still be 0, so
/// all candidates are then classified.
Zeros find_zeros(const Program& program, const Function& function) {
  const InstructionNumbers candidates = find_vanishing_values(program, function);
  const InstructionNumbers places = outermost_zeros(function, candidates);
  Zeros zeros = classify_zeros(program, function, places);
  if (zeros.proved.size() + zeros.sampled.size() == places.size()) return zeros;
  zeros = classify_zeros(program, function, candidates);
  const std::vector<bool> is_outermost =
      mark_instructions(function, outermost_zeros(function, zeros.all()));
  const auto is_inside = [&is_outermost](std::uint32_t at) { return !is_outermost[at]; };
  std::erase_if(zeros.proved, is_inside);
  std::erase_if(zeros.sampled, is_inside);
  return zeros;
}

/// The indices, over all fields, of the entries that depend on one of `places`.
InstructionNumbers dependent_entries(const Function& function, const InstructionNumbers& places) {
  std::vector<bool> is_dependent = mark_instructions(function, places);
  for (std::size_t at = 0; at < is_dependent.size(); ++at) {
    const Instruction& i = function.instructions[at];
    if (operand_count(i) > 0 && is_dependent[i.a]) is_dependent[at] = true;
    if (operand_count(i) > 1 && is_dependent[i.b]) is_dependent[at] = true;
  }
  InstructionNumbers result;
  const InstructionNumbers entries = entries_of(function);
  for (std::uint32_t i = 0; i < entries.size(); ++i) {
    if (is_dependent[entries[i]]) result.push_back(i);
  }
  return result;
}

/// Longer functions are lowered without a search for shorter sums and products. The search would
/// take as long as the first lowering, and removing a few zeros rarely shortens other sums.
constexpr std::size_t largest_optimised_graph = 2'000;

Network network_of(const Expressions& expressions, const Function& function) {
  if (expressions.graph.size() <= largest_optimised_graph) {
    return cheapest_network(expressions, function);
  }
  Network network = make_network(expressions);
  flip_signs(network);
  return network;
}

/// Lowers the function again, with 0 in place of `zeros`.
Function lower_without_zeros(const Zeros& zeros, const Function& function, Program& program) {
  const Expressions expressions = expressions_from_program(
      program, function, entries_of(function), mark_instructions(function, zeros.all()));
  Function result = without_instructions(function);
  linearise(network_of(expressions, result), program, result);
  result.sampled_zeros = dependent_entries(function, zeros.sampled);
  return result;
}

}  // namespace

Program cancel(Program program) {
  for (Function& function : program.functions) {
    const Zeros zeros = find_zeros(program, function);
    if (zeros.proved.empty() && zeros.sampled.empty()) continue;
    function = lower_without_zeros(zeros, function, program);
  }
  require_invariants(program);
  return program;
}

}  // namespace elgen
