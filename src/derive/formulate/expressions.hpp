// Translation of a Model's expressions to GiNaC expressions over definitions.
#pragma once

#include <optional>
#include <vector>

#include "derive/formulate/chain_rule.hpp"
#include "elgen/lagrangian.hpp"

namespace elgen {

/// Translates each expression of a Model once. A result beyond a small size becomes a definition;
/// named entries of the model (definitions, points, prescribed motions) always become definitions.
class ExpressionTranslator {
 public:
  ExpressionTranslator(const Model& model, Lagrangian& lagrangian);

  /// Translates all definitions, prescribed motions and points outside frames under their names, so
  /// that errors in unused entries are reported. If the model is expanded, also points in frames.
  /// Also names the poses of the frames that forces refer to, because the tree computes the same
  /// values without names.
  void define_named_entries();

  /// The translated expression. If GiNaC rejects a part of the expression, the error (E312 or E313)
  /// is added to errors(), and this call and all later calls return 0.
  [[nodiscard]] GiNaC::ex value(ExpressionId id);
  [[nodiscard]] const Diagnostics& errors() const { return errors_; }

  /// Defines the value under `name`. Returns the symbol, which keeps later expressions small.
  [[nodiscard]] GiNaC::ex define_value(ExpressionId id, const std::string& name, Entity origin);
  /// Defines the three components. Returns the symbols name_x, name_y, name_z.
  [[nodiscard]] ExVector3 define_vector(const Vector3& values, const std::string& name,
                                        Entity origin);

 private:
  struct SizedExpression {
    GiNaC::ex value;
    unsigned size = 0;  ///< number of leaves and operations in `value`; 0: not translated yet
  };

  [[nodiscard]] bool translate(ExpressionId id);
  [[nodiscard]] SizedExpression translate_operation(const Expression& expression);
  [[nodiscard]] SizedExpression translate_leaf(const Expression& expression) const;
  [[nodiscard]] SizedExpression translate_open_value(const Expression& expression) const;
  [[nodiscard]] SizedExpression define_component(const Expression& expression);
  [[nodiscard]] SizedExpression translate_sum(const std::vector<ExpressionId>& operands);
  [[nodiscard]] SizedExpression translate_product(const std::vector<ExpressionId>& operands);
  [[nodiscard]] SizedExpression translate_call(const Expression& expression);
  [[nodiscard]] SizedExpression define_if_large(const SizedExpression& sized);

  const Model& model_;
  Lagrangian& lagrangian_;
  std::optional<Tangent> motion_rate_;  // d/dt for dot(…); set by define_named_entries()
  std::vector<SizedExpression> translated_values_;
  Diagnostics errors_ = {};
};

/// A constant expression of the model, without definitions. Throws std::domain_error if it has no
/// value.
[[nodiscard]] GiNaC::ex constant_value(const Model& model, ExpressionId value);

/// True if an expansion or [routh] needs energies and forces as sums in world coordinates.
[[nodiscard]] inline bool needs_energy_sums(const Model& model) {
  return model.approximation.has_value() || !model.reduction.cyclic.empty();
}

/// Fills lagrangian.tree (transforms, bodies, wrenches) and the twists of the outputs. Omits
/// identity transforms, and frames whose subtree has no body, torque, force or output. If
/// needs_energy_sums(), only outputs use the tree. Errors are kept in translation.errors().
void add_frame_tree(const Model& model, ExpressionTranslator& translation, Lagrangian& lagrangian);

}  // namespace elgen
