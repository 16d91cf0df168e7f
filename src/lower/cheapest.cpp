// cheapest: see cheapest.hpp.
#include "lower/cheapest.hpp"

#include "lower/angle_sums.hpp"
#include "lower/factor.hpp"
#include "lower/flatten.hpp"
#include "lower/linearise.hpp"
#include "lower/share.hpp"
#include "lower/turn_signs.hpp"

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

class Cheapest {
 public:
  explicit Cheapest(const Function& unfilled) : unfilled_(unfilled) {}

  void consider(const Expressions& expressions) {
    CostedNetwork other = candidate(expressions, unfilled_);
    if (!best_ || other.cost < best_->cost) best_ = std::move(other);
  }

  void consider_forms(const Expressions& expressions) {
    const Expressions flat = flatten(expressions);
    consider(factored(flat));
    consider(flat);
    if (flat.graph.size() > maximal_nodes_written_out) return;
    consider(factored(flatten(flat, Flattened::all_products)));
  }

  Network take() { return std::move(best_->network); }

 private:
  const Function& unfilled_;
  std::optional<CostedNetwork> best_ = {};
};

}  // namespace

Expressions factored(const Expressions& flat) { return factor(flatten(factor(flat))); }

Network cheapest_network(const Expressions& expressions, const Function& unfilled) {
  Cheapest cheapest(unfilled);
  cheapest.consider_forms(expressions);
  if (const auto expanded = expand_angle_sums(expressions)) cheapest.consider_forms(*expanded);
  return cheapest.take();
}

}  // namespace elgen
