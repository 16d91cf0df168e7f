// rewritings: see rewritings.hpp.
#include "forms/write/rewritings.hpp"

#include <algorithm>
#include <utility>

#include "forms/write/closed_graph.hpp"
#include "program/graph/factor.hpp"
#include "program/network/cheapest.hpp"

namespace elgen {
namespace {

/// Functions of functions are short as they are shared, and double with every level as they are
/// written. Without a limit the pages of models/ are the same.
constexpr std::size_t longest_written = 5'000;

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
    return std::min(total, 2 * longest_written);
  }

  /// Counts the terms of an angle that are multiples of a leaf.
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

/// The weight of a grouping: lengths are compared in these percent. Terms with one rate in common
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

Collected collected(const Expressions& expressions, std::size_t terms, Grouping grouping) {
  Collected result{factored(flatten(expressions)), terms};
  result.length = written_length(result.expressions);
  result.weighted_length = result.length * weight_of(grouping);
  return result;
}

/// Sums that are much longer than another rewriting are not collected: ten times longer ones never
/// come out shortest in models/, and without those up to twice as long five pages change.
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
  result.length = written_length(result.expressions);
  if (result.length > longest_written) return std::nullopt;
  return result;
}

/// Longer sums are collected in one grouping only, to save time: the shortest trigonometry, by
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

/// Rewritings of the sines and cosines, without duplicates and much longer ones.
std::vector<Written> candidates(const Algebra& algebra, const Fraction& form) {
  std::vector<Written> all;
  std::size_t least = SIZE_MAX;
  std::vector<std::optional<Trigonometry>> rewritings{std::nullopt};
  rewritings.insert(rewritings.end(), trigonometries.begin(), trigonometries.end());
  for (const std::optional<Trigonometry>& trigonometry : rewritings) {
    auto candidate = written(algebra, form, {trigonometry, Grouping::none});
    if (!candidate) continue;
    if (std::ranges::find(all, candidate->length, &Written::length) != all.end()) continue;
    least = std::min(least, candidate->length);
    all.push_back(std::move(*candidate));
  }
  const auto is_long = [&](const Written& rewriting) {
    return rewriting.length > terms_over_least * least;
  };
  std::erase_if(all, is_long);
  if (form.numerator.size() <= always_compared || all.empty()) return all;
  return {*std::ranges::min_element(all, {}, &Written::length)};
}

}  // namespace

std::size_t written_length(const Expressions& expressions) {
  return Lengths(expressions).of(expressions.values[0].node);
}

Rewritings rewritings_of(const Algebra& algebra, const Fraction& form) {
  Rewritings rewritings;
  std::size_t terms = 0;
  for (Written& candidate : candidates(algebra, form)) {
    ++terms;
    for (const Grouping grouping : groupings(algebra, form)) {
      const auto grouped = grouping == Grouping::none
                               ? std::optional(candidate)
                               : written(algebra, form, {candidate.layout.trigonometry, grouping});
      if (!grouped) continue;
      rewritings.collected.push_back(collected(grouped->expressions, terms, grouping));
    }
    rewritings.plain.push_back(std::move(candidate.expressions));
  }
  return rewritings;
}

Collected derived_rewriting(const Expressions& derived) {
  return collected(derived, 0, Grouping::none);
}

std::vector<Collected> precise_rewritings(const Algebra& algebra, const Fraction& form) {
  std::vector<Collected> rewritings;
  for (const Grouping grouping : groupings(algebra, form)) {
    const auto grouped = written(algebra, form, {Trigonometry::homogeneous, grouping});
    if (grouped) rewritings.push_back(collected(grouped->expressions, SIZE_MAX, grouping));
  }
  return rewritings;
}

}  // namespace elgen
