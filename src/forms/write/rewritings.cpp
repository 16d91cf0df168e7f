// rewritings: see rewritings.hpp. Two rewritings are compared as one function with two entries, so
// that common subexpressions, most often sines, are evaluated once.
#include "forms/write/rewritings.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "forms/write/closed_graph.hpp"
#include "program/graph/angle_sums.hpp"
#include "program/graph/factor.hpp"
#include "program/network/cheapest.hpp"
#include "program/network/linearise.hpp"

namespace elgen {
namespace {

/// Longer rewritings are dropped. A graph of nested functions is short, but its written length
/// doubles with each level. This limit changes no page of models/.
constexpr std::size_t longest_written = 5'000;

class WrittenLengths {
 public:
  explicit WrittenLengths(const Expressions& expressions) : graph_(expressions.graph) {
    lengths_.resize(graph_.size());
    for (const NodeId id : reachable_nodes(graph_, expressions.values))
      lengths_[id] = compute_length(id);
  }

  [[nodiscard]] std::size_t length_of(NodeId id) const { return lengths_[id]; }

 private:
  /// The written length of a node, whose constant operands together count as one number.
  [[nodiscard]] std::size_t compute_length(NodeId id) const {
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
    if (node.kind == NodeKind::call) total += call_length + multiples_length(node.operands[0].node);
    if (node.kind == NodeKind::square_root) total += call_length;
    return std::min(total, 2 * longest_written);
  }

  /// The length added for each term with a constant factor in the argument of a call: for 2 x.
  [[nodiscard]] std::size_t multiples_length(NodeId argument) const {
    if (graph_.is_constant(argument)) return 0;
    const Node& node = graph_.node(argument);
    if (node.kind == NodeKind::product) {
      return graph_.is_constant(node.operands[0].node) ? multiple_length : 0;
    }
    std::size_t total = 0;
    if (node.kind == NodeKind::sum) {
      for (const Operand& term : node.operands) total += multiples_length(term.node);
    }
    return total;
  }

