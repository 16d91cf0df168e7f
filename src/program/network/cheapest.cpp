// networks_by_cost: makes a network of each form, without and with joined numbers; sorts by cost.
#include "program/network/cheapest.hpp"

#include <algorithm>
#include <utility>

#include "program/graph/factor.hpp"
#include "program/network/linearise.hpp"

namespace elgen {
namespace {

/// For larger graphs, the forms with all products expanded are skipped, because they take the most
/// time.
constexpr std::size_t max_nodes_to_expand = 20'000;

CostedNetwork make_candidate(Network network, const Function& unfilled) {
  CostedNetwork result{std::move(network)};
  eliminate_common_subexpressions(result.network);
  flip_signs(result.network);
  Program scratch;
  Function function = unfilled;
  linearise(result.network, scratch, function);
  result.cost = cost(count_operations(function));
  return result;
}

}  // namespace

Expressions factor_twice(const Expressions& flat) { return factor(flatten(factor(flat))); }

std::vector<CostedNetwork> networks_by_cost(const Expressions& expressions,
                                            const Function& unfilled, ExpandedAngles splits) {
  std::vector<CostedNetwork> networks;
  // If all constants are rational, the graph has merged them, and joining changes nothing.
  const auto add = [&](const Expressions& form) {
    Network network = make_network(form);
    const bool is_done = std::ranges::all_of(
        network.constants, [](const Constant& constant) { return is_rational(constant); });
    networks.push_back(make_candidate(std::move(network), unfilled));
    if (is_done) return;
    networks.push_back(make_candidate(make_network(form, NumberJoining::joined), unfilled));
  };
  const auto add_forms = [&](const Expressions& all) {
    const Expressions flat = flatten(all);
    add(factor_twice(flat));
    add(flat);
    if (flat.graph.size() > max_nodes_to_expand) return;
    add(factor_twice(flatten(flat, FlattenedProducts::all_products)));
  };
  add_forms(expressions);
  if (const auto expanded = expand_angle_sums(expressions, splits)) add_forms(*expanded);
  std::ranges::stable_sort(networks, {}, &CostedNetwork::cost);
  return networks;
}

Network cheapest_network(const Expressions& expressions, const Function& unfilled,
                         ExpandedAngles splits) {
  return std::move(networks_by_cost(expressions, unfilled, splits).front().network);
}

}  // namespace elgen
