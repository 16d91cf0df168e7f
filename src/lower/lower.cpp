// lower: EquationsOfMotion -> Program, one output at a time: import, flatten, factor, share, turn
// signs, linearise.
//
// Pulling common factors out of sums saves products but can undo what two sums would share, and
// writing products out lets factors meet but takes shared ones apart. So each function is lowered
// in several of these forms, and the cheapest is kept (the first on a tie).
#include "elgen/lower.hpp"

#include <fmt/core.h>

#include <cassert>

#include "factor.hpp"
#include "flatten.hpp"
#include "from_ginac.hpp"
#include "linearise.hpp"
#include "share.hpp"
#include "turn_signs.hpp"

namespace elgen {
namespace {

/// Larger graphs are not tried with all products written out, which takes them longest.
constexpr std::size_t maximal_nodes_written_out = 20'000;

struct Candidate {
  Network network = {};
  std::size_t cost = 0;
};

Candidate candidate(const Expressions& expressions, const Function& unfilled) {
  Candidate result{make_network(expressions)};
  share(result.network);
  turn_signs(result.network);
  Program scratch;
  Function function = unfilled;
  linearise(result.network, scratch, function);
  result.cost = cost(count_operations(function));
  return result;
}

/// Factoring takes sums apart, so that their terms can meet in one sum, which may factor again.
Expressions factored(const Expressions& flat) { return factor(flatten(factor(flat))); }

Network cheapest_network(const Expressions& expressions, const Function& unfilled) {
  const Expressions flat = flatten(expressions);
  Candidate best = candidate(factored(flat), unfilled);
  const auto consider = [&](Candidate other) {
    if (other.cost < best.cost) best = std::move(other);
  };
  consider(candidate(flat, unfilled));
  if (flat.graph.size() <= maximal_nodes_written_out) {
    const Expressions written_out = flatten(flat, Flattened::all_products);
    consider(candidate(factored(written_out), unfilled));
  }
  return std::move(best.network);
}

Diagnostics lower_output(const EquationsOfMotion& equations, const OutputRequest& request,
                         const Limits& limits, Program& program) {
  Result<ImportedOutput> imported = from_ginac(equations, request, limits.derived_nodes);
  if (!imported) return imported.diagnostics;
  Function function;
  function.kind = request.kind;
  function.user = request.user;
  function.name = request.name;
  function.fields = std::move(imported->fields);
  const Expressions expressions{std::move(imported->graph), std::move(imported->values)};
  linearise(cheapest_network(expressions, function), program, function);
  program.functions.push_back(std::move(function));
  return {};
}

}  // namespace

Result<Program> lower(const EquationsOfMotion& equations, const std::vector<OutputRequest>& outputs,
                      const Limits& limits) {
  Program program;
  program.leaves = leaves_of(equations);
  for (const OutputRequest& request : outputs) {
    Diagnostics errors = lower_output(equations, request, limits, program);
    if (!errors.empty()) return errors;
  }
  assert(check_invariants(program).empty());
  return program;
}

}  // namespace elgen
