// readable: see readable.hpp.
#include "choose/readable.hpp"

#include <algorithm>
#include <numeric>

#include "choose/ways.hpp"
#include "lower/graph/flatten.hpp"
#include "lower/graph/from_program.hpp"
#include "lower/graph/prune.hpp"

namespace elgen {
namespace {

/// Written out over the leaves, an entry as derived may have this many operations. Longer ones are
/// never the shortest way: 1000 gives the same pages for models/; 20 makes some longer.
constexpr std::size_t longest_derived = 60;

std::size_t shortest_weighted(const std::vector<Collected>& ways) {
  const auto shorter = [](const Collected& x, const Collected& y) {
    return x.weighted_length < y.weighted_length;
  };
  return static_cast<std::size_t>(
      std::distance(ways.begin(), std::min_element(ways.begin(), ways.end(), shorter)));
}

/// The shortest of those that are as precise as `judge`, by whose B the code is judged.
std::size_t shortest_precise(const std::vector<Collected>& ways, std::size_t judge,
                             const MixedPoints& points) {
  std::vector<std::size_t> order(ways.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t x, std::size_t y) { return ways[x].length < ways[y].length; });
  return *std::find_if(order.begin(), order.end(), [&](std::size_t way) {
    return ways[way].terms == ways[judge].terms ||
           is_as_precise(ways[way].expressions, ways[judge].expressions, points, Leaves::exact);
  });
}

}  // namespace

std::optional<ReadableForm> shortest(const Algebra& algebra, const Fraction& form,
                                     const Expressions* derived, const MixedPoints& points) {
  std::vector<Collected> ways = collected_ways(algebra, form);
  if (ways.empty() && derived == nullptr) return std::nullopt;
  std::size_t readable = ways.empty() ? 0 : shortest_weighted(ways);
  if (derived != nullptr) {
    ways.push_back(derived_way(*derived));
    const std::size_t last = ways.size() - 1;
    const bool is_shorter = ways[last].weighted_length < ways[readable].weighted_length;
    if (is_shorter && is_as_precise(ways[last].expressions, ways[readable].expressions, points,
                                    Leaves::rounded)) {
      readable = last;
    }
  }
  const std::size_t compact = shortest_precise(ways, readable, points);
  return ReadableForm{ways[readable].expressions, ways[compact].expressions, ways[readable].length};
}

std::optional<DerivedEntry> as_derived(const Program& program, const Function& function,
                                       std::uint32_t entry) {
  const std::vector<bool> needed = needed_for(function, {entry});
  if (static_cast<std::size_t>(std::count(needed.begin(), needed.end(), true)) > longest_derived) {
    return std::nullopt;
  }
  DerivedEntry derived{from_program(program, function, {entry}), {}};
  derived.written_out = flatten(derived.as_it_stands, Flattened::all_products);
  if (written_length(derived.written_out) > longest_derived) return std::nullopt;
  return derived;
}

}  // namespace elgen
