// cheapest: see cheapest.hpp.
#include "lower/network/cheapest.hpp"

#include "lower/graph/factor.hpp"
#include "lower/graph/flatten.hpp"
#include "lower/network/linearise.hpp"
#include "lower/network/share.hpp"
#include "lower/network/turn_signs.hpp"

namespace elgen {
namespace {

/// Larger graphs are not tried with all products written out, which takes them longest.
constexpr std::size_t maximal_nodes_written_out = 20'000;

struct CostedNetwork {
  Network network = {};
  std::size_t cost = 0;
};

CostedNetwork candidate(const Expressions& expressions, const Function& unfilled) {
  CostedNetwork result{make_network(expressions)};
  share(result.network);
  turn_signs(result.network);
  Program scratch;
  Function function = unfilled;
  linearise(result.network, scratch, function);
  result.cost = cost(count_operations(function));
  return result;
}

}  // namespace

Expressions factored(const Expressions& flat) { return factor(flatten(factor(flat))); }

Network cheapest_network(const Expressions& expressions, const Function& unfilled, Splits splits) {
  std::optional<CostedNetwork> best;
  const auto consider = [&](const Expressions& form) {
    CostedNetwork other = candidate(form, unfilled);
    if (!best || other.cost < best->cost) best = std::move(other);
  };
  const auto consider_forms = [&](const Expressions& all) {
    const Expressions flat = flatten(all);
    consider(factored(flat));
    consider(flat);
    if (flat.graph.size() > maximal_nodes_written_out) return;
    consider(factored(flatten(flat, Flattened::all_products)));
  };
  consider_forms(expressions);
  if (const auto expanded = expand_angle_sums(expressions, splits)) consider_forms(*expanded);
  return std::move(best->network);
}

}  // namespace elgen
