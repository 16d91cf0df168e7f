// Terms are products of a number and factors; factors are compared node by node.
#include "check/expressions/like_terms.hpp"

#include <algorithm>

#include "check/expressions/node_builder.hpp"

namespace elgen {

/// Terms of a sum are written by one text, so there are few kinds of them or as many as terms.
constexpr std::size_t most_kinds = 16;

void LikeTerms::add(ExpressionId term, std::size_t begin) {
  const bool is_tried = kinds_.size() <= most_kinds;
  if (is_tried && add_products(term)) return context_.truncate(begin);
  terms_.push_back(term);
  if (!is_tried) others_.push_back(term);
}

/// False if there is a product without a like one.
bool LikeTerms::add_products(ExpressionId term) {
  if (node(term).kind == ExpressionKind::add) {
    bool is_in_numbers = true;
    for (const ExpressionId operand : std::vector(node(term).operands)) {
      is_in_numbers = add_products(operand) && is_in_numbers;
    }
    return is_in_numbers;
  }
  Product product{.term = term};
  multiply(product, term, false);
  const auto like = std::ranges::find_if(kinds_, [&](const Product& kind) {
    return are_same(kind.factors, product.factors) && are_same(kind.divisors, product.divisors);
  });
  if (like == kinds_.end()) {
    kinds_.push_back(std::move(product));
    return false;
  }
  like->number = like->number + product.number;
  like->is_added = true;
  return true;
}

std::vector<ExpressionId> LikeTerms::terms() {
  if (std::ranges::none_of(kinds_, &Product::is_added)) return terms_;
  std::vector<ExpressionId> all;
  for (const Product& kind : kinds_) {
    if (kind.number != 0) all.push_back(kind.is_added ? written(kind) : kind.term);
  }
  all.insert(all.end(), others_.begin(), others_.end());
  return all;
}

void LikeTerms::multiply(Product& product, ExpressionId id, bool is_divisor) const {
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

bool LikeTerms::are_same(const std::vector<ExpressionId>& a,
                         const std::vector<ExpressionId>& b) const {
  return std::ranges::equal(a, b, [this](ExpressionId i, ExpressionId k) {
    const Expression& x = node(i);
    const Expression& y = node(k);
    return x.kind == y.kind && x.leaf == y.leaf && x.function == y.function && x.index == y.index &&
           x.number == y.number && are_same(x.operands, y.operands);
  });
}

ExpressionId LikeTerms::written(const Product& product) {
  NodeBuilder nodes(context_, node(product.term).span);
  std::vector<ExpressionId> factors{nodes.number(product.number)};
  factors.insert(factors.end(), product.factors.begin(), product.factors.end());
  const ExpressionId top = nodes.multiply(factors);
  return product.divisors.empty() ? top : nodes.divide(top, nodes.multiply(product.divisors));
}

}  // namespace elgen
