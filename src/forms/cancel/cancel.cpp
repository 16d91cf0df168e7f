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

using Places = std::vector<std::uint32_t>;  ///< instruction numbers

std::vector<bool> flags_at(const Function& function, const Places& places) {
  std::vector<bool> result(function.instructions.size(), false);
  for (const std::uint32_t at : places) result[at] = true;
  return result;
}

/// The instructions in `zeros` that are entries, or operands of instructions outside `zeros`.
Places outermost_zeros(const Function& function, const Places& zeros) {
  const std::vector<bool> is_zero = flags_at(function, zeros);
  std::vector<bool> used = flags_at(function, entries_of(function));
  for (std::size_t at = 0; at < used.size(); ++at) {
    const Instruction& i = function.instructions[at];
    if (is_zero[at]) continue;
    if (operand_count(i) > 0) used[i.a] = true;
    if (operand_count(i) > 1) used[i.b] = true;
  }
  Places result;
  std::copy_if(zeros.begin(), zeros.end(), std::back_inserter(result),
               [&used](std::uint32_t at) { return used[at]; });
  return result;
}

/// Instructions of a function that are 0, by kind of evidence.
struct Zeros {
  Places proved = {};   ///< the closed form is the empty sum
  Places sampled = {};  ///< analytic, and 0 at `zero_sample_count` points

  [[nodiscard]] Places all() const {
    Places places = proved;
    places.insert(places.end(), sampled.begin(), sampled.end());
    return places;
  }
};

Zeros classify_zeros(const Program& program, const Function& function, const Places& places) {
  Zeros zeros;
  Places open;
  const std::vector<ZeroProof> proofs = prove_zeros(program, with_entries(function, places));
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (proofs[i] == ZeroProof::zero) zeros.proved.push_back(places[i]);
    if (proofs[i] == ZeroProof::open) open.push_back(places[i]);
  }
  const std::vector<bool> vanish = vanishing_elsewhere(program, with_entries(function, open));
  for (std::size_t i = 0; i < open.size(); ++i) {
    if (vanish[i]) zeros.sampled.push_back(open[i]);
  }
  return zeros;
}

/// The outermost zeros. If an outermost candidate is not 0, one of its operands may still be 0, so
/// all candidates are then classified.
Zeros find_zeros(const Program& program, const Function& function) {
  const Places candidates = vanishing(program, function);
  const Places places = outermost_zeros(function, candidates);
  Zeros zeros = classify_zeros(program, function, places);
  if (zeros.proved.size() + zeros.sampled.size() == places.size()) return zeros;
  zeros = classify_zeros(program, function, candidates);
  const std::vector<bool> is_outermost = flags_at(function, outermost_zeros(function, zeros.all()));
  const auto is_inside = [&is_outermost](std::uint32_t at) { return !is_outermost[at]; };
  std::erase_if(zeros.proved, is_inside);
  std::erase_if(zeros.sampled, is_inside);
  return zeros;
}

/// The indices, over all fields, of the entries that depend on one of `places`.
Places dependent_entries(const Function& function, const Places& places) {
  std::vector<bool> rests = flags_at(function, places);
  for (std::size_t at = 0; at < rests.size(); ++at) {
    const Instruction& i = function.instructions[at];
    if (operand_count(i) > 0 && rests[i.a]) rests[at] = true;
    if (operand_count(i) > 1 && rests[i.b]) rests[at] = true;
  }
  Places result;
  const Places entries = entries_of(function);
  for (std::uint32_t i = 0; i < entries.size(); ++i) {
    if (rests[entries[i]]) result.push_back(i);
  }
  return result;
}

/// Longer functions are lowered without a search for shorter sums and products. The search would
/// take as long as the first lowering, and a few removed zeros hardly give new ones.
constexpr std::size_t most_lowered_again = 2'000;

Network network_of(const Expressions& expressions, const Function& function) {
  if (expressions.graph.size() <= most_lowered_again) {
    return cheapest_network(expressions, function);
  }
  Network network = make_network(expressions);
  turn_signs(network);
  return network;
}

/// Lowers the function again, with 0 in place of `zeros`.
Function lower_without(const Zeros& zeros, const Function& function, Program& program) {
  const Expressions expressions =
      from_program(program, function, entries_of(function), flags_at(function, zeros.all()));
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
    function = lower_without(zeros, function, program);
  }
  require_invariants(program);
  return program;
}

}  // namespace elgen
