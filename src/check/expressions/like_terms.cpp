// Terms are products of a number and factors; factors are compared node by node.
#include "check/expressions/like_terms.hpp"

#include <algorithm>

#include "check/expressions/node_builder.hpp"

namespace elgen {
namespace {

/// Terms of a sum are written by one text, so there are few kinds of them or as many as terms.
constexpr std::size_t most_kinds = 16;

struct Product {
  ExpressionId term = 0;
  cln::cl_RA number = 1;
  std::vector<ExpressionId> factors = {};
  std::vector<ExpressionId> divisors = {};
  bool is_added = false;  ///< other terms are in its number
};

class LikeTerms {
 public:
  explicit LikeTerms(Context& context) : context_(context) {}

  /// False if there are too many kinds of terms.
  bool add(ExpressionId term) {
    if (node(term).kind == ExpressionKind::add) {
      const std::vector<ExpressionId> operands = node(term).operands;
      return std::ranges::all_of(operands, [this](ExpressionId id) { return add(id); });
    }
    Product product{.term = term};
    multiply(product, term, false);
    const auto like =
        std::ranges::find_if(kinds_, [&](const Product& kind) { return is_like(kind, product); });
    if (like == kinds_.end()) {
      kinds_.push_back(std::move(product));
      return kinds_.size() <= most_kinds;
    }
    like->number = like->number + product.number;
    like->is_added = true;
    return true;
  }

  [[nodiscard]] bool has_any() const { return std::ranges::any_of(kinds_, &Product::is_added); }

  std::vector<ExpressionId> terms() {
    std::vector<ExpressionId> all;
    for (const Product& kind : kinds_) {
      if (kind.number != 0) all.push_back(kind.is_added ? written(kind) : kind.term);
    }
    return all;
  }

 private:
  [[nodiscard]] const Expression& node(ExpressionId id) const {
    return context_.model.expressions[id];
  }

  void multiply(Product& product, ExpressionId id, bool is_divisor) const {
    const Expression& e = node(id);
    if (e.kind == ExpressionKind::number) {
      product.number = is_divisor ? product.number / e.number : product.number * e.number;
    } else if (e.kind == ExpressionKind::negate) {
      product.number = -product.number;
      multiply(product, e.operands.front(), is_divisor);
    } else if (e.kind == ExpressionKind::multiply) {
      for (const ExpressionId factor : e.operands) multiply(product, factor, is_divisor);
    } else if (e.kind == ExpressionKind::divide) {
      multiply(product, e.operands.front(), is_divisor);
      multiply(product, e.operands.back(), !is_divisor);
    } else {
      (is_divisor ? product.divisors : product.factors).push_back(id);
    }
  }

  [[nodiscard]] bool is_same(ExpressionId a, ExpressionId b) const {
    const Expression& x = node(a);
    const Expression& y = node(b);
    return x.kind == y.kind && x.leaf == y.leaf && x.function == y.function && x.index == y.index &&
           x.number == y.number && are_same(x.operands, y.operands);
  }

  [[nodiscard]] bool are_same(const std::vector<ExpressionId>& a,
                              const std::vector<ExpressionId>& b) const {
    return std::ranges::equal(a, b, [this](auto x, auto y) { return is_same(x, y); });
  }

  [[nodiscard]] bool is_like(const Product& x, const Product& y) const {
    return are_same(x.factors, y.factors) && are_same(x.divisors, y.divisors);
  }

  ExpressionId written(const Product& product) {
    NodeBuilder nodes(context_, node(product.term).span);
    std::vector<ExpressionId> factors{nodes.number(product.number)};
    factors.insert(factors.end(), product.factors.begin(), product.factors.end());
    const ExpressionId top = nodes.multiply(factors);
    return product.divisors.empty() ? top : nodes.divide(top, nodes.multiply(product.divisors));
  }

  Context& context_;
  std::vector<Product> kinds_ = {};
};

}  // namespace

std::vector<ExpressionId> with_like_terms_added(Context& context,
                                                const std::vector<ExpressionId>& terms) {
  LikeTerms like(context);
  const bool is_done =
      std::ranges::all_of(terms, [&like](ExpressionId term) { return like.add(term); });
  return is_done && like.has_any() ? like.terms() : terms;
}

}  // namespace elgen
