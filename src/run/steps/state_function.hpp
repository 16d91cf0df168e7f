// StateFunction: an expression of the model as a function of q, v and t, in double.
#pragma once

#include <vector>

#include "elgen/evaluate.hpp"
#include "elgen/model.hpp"
#include "numbers/dual.hpp"

namespace elgen {

class StateFunction {
 public:
  /// `others` supplies all leaves except q, v and t at every call, and must outlive the function.
  StateFunction(const Model& model, ExpressionId root, const Arguments<double>& others);

  /// Cost: one operation on a value and its rate for each node.
  [[nodiscard]] double operator()(const double* q, const double* v, double t);

 private:
  /// A value and its rate along the motion. The rates of a, u, p and E are unknown (NaN).
  using Rated = Dual<double>;

  [[nodiscard]] Rated value_of(const Expression& node, ExpressionId id) const;
  [[nodiscard]] Rated leaf(const Expression& node) const;
  [[nodiscard]] Rated coordinate(std::uint32_t index) const;
  [[nodiscard]] Rated power(const Rated& base, double exponent) const;

  const Model& model_;
  const Arguments<double>& others_;
  std::vector<ExpressionId> order_;  ///< expressions to evaluate, operands before their users
  std::vector<Rated> known_;         ///< indexed by expression
  ExpressionId result_ = 0;
  const double* q_ = nullptr;
  const double* v_ = nullptr;
  double t_ = 0;
};

}  // namespace elgen