  const Graph& graph_;
  std::vector<std::size_t> lengths_;
};

/// The weight of a grouping, in percent of the length. Terms with a common rate are read together,
/// and share more subexpressions. With 100 instead, half of the pages of models/ change: entries
/// are 0.6 % longer and code is 0.6 % dearer. With 95 and with 70 the entries are longer too.
constexpr std::size_t grouping_weight(Grouping grouping) {
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

CollectedForm collect_factors(const Expressions& expressions, std::size_t terms,
                              Grouping grouping) {
  CollectedForm result{factor_twice(flatten(expressions)), terms};
  result.length = written_length(result.expressions);
  result.weighted_length = result.length * grouping_weight(grouping);
  return result;
}

/// Sums longer than this many times the shortest sum are not collected. With 10 in place of 2, the
/// shortest forms of models/ do not change; with 1, five pages change.
constexpr std::size_t most_length_ratio = 2;

struct WrittenForm {
  Layout layout = {};
  Expressions expressions = {};
  std::size_t length = 0;
};

std::optional<WrittenForm> write_form(const Algebra& algebra, const Fraction& form, Layout layout) {
  WrittenForm result{layout};
  const auto value =
      build_closed_graph(result.expressions.graph, algebra, form, layout, most_terms);
  if (!value) return std::nullopt;
  result.expressions.values.push_back(*value);
  result.length = written_length(result.expressions);
  if (result.length > longest_written) return std::nullopt;
  return result;
}

/// Longer sums get one grouping, by rates or else by coordinates, and the shortest trigonometric
/// form. A limit of 20 makes the entries of models/ 1.6 % longer and the code 0.6 % dearer. A limit
/// of 80 makes the entries 0.3 % shorter and generation 8 % longer; the code does not change.
constexpr std::size_t most_terms_compared = 40;

/// The groupings that can change the form: a grouping by rates needs rates in its terms.
std::vector<Grouping> applicable_groupings(const Algebra& algebra, const Fraction& form) {
  bool has_rates = false;
  bool has_coordinates = false;
  for (const auto& [monomial, coefficient] : form.numerator) {
    for (const AtomPower& power : monomial) {
      const Atom& atom = algebra.atoms[power.atom];
      has_rates = has_rates || is_rate(atom);
      has_coordinates = has_coordinates || !(is_rate(atom) || is_parameter(atom));
    }
  }
  const bool is_long = form.numerator.size() > most_terms_compared;
  if (is_long) return {has_rates ? Grouping::by_rates : Grouping::by_rates_and_coordinates};
  std::vector<Grouping> result{Grouping::none};
  if (form.numerator.size() < 2) return result;
  if (has_rates) result.push_back(Grouping::by_rates);
  if (has_coordinates) result.push_back(Grouping::by_rates_and_coordinates);
  return result;
}

/// One rewriting per trigonometric form. Duplicates and much longer rewritings are omitted.
std::vector<WrittenForm> write_candidates(const Algebra& algebra, const Fraction& form) {
  std::vector<WrittenForm> all;
  std::size_t least = SIZE_MAX;
  std::vector<std::optional<Trigonometry>> rewritings{std::nullopt};
  rewritings.insert(rewritings.end(), trigonometries.begin(), trigonometries.end());
  for (const std::optional<Trigonometry>& trigonometry : rewritings) {
    auto candidate = write_form(algebra, form, {trigonometry, Grouping::none});
    if (!candidate) continue;
    if (std::ranges::find(all, candidate->length, &WrittenForm::length) != all.end()) continue;
    least = std::min(least, candidate->length);
    all.push_back(std::move(*candidate));
  }
  const auto is_long = [&](const WrittenForm& rewriting) {
    return rewriting.length > most_length_ratio * least;
  };
  std::erase_if(all, is_long);
  if (form.numerator.size() <= most_terms_compared || all.empty()) return all;
  return {*std::ranges::min_element(all, {}, &WrittenForm::length)};
}

using NodeSet = std::set<NodeId>;

/// For every angle that is rounded before its sine or cosine is computed: the set of its leaves,
/// which is the same for x - y and 2 x - 2 y.
std::set<NodeSet> rounded_angles(const Graph& graph, SignedNode value) {
  std::set<NodeSet> angles;
  for (const NodeId id : reachable_nodes(graph, {value})) {
    const Node& node = graph.node(id);
    if (!is_sine_or_cosine(node) || is_exact_multiple(graph, node.operands[0].node)) continue;
    NodeSet leaves;
    for (const NodeId part : reachable_nodes(graph, {{node.operands[0].node, false}})) {
      if (graph.node(part).kind == NodeKind::leaf) leaves.insert(part);
    }
    if (!leaves.empty()) angles.insert(std::move(leaves));
  }
  return angles;
}

/// True if `rewriting` has sines of sums that `reference` expands: q1 - q2 is rounded, but q1 and
/// q2 are not. Few sample points show this rounding, because the angles must be large and the other
/// terms small.
bool rounds_more_angles(const Expressions& rewriting, const Expressions& reference) {
  Graph both;
  const SignedNode own = copy_value(both, rewriting);
  const SignedNode known = copy_value(both, reference);
  const auto known_angles = rounded_angles(both, known);
  const auto is_known = [&known_angles](const NodeSet& angle) {
    return std::ranges::any_of(known_angles, [&angle](const NodeSet& other) {
      return std::ranges::includes(other, angle);
    });
  };
  return !std::ranges::all_of(rounded_angles(both, own), is_known);
}

/// The largest error that is_as_precise() admits: max(3 E, 8 |x|), with E the error of x.
Real admitted_error(const RunningValue<Real>& x) {
  static const Real recounted(3);
  static const Real always(8);
  return max(x.error * recounted, abs(x.value) * always);
}

/// The most operations of a derived entry, written over the leaves. Longer entries are never the
/// shortest rewriting: a limit of 1000 changes no page of models/; with 20, some pages are longer.
constexpr std::size_t longest_derived = 60;

/// The shortest rewriting that is as precise as `reference`, the readable form.
const CollectedForm& shortest_precise_form(std::vector<const CollectedForm*> rewritings,
                                           const CollectedForm& reference, const Points& points) {
  std::ranges::stable_sort(rewritings, {}, [](const CollectedForm* x) { return x->length; });
  return **std::ranges::find_if(rewritings, [&](const CollectedForm* x) {
    return x->terms == reference.terms ||
           is_as_precise(x->expressions, reference.expressions, points, LeafRounding::exact);
  });
}

bool is_nonnegative(const Algebra& algebra, const AtomPower& power, const LeafNames& leaves) {
  if (power.exponent % 2 == 0) return true;
  const Atom& atom = algebra.atoms[power.atom];
  if (atom.kind == AtomKind::leaf && atom.leaf == Opcode::parameter)
    return assumption_of(leaves, atom.index) != Assumption::none;
  return atom.kind == AtomKind::root || atom.kind == AtomKind::pi;
}

bool is_nonnegative(const Algebra& algebra, const RealTerm& term, const LeafNames& leaves) {
  const auto is_even = [](const CircularPower& power) {
    return power.cosine % 2 == 0 && power.sine % 2 == 0;
  };
  return cln::plusp(term.coefficient) && std::ranges::all_of(term.circular, is_even) &&
         std::ranges::all_of(term.powers, [&](const AtomPower& power) {
           return is_nonnegative(algebra, power, leaves);
         });
}

void append_entry(Function& to, Field& field, const Function& one) {
  const auto offset = static_cast<std::uint32_t>(to.instructions.size());
  for (Instruction i : one.instructions) {
    if (operand_count(i) > 0) i.a += offset;
    if (operand_count(i) > 1) i.b += offset;
    to.instructions.push_back(i);
  }
  to.names.resize(to.instructions.size());
  field.entries.push_back(one.fields[0].entries[0] + offset);
}

}  // namespace

std::size_t written_length(const Expressions& expressions) {
  return WrittenLengths(expressions).length_of(expressions.values[0].node);
}

Rewritings rewritings_of(const Algebra& algebra, const Fraction& form) {
  Rewritings rewritings;
  std::size_t terms = 0;
  for (WrittenForm& candidate : write_candidates(algebra, form)) {
    ++terms;
    for (const Grouping grouping : applicable_groupings(algebra, form)) {
      const auto grouped =
          grouping == Grouping::none
              ? std::optional(candidate)
              : write_form(algebra, form, {candidate.layout.trigonometry, grouping});
      if (!grouped) continue;
      rewritings.collected.push_back(collect_factors(grouped->expressions, terms, grouping));
    }
    rewritings.plain.push_back(std::move(candidate.expressions));
  }
  return rewritings;
}

CollectedForm derived_rewriting(const Expressions& derived) {
  return collect_factors(derived, 0, Grouping::none);
}

std::vector<CollectedForm> precise_rewritings(const Algebra& algebra, const Fraction& form) {
  std::vector<CollectedForm> rewritings;
  for (const Grouping grouping : applicable_groupings(algebra, form)) {
    const auto grouped = write_form(algebra, form, {Trigonometry::homogeneous, grouping});
    if (grouped) rewritings.push_back(collect_factors(grouped->expressions, SIZE_MAX, grouping));
  }
  return rewritings;
}

bool has_nonnegative_terms(const Algebra& algebra, const Fraction& form, const LeafNames& leaves) {
  const auto terms = homogeneous_terms(algebra, form.numerator, most_terms);
  return terms && !terms->empty() && std::ranges::all_of(*terms, [&](const RealTerm& term) {
           return is_nonnegative(algebra, term, leaves);
         });
}

bool is_as_precise(const Expressions& rewriting, const Expressions& reference, const Points& points,
                   LeafRounding leaves) {
  if (leaves == LeafRounding::exact && rounds_more_angles(rewriting, reference)) return false;
  Expressions expressions;
  expressions.values = {copy_value(expressions.graph, rewriting),
                        copy_value(expressions.graph, reference)};
  const LinearisedNetwork both(make_network(expressions));
  bool is_compared = false;
  for (const Arguments<double>& point : points) {
    const RunningErrorRules<Real> rules{running_leaves<Real>(point, leaves)};
    const auto entries =
        entries_of(both.function, fold<RunningValue<Real>>(rules, both.program, both.function));
    const Real& own = entries[0].error;
    const Real admitted = admitted_error(entries[1]);
    if (!admitted.is_defined()) continue;
    if (!own.is_defined() || own.value() > admitted.value()) return false;
    is_compared = true;
  }
  return is_compared;
}

std::optional<ReadableForm> choose_readable_form(const std::vector<CollectedForm>& rewritings,
                                                 const CollectedForm* derived,
                                                 const Points& points) {
  if (rewritings.empty() && derived == nullptr) return std::nullopt;
  const CollectedForm* readable = derived;
  if (!rewritings.empty()) {
    readable = &*std::ranges::min_element(rewritings, {}, &CollectedForm::weighted_length);
  }
  std::vector<const CollectedForm*> all;
  for (const CollectedForm& rewriting : rewritings) all.push_back(&rewriting);
  if (derived != nullptr) {
    all.push_back(derived);
    const bool is_shorter = derived->weighted_length < readable->weighted_length;
    if (is_shorter &&
        is_as_precise(derived->expressions, readable->expressions, points, LeafRounding::rounded)) {
      readable = derived;
    }
  }
  const CollectedForm& compact = shortest_precise_form(std::move(all), *readable, points);
  return ReadableForm{readable->expressions, compact.expressions, readable->length,
                      &compact == readable};
}

Function lower_separately(const ReadableEntries& entries, const Function& shape, Program& program) {
  Function readable = without_body(shape);
  readable.form = Form::closed;
  std::size_t next = 0;
  for (const Field& field : shape.fields) {
    Field& filled = readable.fields.emplace_back(Field{field.name, field.rows, field.columns, {}});
    for (std::size_t i = 0; i < field.entries.size(); ++i) {
      Function one;
      one.fields = {Field{"", 1, 1, {0}}};
      Network network = make_network(entries[next++]->readable);
      flip_signs(network);
      linearise(network, program, one);
      append_entry(readable, filled, one);
    }
  }
  return readable;
}

std::optional<DerivedEntry> derived_entry(const Program& program, const Function& function,
                                          std::uint32_t entry) {
  if (dependency_cone(function, {entry}, longest_derived).size() > longest_derived)
    return std::nullopt;
  Expressions derived = expressions_from_program(program, function, {entry});
  const Expressions written_out = flatten(derived, FlattenedProducts::all_products);
  if (written_length(written_out) > longest_derived) return std::nullopt;
  return DerivedEntry{std::move(derived), derived_rewriting(written_out)};
}

}  // namespace elgen
