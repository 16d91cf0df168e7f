// angle_sums: see angle_sums.hpp. Angles are compared as linear combinations of nodes with rational
// coefficients.
#include "program/graph/angle_sums.hpp"

#include <cln/integer.h>
#include <cln/rational.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

namespace elgen {
namespace {

using cln::cl_RA;

using LinearCombination = std::map<NodeId, cl_RA>;

void add_multiple(LinearCombination& to, NodeId node, const cl_RA& coefficient) {
  const auto [at, is_new] = to.try_emplace(node, coefficient);
  if (is_new) return;
  at->second = at->second + coefficient;
  if (cln::zerop(at->second)) to.erase(at);
}

/// Adds coefficient * `id` to `to`; expands sums and rational multiples.
void add_linear_terms(const Graph& graph, NodeId id, const cl_RA& coefficient,
                      LinearCombination& to) {
  const Node& node = graph.node(id);
  if (node.kind == NodeKind::sum) {
    for (const Operand& term : node.operands) {
      add_linear_terms(graph, term.node, coefficient * term.weight, to);
    }
    return;
  }
  const bool is_multiple = node.kind == NodeKind::product && node.operands.size() == 2 &&
                           node.operands[0].weight == 1 && node.operands[1].weight == 1 &&
                           graph.is_rational(node.operands[0].node);
  if (is_multiple) {
    const cl_RA& factor = graph.rational_of(node.operands[0].node);
    add_linear_terms(graph, node.operands[1].node, coefficient * factor, to);
    return;
  }
  add_multiple(to, id, coefficient);
}

LinearCombination add_signed(LinearCombination x, const LinearCombination& y, int sign) {
  for (const auto& [node, coefficient] : y) add_multiple(x, node, coefficient * sign);
  return x;
}

/// An argument of a sine or cosine, and its terms: a linear combination of nodes that are no sums.
struct AngleTerms {
  NodeId argument = 0;
  LinearCombination terms = {};
  cl_RA size = 0;  ///< sum of |coefficients|; a simpler angle has a smaller sum
};

/// argument = first + sign * second
struct AngleSplit {
  NodeId first = 0;
  NodeId second = 0;
  int sign = 1;
};

AngleTerms angle_terms(const Graph& graph, NodeId argument) {
  AngleTerms angle{argument};
  add_linear_terms(graph, argument, 1, angle.terms);
  for (const auto& [node, coefficient] : angle.terms) {
    angle.size = angle.size + cln::abs(coefficient);
  }
  return angle;
}

std::vector<AngleTerms> collect_angles(const Expressions& expressions) {
  const Graph& graph = expressions.graph;
  std::vector<AngleTerms> angles;
  for (const NodeId id : reachable_nodes(graph, expressions.values)) {
    if (!is_sine_or_cosine(graph.node(id))) continue;
    const NodeId argument = graph.node(id).operands[0].node;
    if (std::ranges::find(angles, argument, &AngleTerms::argument) != angles.end()) continue;
    angles.push_back(angle_terms(graph, argument));
  }
  return angles;
}

/// More angles are not searched, because the search takes cubic time.
constexpr std::size_t most_angles = 40;

/// `angle` as first + second or first - second; none if `angle` is neither, or terms would cancel:
/// (q1 + q2) - (q2 - q3) for q1 + q3 would contain the rounding error of q2.
std::optional<AngleSplit> try_split(const AngleTerms& angle, const AngleTerms& first,
                                    const AngleTerms& second, ExpandedAngles which) {
  if (first.size + second.size != angle.size) return std::nullopt;
  for (const int sign : {1, -1}) {
    if (sign < 0 && which == ExpandedAngles::sums) continue;
    if (add_signed(first.terms, second.terms, sign) == angle.terms) {
      return AngleSplit{first.argument, second.argument, sign};
    }
  }
  return std::nullopt;
}

/// A split of `angle` into two of the angles in `simpler`; none if no split exists.
std::optional<AngleSplit> find_split(const AngleTerms& angle,
                                     const std::vector<AngleTerms>& simpler, ExpandedAngles which) {
  for (const AngleTerms& first : simpler) {
    for (const AngleTerms& second : simpler) {
      if (const auto split = try_split(angle, first, second, which)) return split;
    }
  }
  return std::nullopt;
}

std::map<NodeId, AngleSplit> find_splits(const Expressions& expressions, ExpandedAngles which) {
  std::map<NodeId, AngleSplit> splits;
  const std::vector<AngleTerms> angles = collect_angles(expressions);
  if (angles.size() > most_angles) return splits;
  for (const AngleTerms& angle : angles) {
    // Multiples of an angle are not split: cos(x)^2 - sin(x)^2 loses digits near its zeros.
    const Graph& graph = expressions.graph;
    if (is_exact_multiple(graph, angle.argument) || graph.is_constant(angle.argument)) continue;
    std::vector<AngleTerms> simpler;
    std::copy_if(angles.begin(), angles.end(), std::back_inserter(simpler),
                 [&](const AngleTerms& other) { return other.size < angle.size; });
    // Constant terms may be split off, because their sines and cosines are constants.
    for (const Operand& term : graph.node(angle.argument).operands) {
      if (graph.is_constant(term.node)) simpler.push_back(angle_terms(graph, term.node));
    }
    if (const auto split = find_split(angle, simpler, which)) splits[angle.argument] = *split;
  }
  return splits;
}

/// The rule of one rebuild. Results are memoised, because chains of splits refer to one angle many
/// times.
class AngleSumRule {
 public:
  AngleSumRule(std::map<NodeId, AngleSplit> splits, std::size_t nodes)
      : splits_(std::move(splits)), arguments_(nodes), is_built_(nodes) {}

