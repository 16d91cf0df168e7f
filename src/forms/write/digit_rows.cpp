// digit_rows: see digit_rows.hpp. The term of a row with the most calls is matched first. Its calls
// determine letters, and its remaining factors are the common factor of the row. Each other term is
// then known completely, or determines a further letter.
#include "forms/write/digit_rows.hpp"

#include <algorithm>
#include <array>
#include <functional>

namespace elgen {
namespace {

using cln::cl_RA;

using Letters = std::array<std::optional<Ref>, 3>;

/// The letters found so far, the common factor, and the positions of the matched terms.
struct Match {
  Letters letters = {};
  ScaledTerm common_factor = {};
  std::vector<std::size_t> places = {};
};

/// Writes the replacement of a row whose letters are known.
class RowWriter : protected GraphTerms {
 public:
  RowWriter(Graph& graph, RewriteOptions keeping) : GraphTerms(graph), keeping_(keeping) {}

  /// The replacement of the matched terms.
  Ref replacement(const DigitPattern& row, const Match& match) {
    return times(product(match.common_factor), substitute_letters(row.to, match.letters, true));
  }

  /// The value of a pattern term, times the common factor.
  ScaledTerm known_term(const ScaledTerm& pattern, const Match& match) {
    std::vector<Power> powers{{product(match.common_factor)},
                              {graph_.rational(pattern.coefficient)}};
    for (const Operand& factor : pattern.factors) {
      append_powers(factor, match.letters, false, powers);
    }
    return scaled(graph_.product(powers));
  }

 protected:
  RewriteOptions keeping_;

 private:
  /// Substitutes the letters in a pattern. If `is_kept`, sums in the result are rewritten too,
  /// except in divisors.
  Ref substitute_letters(Ref pattern, const Letters& letters, bool is_kept) {
    const Node& node = digit_patterns().graph.node(pattern.node);
    if (node.kind == NodeKind::leaf) return with_sign(*letters[node.index], pattern.negative);
    if (node.kind == NodeKind::product || node.kind == NodeKind::rational) {
      std::vector<Power> powers;
      append_powers({pattern.node, 1}, letters, is_kept, powers);
      return with_sign(graph_.product(powers), pattern.negative);
    }
    std::vector<Ref> operands;
    for (const Operand& operand : node.operands) {
      operands.push_back(substitute_letters({operand.node, operand.weight < 0}, letters, is_kept));
    }
    Ref value = graph_.pi();
    if (node.kind == NodeKind::call) value = graph_.call(node.function, operands);
    if (node.kind == NodeKind::square_root) value = graph_.square_root(operands.front());
    if (node.kind == NodeKind::sum) {
      value = short_sum(operands);
      if (is_kept) value = rewrite_sum(graph_, keeping_, value).value_or(value);
    }
    return with_sign(value, pattern.negative);
  }

  void append_powers(const Operand& pattern, const Letters& letters, bool is_kept,
                     std::vector<Power>& powers) {
    const Graph& read = digit_patterns().graph;
    const Node& node = read.node(pattern.node);
    if (node.kind == NodeKind::rational) {
      return powers.push_back({graph_.rational(read.rational_of(pattern.node)), pattern.weight});
    }
    if (node.kind != NodeKind::product) {
      const bool is_kept_too = is_kept && pattern.weight > 0;
      const Ref base = substitute_letters({pattern.node, false}, letters, is_kept_too);
      return powers.push_back({base, pattern.weight});
    }
    for (const Operand& factor : node.operands) {
      append_powers({factor.node, factor.weight * pattern.weight}, letters, is_kept, powers);
    }
  }
};

/// Finds the letters of rows in the terms of a graph.
class RowMatcher : protected RowWriter {
 public:
  using RowWriter::replacement;
  using RowWriter::RowWriter;

  /// All ways to write `value` as the pattern times a common factor. An odd function matches with
  /// either sign of its argument.
  [[nodiscard]] std::vector<Match> matches(const ScaledTerm& pattern, const ScaledTerm& value,
                                           const Letters& known) const {
    std::vector<Match> found;
    Match start{known, value};
    start.common_factor.coefficient = value.coefficient / pattern.coefficient;
    extend(pattern, 0, start, found);
    const auto odd = std::ranges::find_if(pattern.factors, [&](const Operand& factor) {
      const Node& node = digit_patterns().graph.node(factor.node);
      return node.kind == NodeKind::call && function_row(node.function).parity == Parity::odd &&
             !known[*letter_of(factor.node)];
    });
    if (odd == pattern.factors.end()) return found;
    std::vector<Match> turned = found;
    for (Match& match : turned) {
      std::optional<Ref>& letter = match.letters[*letter_of(odd->node)];
      letter = -*letter;
      match.common_factor.coefficient = -match.common_factor.coefficient;
    }
    found.insert(found.end(), turned.begin(), turned.end());
    return found;
  }

