// Resolver, sums: sum(i, a, b, e) -> e[a] + … + e[b], and 0 if b < a. Without merging, each of ten
// thousand terms would be differentiated and compared. Terms that differ only in a rational factor
// are therefore merged:
//
//     1*k*x + 2*k*x + 3*k*x + y   ->   6*k*x + y
#include <algorithm>
#include <vector>

#include "check/expressions/node_builder.hpp"
#include "check/expressions/resolver.hpp"
#include "check/names/integers.hpp"

namespace elgen {
namespace {

/// Terms of one kind differ only in a rational factor. With more kinds than this, probably every
/// term is of a different kind, so merging stops.
constexpr std::size_t most_kinds = 16;

/// number * factors / divisors
struct ScaledProduct {
  ExpressionId term = 0;
  cln::cl_RA number = 1;
  std::vector<ExpressionId> factors = {};
  std::vector<ExpressionId> divisors = {};
  bool is_merged = false;  ///< `number` includes the factor of another term
};

class LikeTermMerger {
 public:
  explicit LikeTermMerger(Context& context) : context_(context) {}

  /// Adds the term that was resolved last; `begin` is its first node.
  void add_term(ExpressionId term, std::size_t begin) {
    const bool is_tried = kinds_.size() <= most_kinds;
    if (is_tried && merge_products(term)) return context_.truncate(begin);
    terms_.push_back(term);
    if (!is_tried) others_.push_back(term);
  }

  /// The operands of the sum at `span`; the original terms if none were merged. Terms that cancel
  /// become a difference, so that their units and place are still checked.
  [[nodiscard]] std::vector<ExpressionId> merged_terms(const Span& span) {
    if (std::ranges::none_of(kinds_, &ScaledProduct::is_merged)) return terms_;
    const bool is_whole_sum = kinds_.size() == 1 && others_.empty();
    std::vector<ExpressionId> all;
    for (ScaledProduct& kind : kinds_) {
      const Span place = is_whole_sum ? span : node(kind.term).span;
      const bool cancels = kind.is_merged && cln::zerop(kind.number);
      if (cancels) kind.number = 1;
      all.push_back(kind.is_merged ? build_product(kind, place) : kind.term);
      if (cancels) all.push_back(NodeBuilder(context_, place).negate(all.back()));
    }
    all.insert(all.end(), others_.begin(), others_.end());
    return all;
  }

 private:
  [[nodiscard]] const Expression& node(ExpressionId id) const {
    return context_.model.expressions[id];
  }

  /// Merges each product of the term into its kind, or starts a new kind. False if a kind is new,
  /// so that the term's nodes are needed.
  bool merge_products(ExpressionId term) {
    if (node(term).kind == ExpressionKind::add) {
      bool are_known = true;
      for (const ExpressionId operand : node(term).operands) {
        are_known = merge_products(operand) && are_known;
      }
      return are_known;
    }
    ScaledProduct product{.term = term};
    multiply_into(product, term, false);
    // A division by 0 is reported later, at the text of the quotient.
    const bool divides_by_zero = std::ranges::any_of(product.divisors, [this](ExpressionId id) {
      return node(id).kind == ExpressionKind::number;
    });
    if (divides_by_zero) product = {.term = term, .factors = {term}};
    const auto like = std::ranges::find_if(kinds_, [&](const ScaledProduct& kind) {
      return have_equal_nodes(kind.factors, product.factors) &&
             have_equal_nodes(kind.divisors, product.divisors) &&
             digit_count(kind.number + product.number) <= largest_exact_digits;
    });
    if (like == kinds_.end()) {
      kinds_.push_back(std::move(product));
      return false;
    }
    like->number = like->number + product.number;
    like->is_merged = true;
    return true;
  }

  void multiply_into(ScaledProduct& product, ExpressionId id, bool is_divisor) const {
    const Expression& e = node(id);
    if (e.kind == ExpressionKind::number && !(is_divisor && cln::zerop(e.number))) {
      product.number = is_divisor ? product.number / e.number : product.number * e.number;
    } else if (e.kind == ExpressionKind::negate) {
      product.number = -product.number;
      multiply_into(product, e.operands.front(), is_divisor);
    } else if (e.kind == ExpressionKind::multiply) {
      for (const ExpressionId factor : e.operands) multiply_into(product, factor, is_divisor);
    } else if (e.kind == ExpressionKind::divide) {
      multiply_into(product, e.operands.front(), is_divisor);
      multiply_into(product, e.operands.back(), !is_divisor);
    } else {
      (is_divisor ? product.divisors : product.factors).push_back(id);
    }
  }

  [[nodiscard]] bool have_equal_nodes(const std::vector<ExpressionId>& a,
                                      const std::vector<ExpressionId>& b) const {
    return std::ranges::equal(a, b, [this](ExpressionId i, ExpressionId k) {
      const Expression& x = node(i);
      const Expression& y = node(k);
      return x.kind == y.kind && x.leaf == y.leaf && x.function == y.function &&
             x.named == y.named && x.index == y.index && x.component == y.component &&
             x.number == y.number && have_equal_nodes(x.operands, y.operands);
    });
  }

  ExpressionId build_product(const ScaledProduct& product, const Span& span) {
    NodeBuilder nodes(context_, span);
    std::vector<ExpressionId> factors{nodes.number(product.number)};
    factors.insert(factors.end(), product.factors.begin(), product.factors.end());
    const ExpressionId top = nodes.multiply(factors);
    return product.divisors.empty() ? top : nodes.divide(top, nodes.multiply(product.divisors));
  }

  Context& context_;
  std::vector<ExpressionId> terms_ = {};   ///< terms whose nodes are in the model
  std::vector<ScaledProduct> kinds_ = {};  ///< one product per kind; later terms are merged into it
  std::vector<ExpressionId> others_ = {};  ///< terms after `most_kinds`, not merged
};

}  // namespace

std::optional<ExpressionId> Resolver::resolve_sum(const ExpressionSyntax& call) {
  if (!check_arity(call, 4)) return std::nullopt;
  const ExpressionSyntax& index = call.operands[0];
  if (index.kind != SyntaxKind::name || !index.operands.empty()) {
    context_.report.add(Code::E210, index.span,
                        in_backticks(index.span) + " is not the name of a running index",
                        "write `sum(i, 1, n, …)`");
    return std::nullopt;
  }
  const auto low = evaluate_integer(call.operands[1], scope_, context_.report);
  const auto high = evaluate_integer(call.operands[2], scope_, context_.report);
  if (!low || !high) return std::nullopt;
  Expression sum{.kind = ExpressionKind::add, .span = call.span};
  LikeTermMerger like(context_);
  for (std::int64_t i = *low; i <= *high; ++i) {
    const std::size_t begin = context_.model.expressions.size();
    scope_.push(index.text, i);
    const std::optional<ExpressionId> term = resolve(call.operands[3]);
    scope_.pop();
    if (!term) return std::nullopt;
    like.add_term(*term, begin);
  }
  sum.operands = like.merged_terms(call.span);
  if (sum.operands.empty()) return push_number(0, call.span);
  return sum.operands.size() == 1 ? std::optional(sum.operands.front()) : push(std::move(sum));
}

}  // namespace elgen