  SignedNode operator()(Graph& graph, const RebuildStep& step) {
    const Node& node = step.old_graph.node(step.old_node);
    if (!is_sine_or_cosine(node) || splits_.count(node.operands[0].node) == 0)
      return copy_node(graph, step);
    const SignedNode value = sine_or_cosine(graph, step, node.function, node.operands[0].node);
    const bool negative = node.function == FunctionId::sin && node.operands[0].weight < 0;
    return negate_if(value, negative);
  }

 private:
  /// The argument `id` in the new graph. Built on demand: `id` may come after `step.old_node`.
  SignedNode rebuild_argument(Graph& graph, const RebuildStep& step, NodeId id) {
    if (is_built_[id]) return arguments_[id];
    for (const Operand& operand : step.old_graph.node(id).operands) {
      (void)rebuild_argument(graph, step, operand.node);
    }
    is_built_[id] = true;
    return arguments_[id] = copy_node(graph, {step.old_graph, id, arguments_});
  }

  SignedNode sine_or_cosine(Graph& graph, const RebuildStep& step, FunctionId function, NodeId id) {
    const auto known = known_values_.find({function, id});
    if (known != known_values_.end()) return known->second;
    return known_values_[{function, id}] = expand_sine_or_cosine(graph, step, function, id);
  }

  SignedNode expand_sine_or_cosine(Graph& graph, const RebuildStep& step, FunctionId function,
                                   NodeId id) {
    const auto split = splits_.find(id);
    if (split == splits_.end()) return graph.call(function, {rebuild_argument(graph, step, id)});
    const auto& [first, second, sign] = split->second;
    const SignedNode sine1 = sine_or_cosine(graph, step, FunctionId::sin, first);
    const SignedNode cosine1 = sine_or_cosine(graph, step, FunctionId::cos, first);
    const SignedNode sine2 =
        negate_if(sine_or_cosine(graph, step, FunctionId::sin, second), sign < 0);
    const SignedNode cosine2 = sine_or_cosine(graph, step, FunctionId::cos, second);
    if (function == FunctionId::sin) {
      const SignedNode left = graph.product({{sine1}, {cosine2}});
      return graph.sum({left, graph.product({{cosine1}, {sine2}})});
    }
    const SignedNode left = graph.product({{cosine1}, {cosine2}});
    return graph.sum({left, -graph.product({{sine1}, {sine2}})});
  }

  std::map<NodeId, AngleSplit> splits_;
  std::vector<SignedNode> arguments_;  ///< in the new graph, by old node
  std::vector<bool> is_built_;
  std::map<std::pair<FunctionId, NodeId>, SignedNode>
      known_values_;  ///< by function and old argument
};

}  // namespace

bool is_exact_multiple(const Graph& graph, NodeId id) {
  const Node& node = graph.node(id);
  if (node.kind != NodeKind::product) return node.kind == NodeKind::leaf;
  if (node.operands.size() != 2 || !graph.is_rational(node.operands[0].node)) return false;
  const cl_RA& factor = graph.rational_of(node.operands[0].node);
  const cln::cl_I powers = cln::numerator(factor) * cln::denominator(factor);
  return node.operands[1].weight == 1 && cln::power2p(powers) > 0 &&
         is_exact_multiple(graph, node.operands[1].node);
}

std::optional<Expressions> expand_angle_sums(const Expressions& expressions, ExpandedAngles which) {
  std::map<NodeId, AngleSplit> splits = find_splits(expressions, which);
  if (splits.empty()) return std::nullopt;
  return rebuild(expressions, AngleSumRule(std::move(splits), expressions.graph.size()));
}

}  // namespace elgen