  /// Matches `value` with the pattern a^n or sqrt(a) and sets the letter a. False if `value` is not
  /// an n-th power (for a^n) or not a root (for sqrt(a)).
  bool match_root(const Operand& pattern, const ScaledTerm& value, Letters& letters) {
    std::optional<Ref>& letter = letters[*letter_of(pattern.node)];
    if (digit_patterns().graph.node(pattern.node).kind == NodeKind::leaf) {
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

  bool holds(RowCondition condition, const Letters& letters) {
    switch (condition) {
      case RowCondition::always:
        return true;
      case RowCondition::shorter:
        return term_count(*letters[1]) <= term_count(*letters[0]);
      case RowCondition::factored:
        return keeping_.squares == Squares::factored;
      case RowCondition::anchored:
        return !has_branches(*letters[0]) && !has_branches(*letters[1]) &&
               (has_parameter_term_expanded(*letters[0]) ||
                has_parameter_term_expanded(*letters[1]));
      case RowCondition::computed:
        return graph_.node(letters[0]->node).kind != NodeKind::leaf;
    }
    return false;
  }

 private:
  /// has_parameter_term() after expansion, so that (2 + x)^2 counts.
  bool has_parameter_term_expanded(Ref value) {
    const auto terms = expanded_terms({value});
    return has_parameter_term(terms ? graph_.sum(*terms) : value);
  }

  void extend(const ScaledTerm& pattern, std::size_t next, const Match& match,
              std::vector<Match>& found) const {
    if (next == pattern.factors.size()) return found.push_back(match);
    const Operand& wanted = pattern.factors[next];
    for (std::size_t i = 0; i < match.common_factor.factors.size(); ++i) {
      const Operand& factor = match.common_factor.factors[i];
      Letters letters = match.letters;
      if (factor.weight < wanted.weight || !match_call(wanted.node, factor.node, letters)) continue;
      Match further{letters, match.common_factor};
      further.common_factor.factors[i].weight -= wanted.weight;
      std::erase_if(further.common_factor.factors,
                    [](const Operand& left) { return left.weight == 0; });
      extend(pattern, next + 1, further, found);
    }
  }

  /// True if `value` calls the function of the pattern, with the argument that the letter already
  /// has. A letter without a value is set to the argument.
  bool match_call(NodeId pattern, NodeId value, Letters& letters) const {
    const Node& wanted = digit_patterns().graph.node(pattern);
    const Node& node = graph_.node(value);
    if (wanted.kind != NodeKind::call || !is_call(node, wanted.function)) return false;
    std::optional<Ref>& letter = letters[*letter_of(pattern)];
    const Ref argument = argument_of(node);
    if (!letter) letter = argument;
    const bool is_even = function_row(wanted.function).parity == Parity::even;
    return is_even ? letter->node == argument.node : *letter == argument;
  }
};

/// A term that matches the call of a unit row (one call and a constant).
struct UnitTerm {
  const DigitPattern* row = nullptr;
  Match match = {};
  ScaledTerm constant = {};  ///< the constant term that completes the row
};

/// Replaces terms of one sum by rows.
class RowsOfSum : RowMatcher {
 public:
  RowsOfSum(Graph& graph, RewriteOptions keeping, std::vector<Ref>& terms)
      : RowMatcher(graph, keeping), terms_(terms) {
    for (const Ref term : terms) {
      parts_.push_back(scaled(term));
      functions_.push_back(functions_of(graph_, parts_.back()));
    }
  }

  bool replace_one() {
    const auto is_free = [](std::uint64_t functions) { return functions == 0; };
    if (std::ranges::all_of(functions_, is_free)) return false;
    return replace_by_rows(3) || replace_units() || replace_by_rows(2);
  }

 private:
  /// Tries all rows of `size` terms with calls, except unit rows.
  bool replace_by_rows(std::size_t size) {
    return std::ranges::any_of(digit_patterns().rows, [&](const DigitPattern& row) {
      const bool is_tried = row.terms.size() == size && row.functions != 0 && !row.is_unit();
      return is_tried && replace_by(row);
    });
  }

  bool replace_by(const DigitPattern& row) {
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      if ((row.functions & functions_[i]) != row.functions) continue;
      for (Match& match : matches(row.terms[0], parts_[i], {})) {
        match.places = {i};
        if (!complete(row, match)) continue;
        replace_terms(replacement(row, match), match.places);
        return true;
      }
    }
    return false;
  }

  /// Finds the remaining terms of the row; false if a term is missing or the condition fails.
  bool complete(const DigitPattern& row, Match& match) {
    if (match.places.size() == row.terms.size()) return holds(row.condition, match.letters);
    const ScaledTerm& pattern = row.terms[match.places.size()];
    const bool is_known = std::ranges::all_of(pattern.factors, [&](const Operand& factor) {
      const auto letter = letter_of(factor.node);
      return !letter || match.letters[*letter];
    });
    const ScaledTerm known = is_known ? known_term(pattern, match) : pattern;
    for (std::size_t k = 0; k < parts_.size(); ++k) {
      if (std::ranges::find(match.places, k) != match.places.end()) continue;
      if (is_known && !is_same(known, parts_[k])) continue;
      std::vector<Match> ways =
          is_known ? std::vector{match} : matches(pattern, parts_[k], match.letters);
      for (Match& way : ways) {
        way.places = match.places;
        way.places.push_back(k);
        if (!is_same(way.common_factor, match.common_factor) || !complete(row, way)) continue;
        match = std::move(way);
        return true;
      }
    }
    return false;
  }

  /// Rewrites c - c_1 cos(x_1) - c_2 cos(x_2) - ... if the sum of all c_i is at
  /// least 7/8 of c and at most c.
  bool replace_units() {
    std::vector<UnitTerm> all;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      for (const DigitPattern& row : digit_patterns().rows) {
        if (!row.is_unit() || (row.functions & functions_[i]) == 0) continue;
        for (Match& match : matches(row.terms[0], parts_[i], {})) {
          match.places = {i};
          ScaledTerm constant = match.common_factor;
          constant.coefficient = constant.coefficient * row.terms[1].coefficient;
          all.push_back({&row, std::move(match), std::move(constant)});
        }
      }
    }
    for (std::size_t place = 0; place < parts_.size() && !all.empty(); ++place) {
      if (replace_units_of(place, all)) return true;
    }
    return false;
  }

