// StateFunction: an expression of the model as a function of q, v and t, in double.
#pragma once

#include <vector>

#include "elgen/evaluate.hpp"
#include "elgen/model.hpp"
#include "numbers/dual.hpp"

namespace elgen {

class StateFunction {
 public:
  /// `others` gives the values of all leaves except q, v and t. Every call reads `others`, which
  /// must outlive this object.
  StateFunction(const Model& model, ExpressionId root, const Arguments<double>& others);

  /// Cost: for each node, one operation on a value and its time derivative.
  [[nodiscard]] double operator()(const double* q, const double* v, double t);

 private:
  /// A value and its time derivative along the motion; the derivatives of a, u, p and E are unknown
  /// (NaN).
  using ValueWithRate = Dual<double>;

  [[nodiscard]] ValueWithRate node_value(const Expression& node, ExpressionId id) const;
  [[nodiscard]] ValueWithRate leaf_value(const Expression& node) const;
  [[nodiscard]] ValueWithRate coordinate_value(std::uint32_t index) const;
  [[nodiscard]] ValueWithRate power(const ValueWithRate& base, double exponent) const;

  const Model& model_;
  const Arguments<double>& others_;
  std::vector<ExpressionId> order_;   ///< expressions to evaluate, operands first
  std::vector<ValueWithRate> known_;  ///< values, indexed by expression
  ExpressionId result_ = 0;
  const double* q_ = nullptr;
  const double* v_ = nullptr;
  double t_ = 0;
};

}  // namespace elgen
