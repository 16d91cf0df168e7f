// Like terms of a sum that `sum(i, low, high, ...)` writes out.
#pragma once

#include <vector>

#include "check/names/context.hpp"

namespace elgen {

/// Adds terms that differ in a rational factor only:
///
///     1*k*x + 2*k*x + 3*k*x + y   ->   6*k*x + y
///
/// Otherwise each of ten thousand terms would be differentiated and compared for itself. Terms
/// without a like one stay the nodes that they are.
class LikeTerms {
 public:
  explicit LikeTerms(Context& context) : context_(context) {}

  /// Takes a term, and forgets its nodes, which are those from `begin` on, if they are not needed.
  void add(ExpressionId term, std::size_t begin);

  /// The operands of the sum.
  [[nodiscard]] std::vector<ExpressionId> terms();

 private:
  /// number * factors / divisors
  struct Product {
    ExpressionId term = 0;
    cln::cl_RA number = 1;
    std::vector<ExpressionId> factors = {};
    std::vector<ExpressionId> divisors = {};
    bool is_added = false;  ///< other terms are in its number
  };

  [[nodiscard]] const Expression& node(ExpressionId id) const {
    return context_.model.expressions[id];
  }
  bool add_products(ExpressionId term);
  void multiply(Product& product, ExpressionId id, bool is_divisor) const;
  [[nodiscard]] bool are_same(const std::vector<ExpressionId>& a,
                              const std::vector<ExpressionId>& b) const;
  ExpressionId written(const Product& product);

  Context& context_;
  std::vector<ExpressionId> terms_ = {};  ///< those whose nodes are kept
  std::vector<Product> kinds_ = {};
  std::vector<ExpressionId> others_ = {};  ///< terms beyond so many kinds
};

}  // namespace elgen