  bool replace_units_of(std::size_t place, const std::vector<UnitTerm>& all) {
    const cl_RA constant = parts_[place].coefficient;
    const std::vector<Operand>& factors = parts_[place].factors;
    std::vector<const UnitTerm*> chosen;
    cl_RA total = 0;
    for (const UnitTerm& unit : all) {
      const std::size_t own = unit.match.places[0];
      const cl_RA& taken = unit.constant.coefficient;
      const bool is_beside = own != place && cln::minusp(taken) == cln::minusp(constant) &&
                             is_same({taken, factors}, unit.constant);
      if (!is_beside || (!chosen.empty() && chosen.back()->match.places[0] == own)) continue;
      chosen.push_back(&unit);
      total = total + taken;
    }
    const auto alone = std::ranges::find_if(
        chosen, [&](const UnitTerm* unit) { return unit->constant.coefficient == constant; });
    if (alone != chosen.end() && total != constant) {
      chosen = {*alone};
      total = constant;
    }
    // If the sum of the c_i is less than 7/8 of c, fewer than three bits cancel.
    const cl_RA share = total / constant;
    if (share * 8 < 7 || share > 1) return false;
    for (const UnitTerm* unit : chosen) {
      terms_[unit->match.places[0]] = replacement(*unit->row, unit->match);
    }
    replace_terms(product(constant - total, factors), {place});
    if (share == 1) terms_.erase(terms_.begin() + static_cast<std::ptrdiff_t>(place));
    return true;
  }

  /// Replaces the terms at `places` by `term`.
  void replace_terms(Ref term, std::vector<std::size_t> places) {
    terms_[places.front()] = term;
    places.erase(places.begin());
    std::ranges::sort(places, std::greater<>());
    for (const std::size_t place : places) {
      terms_.erase(terms_.begin() + static_cast<std::ptrdiff_t>(place));
    }
  }

  std::vector<Ref>& terms_;
  std::vector<ScaledTerm> parts_ = {};         ///< split into coefficient and factors
  std::vector<std::uint64_t> functions_ = {};  ///< called by each term, as a bit set
};

}  // namespace

bool replace_by_row(Graph& graph, RewriteOptions keeping, std::vector<Ref>& terms) {
  return RowsOfSum(graph, keeping, terms).replace_one();
}

std::optional<Ref> pair_by_row(Graph& graph, RewriteOptions keeping, const ScaledTerm& x,
                               const ScaledTerm& y) {
  RowMatcher matching(graph, keeping);
  for (const DigitPattern& row : digit_patterns().rows) {
    if (row.functions != 0) continue;
    for (const bool is_turned : {false, true}) {
      const ScaledTerm& first = is_turned ? y : x;
      const ScaledTerm& second = is_turned ? x : y;
      if (first.factors.empty()) continue;
      Match match{.common_factor = {first.coefficient / row.terms[0].coefficient}};
      const cl_RA scale = match.common_factor.coefficient * row.terms[1].coefficient;
      const ScaledTerm rest{second.coefficient / scale, second.factors};
      const bool is_matched =
          matching.match_root(row.terms[0].factors[0], {1, first.factors}, match.letters) &&
          matching.match_root(row.terms[1].factors[0], rest, match.letters);
      if (is_matched && matching.holds(row.condition, match.letters)) {
        return matching.replacement(row, match);
      }
    }
  }
  return std::nullopt;
}

std::optional<Ref> call_by_row(Graph& graph, RewriteOptions keeping, NodeId call) {
  RowMatcher matching(graph, keeping);
  const ScaledTerm value{1, {{call, 1}}};
  for (const DigitPattern& row : digit_patterns().rows) {
    if (row.terms.size() > 1) continue;
    for (const Match& match : matching.matches(row.terms[0], value, {})) {
      if (matching.holds(row.condition, match.letters)) return matching.replacement(row, match);
    }
  }
  return std::nullopt;
}

}  // namespace elgen
