// digit_rows: see digit_rows.hpp. In each row, the term with the most calls is matched first. The
// calls of this term determine letters, and its remaining factors are the common factor of the row.
// Each other term is then known completely, or determines a further letter.
#include "forms/write/digit_rows.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <set>

namespace elgen {
namespace {

using cln::cl_RA;

using PatternSubstitution = std::array<std::optional<SignedNode>, 3>;

/// The letters found so far, the common factor, and the positions of the matched terms.
struct Match {
  PatternSubstitution substitution = {};
  ScaledTerm common_factor = {};
  std::vector<std::size_t> term_indices = {};
};

/// Writes the replacement of a row whose letters are known.
class ReplacementBuilder : protected GraphTermBuilder {
 public:
  ReplacementBuilder(Graph& graph, RewriteOptions keeping)
      : GraphTermBuilder(graph), options_(keeping) {}

  /// The replacement of the matched terms.
  SignedNode build_replacement(const RulePattern& row, const Match& match) {
    return multiply(product(match.common_factor),
                    substitute_letters(row.to, match.substitution, true));
  }

  /// `pattern` with the letters of `match` substituted, times the common factor of `match`.
  ScaledTerm instantiate_term(const ScaledTerm& pattern, const Match& match) {
    std::vector<Power> powers{{product(match.common_factor)},
                              {graph_.rational(pattern.coefficient)}};
    for (const Operand& factor : pattern.factors) {
      append_powers(factor, match.substitution, false, powers);
    }
    return split_term(graph_.product(powers));
  }

 protected:
  RewriteOptions options_;

 private:
  /// Substitutes the letters in a pattern. If `is_kept`, sums in the result are rewritten too,
  /// except in divisors.
  SignedNode substitute_letters(SignedNode pattern, const PatternSubstitution& letters,
                                bool is_kept) {
    const Node& node = rule_patterns().graph.node(pattern.node);
    if (node.kind == NodeKind::leaf) return negate_if(*letters[node.index], pattern.is_negative);
    if (node.kind == NodeKind::product || node.kind == NodeKind::rational) {
      std::vector<Power> powers;
      append_powers({pattern.node, 1}, letters, is_kept, powers);
      return negate_if(graph_.product(powers), pattern.is_negative);
    }
    std::vector<SignedNode> operands;
    for (const Operand& operand : node.operands) {
      operands.push_back(substitute_letters({operand.node, operand.weight < 0}, letters, is_kept));
    }
    SignedNode value = graph_.pi();
    if (node.kind == NodeKind::call) value = graph_.call(node.function, operands);
    if (node.kind == NodeKind::square_root) value = graph_.square_root(operands.front());
    if (node.kind == NodeKind::sum) {
      value = sum_of_letters(operands);
      if (is_kept) value = rewrite_sum(graph_, options_, value).value_or(value);
    }
    return negate_if(value, pattern.is_negative);
  }

  /// The sum of letters. If all letters have several terms, it is flattened only if a term cancels
  /// then, as in (x + h) - (x - h). Otherwise small differences inside letters stay together:
  ///
  ///     (b - a) + (c - a), not b + c - 2 a        k (x - y), not k x - k y
  SignedNode sum_of_letters(const std::vector<SignedNode>& letters) {
    const SignedNode flat = short_sum(letters);
    std::set<NodeId> kinds;
    for (const SignedNode letter : letters) {
      const std::vector<SignedNode> parts = distribute_products({letter});
      if (parts.size() == 1) return flat;
      for (const SignedNode part : parts) kinds.insert(product(1, split_term(part).factors).node);
    }
    return term_count(flat) < kinds.size() ? flat : graph_.sum(letters);
  }

  void append_powers(const Operand& pattern, const PatternSubstitution& letters, bool is_kept,
                     std::vector<Power>& powers) {
    const Graph& read = rule_patterns().graph;
    const Node& node = read.node(pattern.node);
    if (node.kind == NodeKind::rational) {
      return powers.push_back({graph_.rational(read.rational_of(pattern.node)), pattern.weight});
    }
    if (node.kind != NodeKind::product) {
      const bool is_kept_too = is_kept && pattern.weight > 0;
      const SignedNode base = substitute_letters({pattern.node, false}, letters, is_kept_too);
      return powers.push_back({base, pattern.weight});
    }
    for (const Operand& factor : node.operands) {
      append_powers({factor.node, factor.weight * pattern.weight}, letters, is_kept, powers);
    }
  }
};

/// Finds the letters of rows in the terms of a graph.
class RuleMatcher : protected ReplacementBuilder {
 public:
  using ReplacementBuilder::build_replacement;
  using ReplacementBuilder::ReplacementBuilder;

