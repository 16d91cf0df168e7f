// Evaluation: values of expressions and their time derivatives along the motion, as jets. Values
// are computed on demand, with their operands.
//
// The time uses the generators e_1, e_2, ... after the first 8. With s = e_1 + ... + e_k (k the
// time order of an expression),
//
//     q(s) = q + v s + a s^2/2,    v(s) = v + a s,    t(s) = t + s,
//
// and e + 1/2 e w s + 1/2 (1/4 e w w + 1/2 e dw/dt) s^2 for a quaternion e at angular velocity w,
// in quaternion products. The coefficients of e_1 and e_1 e_2 are d/dt and d2/dt2 along the motion.
//
// An open function at x + d, d nilpotent, is f + f_i d_i + 1/2 f_ij d_i d_j. The state supplies f,
// f_i and f_ij.
#pragma once

#include <list>
#include <memory>
#include <optional>
#include <vector>

#include "elgen/leaves.hpp"
#include "elgen/model.hpp"
#include "oracle/jet.hpp"

namespace elgen::oracle {

/// A state whose entries may carry directions of differentiation: generators 0 to 7. The Routhian
/// uses 6 and 7.
using Motion = LeafValues<Jet>;

class Evaluation {
 public:
  /// Evaluations at one state share `functions`, which memoises function values.
  Evaluation(const Model& model, const Motion& motion,
             std::shared_ptr<JetFunctions> functions = std::make_shared<JetFunctions>());

  [[nodiscard]] const Model& model() const { return model_; }
  [[nodiscard]] const Motion& motion() const { return motion_; }

  [[nodiscard]] Jet value(ExpressionId expression);

  /// d/dt along the motion.
  [[nodiscard]] Jet rate(ExpressionId expression);

  /// d2/dt2 along the motion, at constant acceleration.
  [[nodiscard]] Jet second_rate(ExpressionId expression);

 private:
  /// A value with the first `time_order` time generators.
  struct MemoisedValue {
    Jet value;
    unsigned time_order = 0;
  };

  [[nodiscard]] bool is_known(ExpressionId id, unsigned time_order) const;
  [[nodiscard]] Jet evaluate(ExpressionId root, unsigned time_order);
  Jet evaluate_operation(const Expression& e, unsigned time_order);
  Jet leaf_value(const Expression& e, unsigned time_order) const;
  [[nodiscard]] Jet open_value(const Expression& e, unsigned time_order) const;
  [[nodiscard]] Jet coordinate_at(std::uint32_t index, const Jet& s) const;
  Jet sum_or_product(const Expression& e, unsigned time_order) const;
  Jet function_value(const Expression& e, unsigned time_order);
  [[nodiscard]] Jet memoised_value(ExpressionId id, unsigned time_order) const;

  const Model& model_;
  const Motion& motion_;
  std::shared_ptr<JetFunctions> functions_;
  std::vector<std::optional<MemoisedValue>> memoised_values_;  ///< indexed by expression
};

/// The evaluations at the latest `count` motions of one model; all motions have the same
/// parameters. Energies and forces at one motion share an evaluation, which computes common
/// subexpressions once.
class RecentEvaluations {
 public:
  RecentEvaluations(const Model& model, std::size_t count);

  /// The evaluation at `motion`, valid until `count` other motions follow.
  [[nodiscard]] Evaluation& at(const Motion& motion);

 private:
  struct Entry {
    Entry(const Model& model, Motion of, const std::shared_ptr<JetFunctions>& functions);
    Entry(const Entry&) = delete;
    Entry& operator=(const Entry&) = delete;

    Motion motion;
    Evaluation evaluation;  ///< refers to `motion`
  };

  const Model& model_;
  std::size_t count_;
  std::shared_ptr<JetFunctions> functions_ = std::make_shared<JetFunctions>();
  std::list<Entry> entries_ = {};  ///< the latest first
};

}  // namespace elgen::oracle
