// readable: see readable.hpp.
#include "choose/readable.hpp"

#include <algorithm>
#include <numeric>

#include "choose/closed_graph.hpp"
#include "lower/graph/flatten.hpp"
#include "lower/graph/from_program.hpp"
#include "lower/graph/prune.hpp"
#include "lower/network/cheapest.hpp"

namespace elgen {
namespace {

/// Written out over the leaves, an entry as derived may have this many operations. Longer ones are
/// never the shortest way: 1000 gives the same pages for models/; 20 makes some longer.
constexpr std::size_t longest_derived = 60;

class Lengths {
 public:
  explicit Lengths(const Expressions& expressions) : graph_(expressions.graph) {
    lengths_.resize(graph_.size());
    for (const NodeId id : reachable(graph_, expressions.values)) lengths_[id] = length(id);
  }

  [[nodiscard]] std::size_t of(NodeId id) const { return lengths_[id]; }

 private:
  /// Constants that stand together are one number.
  [[nodiscard]] std::size_t length(NodeId id) const {
    if (graph_.is_constant(id)) return 0;
    const Node& node = graph_.node(id);
    std::size_t total = 0;
    bool has_constant = false;
    for (const Operand& operand : node.operands) {
      const bool is_together = graph_.is_constant(operand.node) && has_constant;
      has_constant = has_constant || graph_.is_constant(operand.node);
      if (is_together) continue;
      total += lengths_[operand.node] + 1;
      if (node.kind == NodeKind::product && operand.weight != 1) ++total;
    }
    if (total > 0) --total;
    if (node.kind == NodeKind::call) total += call_length + multiples(node.operands[0].node);
    if (node.kind == NodeKind::square_root) total += call_length;
    return total;
  }

  /// Terms of an angle that are multiples of something.
  [[nodiscard]] std::size_t multiples(NodeId argument) const {
    if (graph_.is_constant(argument)) return 0;
    const Node& node = graph_.node(argument);
    if (node.kind == NodeKind::product) {
      return graph_.is_constant(node.operands[0].node) ? multiple_length : 0;
    }
    std::size_t total = 0;
    if (node.kind == NodeKind::sum) {
      for (const Operand& term : node.operands) total += multiples(term.node);
    }
    return total;
  }

  const Graph& graph_;
  std::vector<std::size_t> lengths_;
};

/// What a grouping may cost: lengths are compared in these percent. Terms with one rate in common
/// are read together, and share more: with 100 instead, half of the pages of models/ change, to
/// entries 0.6 % longer and code 0.6 % dearer in all; with 95 and with 70 the entries are longer
/// too.
constexpr std::size_t weight_of(Grouping grouping) {
  switch (grouping) {
    case Grouping::by_rates:
      return 86;
    case Grouping::by_rates_and_coordinates:
      return 88;
    case Grouping::none:
      break;
  }
  return 100;
}

/// One way to write the value, collected.
struct Collected {
  Expressions expressions = {};
  std::size_t terms = 0;  ///< which: grouping the same terms in another way does not change errors
  std::size_t length = 0;
  std::size_t weighted_length = 0;
};

Collected collected(const Expressions& expressions, std::size_t terms, Grouping grouping) {
  Collected result{factored(flatten(expressions)), terms};
  result.length = Lengths(result.expressions).of(result.expressions.values[0].node);
  result.weighted_length = result.length * weight_of(grouping);
  return result;
}

/// Sums that are much longer than another way to write the same are not collected: ten times longer
/// ones never come out shortest in models/, and without those up to twice as long five pages
/// change.
constexpr std::size_t terms_over_least = 2;

struct Written {
  Layout layout = {};
  Expressions expressions = {};
  std::size_t length = 0;
};

std::optional<Written> written(const Algebra& algebra, const Fraction& form, Layout layout) {
  Written result{layout};
  const auto value = closed_graph(result.expressions.graph, algebra, form, layout, most_terms);
  if (!value) return std::nullopt;
  result.expressions.values.push_back(*value);
  result.length = Lengths(result.expressions).of(value->node);
  return result;
}

/// Longer sums are collected in one way only, for the time it takes: the shortest trigonometry, by
/// rates. With 20 the entries of models/ are 1.6 % longer, and code is 0.6 % dearer; with 80 they
/// are 0.3 % shorter, code is the same, and generation takes 8 % longer.
constexpr std::size_t always_compared = 40;

/// The groupings that make a difference to a form, from what its terms hold.
std::vector<Grouping> groupings(const Algebra& algebra, const Fraction& form) {
  bool has_rates = false;
  bool has_coordinates = false;
  for (const auto& [monomial, coefficient] : form.numerator) {
    for (const AtomPower& power : monomial) {
      const Atom& atom = algebra.atoms[power.atom];
      has_rates = has_rates || is_rate(atom);
      has_coordinates = has_coordinates || !(is_rate(atom) || is_parameter(atom));
    }
  }
  const bool is_long = form.numerator.size() > always_compared;
  if (is_long) return {has_rates ? Grouping::by_rates : Grouping::by_rates_and_coordinates};
  std::vector<Grouping> result{Grouping::none};
  if (form.numerator.size() < 2) return result;
  if (has_rates) result.push_back(Grouping::by_rates);
  if (has_coordinates) result.push_back(Grouping::by_rates_and_coordinates);
  return result;
}

/// The ways to write the sines and cosines, without those that write the same or much more.
std::vector<Written> candidates(const Algebra& algebra, const Fraction& form) {
  std::vector<Written> all;
  std::size_t least = SIZE_MAX;
  std::vector<std::optional<Trigonometry>> ways{std::nullopt};
  ways.insert(ways.end(), trigonometries.begin(), trigonometries.end());
  for (const std::optional<Trigonometry>& trigonometry : ways) {
    auto candidate = written(algebra, form, {trigonometry, Grouping::none});
    if (!candidate) continue;
    const auto same = [&](const Written& known) { return known.length == candidate->length; };
    if (std::any_of(all.begin(), all.end(), same)) continue;
    least = std::min(least, candidate->length);
    all.push_back(std::move(*candidate));
  }
  const auto is_long = [&](const Written& way) { return way.length > terms_over_least * least; };
  std::erase_if(all, is_long);
  if (form.numerator.size() <= always_compared || all.empty()) return all;
  const auto shorter = [](const Written& x, const Written& y) { return x.length < y.length; };
  return {*std::min_element(all.begin(), all.end(), shorter)};
}

/// The closed form in all ways and groupings.
std::vector<Collected> collected_ways(const Algebra& algebra, const Fraction& form) {
  std::vector<Collected> ways;
  std::size_t terms = 0;
  for (const Written& way : candidates(algebra, form)) {
    ++terms;
    for (const Grouping grouping : groupings(algebra, form)) {
      const auto grouped = written(algebra, form, {way.layout.trigonometry, grouping});
      if (grouped) ways.push_back(collected(grouped->expressions, terms, grouping));
    }
  }
  return ways;
}

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
    ways.push_back(collected(*derived, 0, Grouping::none));
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

std::optional<Expressions> as_derived(const Program& program, const Function& function,
                                      std::uint32_t entry) {
  const std::vector<bool> needed = needed_for(function, {entry});
  if (static_cast<std::size_t>(std::count(needed.begin(), needed.end(), true)) > longest_derived) {
    return std::nullopt;
  }
  const Expressions expressions = from_program(program, function, {entry});
  Expressions written_out = flatten(expressions, Flattened::all_products);
  const Lengths lengths(written_out);
  if (lengths.of(written_out.values[0].node) > longest_derived) return std::nullopt;
  return written_out;
}

}  // namespace elgen