  /// All ways to write `value` as the pattern times a common factor. An odd power of an odd
  /// function matches with either sign of its argument.
  [[nodiscard]] std::vector<Match> find_matches(const ScaledTerm& pattern, const ScaledTerm& value,
                                                const PatternSubstitution& known) const {
    std::vector<Match> found;
    Match start{known, value};
    start.common_factor.coefficient = value.coefficient / pattern.coefficient;
    extend_match(pattern, 0, start, found);
    const auto odd = std::ranges::find_if(pattern.factors, [&](const Operand& factor) {
      const Node& node = rule_patterns().graph.node(factor.node);
      const bool is_odd = node.kind == NodeKind::call && factor.weight % 2 != 0 &&
                          function_row(node.function).parity == Parity::odd;
      return is_odd && !known[*pattern_variable(factor.node)];
    });
    if (odd == pattern.factors.end()) return found;
    std::vector<Match> turned = found;
    for (Match& match : turned) {
      std::optional<SignedNode>& letter = match.substitution[*pattern_variable(odd->node)];
      letter = -*letter;
      match.common_factor.coefficient = -match.common_factor.coefficient;
    }
    found.insert(found.end(), turned.begin(), turned.end());
    return found;
  }

  /// Matches `value` with the pattern a^n or sqrt(a) and sets the letter a. False if `value` is not
  /// an n-th power (for a^n) or not a root (for sqrt(a)).
  bool match_root(const Operand& pattern, const ScaledTerm& value, PatternSubstitution& letters) {
    std::optional<SignedNode>& letter = letters[*pattern_variable(pattern.node)];
    if (rule_patterns().graph.node(pattern.node).kind == NodeKind::leaf) {
      letter = exact_root(value, pattern.weight);
      return letter.has_value();
    }
    if (value.coefficient != 1 || value.factors.size() != 1) return false;
    const auto [id, weight] = value.factors.front();
    const Node& node = graph_.node(id);
    if (weight != 1 || node.kind != NodeKind::square_root) return false;
    letter = argument_of(node);
    return true;
  }

  bool is_satisfied(RuleCondition condition, const PatternSubstitution& letters) {
    switch (condition) {
      case RuleCondition::always:
        return true;
      case RuleCondition::shorter:
        return term_count(*letters[1]) <= term_count(*letters[0]) && *letters[0] != -*letters[1];
      case RuleCondition::factored:
        return options_.squares == SquareHandling::factored;
      case RuleCondition::anchored:
        if (has_only_parameters(*letters[0]) || has_only_parameters(*letters[1])) return true;
        return !has_branches(*letters[0]) && !has_branches(*letters[1]) &&
               (expands_to_parameter_term(*letters[0]) || expands_to_parameter_term(*letters[1]));
      case RuleCondition::computed:
        return graph_.node(letters[0]->node).kind != NodeKind::leaf;
    }
    return false;
  }

 private:
  /// True if the expanded `value` has a parameter term, such as 4 in (2 + x)^2.
  bool expands_to_parameter_term(SignedNode value) {
    const auto terms = expanded_terms({value});
    return has_parameter_term(terms ? graph_.sum(*terms) : value);
  }

  void extend_match(const ScaledTerm& pattern, std::size_t next, const Match& match,
                    std::vector<Match>& found) const {
    if (next == pattern.factors.size()) return found.push_back(match);
    const Operand& wanted = pattern.factors[next];
    for (std::size_t i = 0; i < match.common_factor.factors.size(); ++i) {
      const Operand& factor = match.common_factor.factors[i];
      PatternSubstitution letters = match.substitution;
      if (factor.weight < wanted.weight || !match_call(wanted.node, factor.node, letters)) continue;
      Match further{letters, match.common_factor};
      further.common_factor.factors[i].weight -= wanted.weight;
      std::erase_if(further.common_factor.factors,
                    [](const Operand& left) { return left.weight == 0; });
      extend_match(pattern, next + 1, further, found);
    }
  }

