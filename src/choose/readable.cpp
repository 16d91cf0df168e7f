// readable: see readable.hpp.
#include "readable.hpp"

#include <algorithm>

#include "closed_graph.hpp"
#include "lower/cheapest.hpp"
#include "lower/flatten.hpp"
#include "lower/from_program.hpp"
#include "lower/prune.hpp"

namespace elgen {
namespace {

/// Written out over the leaves, an entry as derived may have this many operations.
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

/// One way to write the value, collected.
struct Collected {
  Expressions expressions = {};
  std::size_t length = 0;
};

Collected collected(const Expressions& expressions) {
  Collected result{factored(flatten(expressions))};
  result.length = Lengths(result.expressions).of(result.expressions.values[0].node);
  return result;
}

/// What a grouping may cost: lengths are compared in these percent.
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

class Shortest {
 public:
  void consider(const Expressions& expressions, Grouping grouping) {
    const Collected candidate = collected(expressions);
    if (!compact_ || candidate.length < compact_->length) compact_ = candidate;
    const std::size_t weighted = candidate.length * weight_of(grouping);
    if (readable_ && weighted >= weighted_length_) return;
    readable_ = candidate;
    weighted_length_ = weighted;
  }

  std::optional<ReadableForm> take() {
    if (!readable_) return std::nullopt;
    return ReadableForm{std::move(readable_->expressions), std::move(compact_->expressions),
                        readable_->length};
  }

 private:
  std::optional<Collected> readable_ = {};
  std::optional<Collected> compact_ = {};
  std::size_t weighted_length_ = 0;
};

/// Sums that are much longer than another way to write the same are not collected.
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

/// Longer sums are collected in one way only: the shortest trigonometry, by rates.
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
  all.erase(std::remove_if(all.begin(), all.end(), is_long), all.end());
  if (form.numerator.size() <= always_compared || all.empty()) return all;
  const auto shorter = [](const Written& x, const Written& y) { return x.length < y.length; };
  return {*std::min_element(all.begin(), all.end(), shorter)};
}

}  // namespace

std::optional<ReadableForm> shortest(const Algebra& algebra, const Fraction& form,
                                     const Expressions* derived) {
  Shortest result;
  for (const Written& way : candidates(algebra, form)) {
    for (const Grouping grouping : groupings(algebra, form)) {
      const auto grouped = written(algebra, form, {way.layout.trigonometry, grouping});
      if (grouped) result.consider(grouped->expressions, grouping);
    }
  }
  if (derived != nullptr) result.consider(*derived, Grouping::none);
  return result.take();
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
