// Evaluation: the values, and rates along the motion, of scheduled expressions on jets.
//
// Time is one more set of generators: with s = e_1 + ... + e_k (k the time order of an expression),
//
//     q(s) = q + v s + a s^2/2,    v(s) = v + a s,    t(s) = t + s,
//
// (a quaternion e: e + 1/2 e w s + 1/2 (1/4 e w w + 1/2 e dw/dt) s^2, products of quaternions),
// so that the coefficient of e_1 is d/dt along the motion and that of e_1 e_2 is d2/dt2.
#pragma once

#include <vector>

#include "elgen/leaves.hpp"
#include "elgen/model.hpp"
#include "oracle/jet.hpp"
#include "oracle/jet_functions.hpp"
#include "oracle/schedule.hpp"

namespace elgen::oracle {

/// A state whose entries may carry directions of differentiation, generators 0 to 7.
using Motion = LeafValues<Jet>;

class Evaluation {
 public:
  /// Cost: one operation on jets per scheduled expression.
  Evaluation(const Model& model, const Schedule& schedule, const Motion& motion,
             JetFunctions& functions);

  [[nodiscard]] Jet value(ExpressionId expression) const;

  /// d/dt along the motion; the root's time order must be at least 1.
  [[nodiscard]] Jet rate(ExpressionId expression) const;

  /// d2/dt2 along the motion with constant acceleration; time order at least 2.
  [[nodiscard]] Jet second_rate(ExpressionId expression) const;

 private:
  Jet evaluated(const Expression& e, unsigned time_order);
  Jet leaf(const Expression& e, unsigned time_order) const;
  [[nodiscard]] Jet position(std::uint32_t index, const Jet& s) const;
  Jet folded(const Expression& e, unsigned time_order) const;
  Jet function(const Expression& e, unsigned time_order);
  [[nodiscard]] Jet operand(ExpressionId id, unsigned time_order) const;

  const Model& model_;
  const Schedule& schedule_;
  const Motion& motion_;
  JetFunctions& functions_;
  std::vector<Jet> values_ = {};
};

}  // namespace elgen::oracle