  /// True if `value` calls the function of `pattern` with the value of the letter as argument; the
  /// sign is ignored if the function is even. A letter without a value is set to the argument. The
  /// argument of `pattern` may be another call: log1p(exp(a)).
  bool match_call(NodeId pattern, NodeId value, PatternSubstitution& letters) const {
    const Node& wanted = rule_patterns().graph.node(pattern);
    const Node& node = graph_.node(value);
    if (wanted.kind != NodeKind::call || !is_call(node, wanted.function)) return false;
    const SignedNode argument = argument_of(node);
    const NodeId inner = argument_of(wanted).node;
    if (rule_patterns().graph.node(inner).kind == NodeKind::call)
      return !argument.is_negative && match_call(inner, argument.node, letters);
    std::optional<SignedNode>& letter = letters[*pattern_variable(pattern)];
    if (!letter) letter = argument;
    const bool is_even = function_row(wanted.function).parity == Parity::even;
    return is_even ? letter->node == argument.node : *letter == argument;
  }
};

/// A term that matches the call in a row of one call and a constant: cos(a) in 1 - cos(a).
struct MatchedCall {
  const RulePattern* row = nullptr;
  Match match = {};
  ScaledTerm constant = {};  ///< the constant term that completes the row
};

/// Replaces, in one sum, the terms that match a row by the result `to` of the row.
class SumRuleApplier : RuleMatcher {
 public:
  SumRuleApplier(Graph& graph, RewriteOptions keeping, std::vector<SignedNode>& terms)
      : RuleMatcher(graph, keeping), terms_(terms) {
    for (const SignedNode term : terms) {
      split_terms_.push_back(split_term(term));
      functions_.push_back(called_function_bits(graph_, split_terms_.back()));
    }
  }

  bool apply_one_rule() {
    const auto is_free = [](std::uint64_t functions) { return functions == 0; };
    if (std::ranges::all_of(functions_, is_free)) return false;
    return apply_rules_of_size(3) || apply_constant_rules() || apply_rules_of_size(2);
  }

 private:
  /// Applies the first matching row that has `size` terms and at least one call. Rows of one call
  /// and a constant are excluded. False if no row matches.
  bool apply_rules_of_size(std::size_t size) {
    return std::ranges::any_of(rule_patterns().rows, [&](const RulePattern& row) {
      const bool is_tried =
          row.terms.size() == size && row.functions != 0 && !row.is_call_and_constant();
      return is_tried && apply_rule(row);
    });
  }

  bool apply_rule(const RulePattern& row) {
    for (std::size_t i = 0; i < split_terms_.size(); ++i) {
      if ((row.functions & functions_[i]) != row.functions) continue;
      for (Match& match : find_matches(row.terms[0], split_terms_[i], {})) {
        match.term_indices = {i};
        if (!complete_match(row, match)) continue;
        replace_terms(build_replacement(row, match), match.term_indices);
        return true;
      }
    }
    return false;
  }

  /// Finds the remaining terms of the row; false if a term is missing or the condition fails.
  bool complete_match(const RulePattern& row, Match& match) {
    if (match.term_indices.size() == row.terms.size())
      return is_satisfied(row.condition, match.substitution);
    const ScaledTerm& pattern = row.terms[match.term_indices.size()];
    const bool is_known = std::ranges::all_of(pattern.factors, [&](const Operand& factor) {
      const auto letter = pattern_variable(factor.node);
      return !letter || match.substitution[*letter];
    });
    const ScaledTerm known = is_known ? instantiate_term(pattern, match) : pattern;
    for (std::size_t k = 0; k < split_terms_.size(); ++k) {
      if (std::ranges::find(match.term_indices, k) != match.term_indices.end()) continue;
      if (is_known && !are_equal_terms(known, split_terms_[k])) continue;
      std::vector<Match> completions =
          is_known ? std::vector{match}
                   : find_matches(pattern, split_terms_[k], match.substitution);
      for (Match& way : completions) {
        way.term_indices = match.term_indices;
        way.term_indices.push_back(k);
        if (!are_equal_terms(way.common_factor, match.common_factor) || !complete_match(row, way))
          continue;
        match = std::move(way);
        return true;
      }
    }
    return false;
  }

  /// Rewrites sums such as c - c_1 cos(x_1) - c_2 cos(x_2) if the sum of all c_i is at least 7/8 of
  /// c and at most c. False if no sum is rewritten.
  bool apply_constant_rules() {
    std::vector<MatchedCall> all;
    for (std::size_t i = 0; i < split_terms_.size(); ++i) {
      for (const RulePattern& row : rule_patterns().rows) {
        if (!row.is_call_and_constant() || (row.functions & functions_[i]) == 0) continue;
        for (Match& match : find_matches(row.terms[0], split_terms_[i], {})) {
          match.term_indices = {i};
          ScaledTerm constant = match.common_factor;
          constant.coefficient = constant.coefficient * row.terms[1].coefficient;
          all.push_back({&row, std::move(match), std::move(constant)});
        }
      }
    }
    for (std::size_t place = 0; place < split_terms_.size() && !all.empty(); ++place) {
      if (apply_constant_rules_at(place, all)) return true;
    }
    return false;
  }

