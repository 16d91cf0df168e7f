// readable: the shortest rewriting. Two rewritings are compared as one function of two entries, so
// that common parts, sines above all, are evaluated once.
#include <algorithm>
#include <set>
#include <utility>

#include "forms/write/rewritings.hpp"
#include "program/graph/angle_sums.hpp"
#include "program/graph/factor.hpp"
#include "program/network/linearise.hpp"

namespace elgen {
namespace {

using NodeSet = std::set<NodeId>;

/// Leaves of all angles rounded before their sines or cosines are taken: x - y and 2 x - 2 y count
/// alike.
std::set<NodeSet> rounded_angles(const Graph& graph, Ref value) {
  std::set<NodeSet> angles;
  for (const NodeId id : reachable(graph, {value})) {
    const Node& node = graph.node(id);
    if (!is_sine_or_cosine(node) || is_exact_multiple(graph, node.operands[0].node)) continue;
    NodeSet leaves;
    for (const NodeId part : reachable(graph, {{node.operands[0].node, false}})) {
      if (graph.node(part).kind == NodeKind::leaf) leaves.insert(part);
    }
    if (!leaves.empty()) angles.insert(std::move(leaves));
  }
  return angles;
}

/// Whether `rewriting` takes sines of sums that the reference has taken apart: q1 - q2 is rounded,
/// q1 and q2 are not. Few points show it, where all else is small and the angles are large.
bool rounds_more_angles(const Expressions& rewriting, const Expressions& reference) {
  Graph both;
  const Ref own = copied(both, rewriting);
  const Ref known = copied(both, reference);
  const auto known_angles = rounded_angles(both, known);
  const auto is_known = [&known_angles](const NodeSet& angle) {
    return std::ranges::any_of(known_angles, [&angle](const NodeSet& other) {
      return std::ranges::includes(other, angle);
    });
  };
  return !std::ranges::all_of(rounded_angles(both, own), is_known);
}

/// The error that may take the place of x's.
Real admitted_error(const Running<Real>& x) {
  static const Real recounted(3);
  static const Real always(8);
  return max(x.error * recounted, abs(x.value) * always);
}

/// Written out over the leaves, an entry as derived may have this many operations. Longer ones are
/// never the shortest rewriting: 1000 gives the same pages for models/; 20 makes some longer.
constexpr std::size_t longest_derived = 60;

/// The shortest of those that are as precise as `judge`, by whose B the code is judged.
const Collected& shortest_precise(std::vector<const Collected*> rewritings, const Collected& judge,
                                  const Points& points) {
  std::ranges::stable_sort(rewritings, {}, [](const Collected* x) { return x->length; });
  return **std::ranges::find_if(rewritings, [&](const Collected* x) {
    return x->terms == judge.terms ||
           is_as_precise(x->expressions, judge.expressions, points, Leaves::exact);
  });
}

}  // namespace

bool is_as_precise(const Expressions& rewriting, const Expressions& reference, const Points& points,
                   Leaves leaves) {
  if (leaves == Leaves::exact && rounds_more_angles(rewriting, reference)) return false;
  Expressions expressions;
  expressions.values = {copied(expressions.graph, rewriting), copied(expressions.graph, reference)};
  const Linearised both(make_network(expressions));
  bool is_compared = false;
  for (const Arguments<double>& point : points) {
    const RunningErrorRules<Real> rules{running_leaves<Real>(point, leaves)};
    const auto entries =
        entries_of(both.function, fold<Running<Real>>(rules, both.program, both.function));
    const Real& own = entries[0].error;
    const Real admitted = admitted_error(entries[1]);
    if (!admitted.is_defined()) continue;
    if (!own.is_defined() || own.value() > admitted.value()) return false;
    is_compared = true;
  }
  return is_compared;
}

std::optional<ReadableForm> shortest(const std::vector<Collected>& rewritings,
                                     const Collected* derived, const Points& points) {
  if (rewritings.empty() && derived == nullptr) return std::nullopt;
  const Collected* readable = derived;
  if (!rewritings.empty()) {
    readable = &*std::ranges::min_element(rewritings, {}, &Collected::weighted_length);
  }
  std::vector<const Collected*> all;
  for (const Collected& rewriting : rewritings) all.push_back(&rewriting);
  if (derived != nullptr) {
    all.push_back(derived);
    const bool is_shorter = derived->weighted_length < readable->weighted_length;
    if (is_shorter &&
        is_as_precise(derived->expressions, readable->expressions, points, Leaves::rounded)) {
      readable = derived;
    }
  }
  const Collected& compact = shortest_precise(std::move(all), *readable, points);
  return ReadableForm{readable->expressions, compact.expressions, readable->length,
                      &compact == readable};
}

std::optional<DerivedEntry> as_derived(const Program& program, const Function& function,
                                       std::uint32_t entry) {
  if (cone_of(function, {entry}, longest_derived).size() > longest_derived) return std::nullopt;
  Expressions derived = from_program(program, function, {entry});
  const Expressions written_out = flatten(derived, Flattened::all_products);
  if (written_length(written_out) > longest_derived) return std::nullopt;
  return DerivedEntry{std::move(derived), derived_rewriting(written_out)};
}

}  // namespace elgen