  bool apply_constant_rules_at(std::size_t place, const std::vector<MatchedCall>& all) {
    const cl_RA constant = split_terms_[place].coefficient;
    const std::vector<Operand>& factors = split_terms_[place].factors;
    std::vector<const MatchedCall*> chosen;
    cl_RA total = 0;
    for (const MatchedCall& unit : all) {
      const std::size_t own = unit.match.term_indices[0];
      const cl_RA& coefficient = unit.constant.coefficient;
      const bool is_beside = own != place && cln::minusp(coefficient) == cln::minusp(constant) &&
                             are_equal_terms({coefficient, factors}, unit.constant);
      if (!is_beside || (!chosen.empty() && chosen.back()->match.term_indices[0] == own)) continue;
      chosen.push_back(&unit);
      total = total + coefficient;
    }
    const auto alone = std::ranges::find_if(
        chosen, [&](const MatchedCall* unit) { return unit->constant.coefficient == constant; });
    if (alone != chosen.end() && total != constant) {
      chosen = {*alone};
      total = constant;
    }
    // If the sum of the c_i is less than 7/8 of c, fewer than three bits cancel.
    const cl_RA share = total / constant;
    if (share * 8 < 7 || share > 1) return false;
    for (const MatchedCall* unit : chosen) {
      terms_[unit->match.term_indices[0]] = build_replacement(*unit->row, unit->match);
    }
    replace_terms(product(constant - total, factors), {place});
    if (share == 1) terms_.erase(terms_.begin() + static_cast<std::ptrdiff_t>(place));
    return true;
  }

  /// Replaces the terms at `places` by `term`.
  void replace_terms(SignedNode term, std::vector<std::size_t> places) {
    terms_[places.front()] = term;
    places.erase(places.begin());
    std::ranges::sort(places, std::greater<>());
    for (const std::size_t place : places) {
      terms_.erase(terms_.begin() + static_cast<std::ptrdiff_t>(place));
    }
  }

  std::vector<SignedNode>& terms_;
  std::vector<ScaledTerm> split_terms_ = {};   ///< split into coefficient and factors
  std::vector<std::uint64_t> functions_ = {};  ///< per term: the called functions, as a bit set
};

}  // namespace

bool rewrite_terms_by_rule(Graph& graph, RewriteOptions keeping, std::vector<SignedNode>& terms) {
  return SumRuleApplier(graph, keeping, terms).apply_one_rule();
}

std::optional<SignedNode> rewrite_pair_by_rule(Graph& graph, RewriteOptions keeping,
                                               const ScaledTerm& x, const ScaledTerm& y) {
  RuleMatcher matching(graph, keeping);
  for (const RulePattern& row : rule_patterns().rows) {
    if (row.functions != 0) continue;
    for (const bool is_turned : {false, true}) {
      const ScaledTerm& first = is_turned ? y : x;
      const ScaledTerm& second = is_turned ? x : y;
      if (first.factors.empty()) continue;
      Match match{.common_factor = {first.coefficient / row.terms[0].coefficient}};
      const cl_RA scale = match.common_factor.coefficient * row.terms[1].coefficient;
      const ScaledTerm rest{second.coefficient / scale, second.factors};
      const bool is_matched =
          matching.match_root(row.terms[0].factors[0], {1, first.factors}, match.substitution) &&
          matching.match_root(row.terms[1].factors[0], rest, match.substitution);
      if (is_matched && matching.is_satisfied(row.condition, match.substitution)) {
        return matching.build_replacement(row, match);
      }
    }
  }
  return std::nullopt;
}

std::optional<SignedNode> rewrite_call_by_rule(Graph& graph, RewriteOptions keeping, NodeId call) {
  RuleMatcher matching(graph, keeping);
  const ScaledTerm value{1, {{call, 1}}};
  for (const RulePattern& row : rule_patterns().rows) {
    if (row.terms.size() > 1) continue;
    for (const Match& match : matching.find_matches(row.terms[0], value, {})) {
      if (matching.is_satisfied(row.condition, match.substitution))
        return matching.build_replacement(row, match);
    }
  }
  return std::nullopt;
}

}  // namespace elgen
