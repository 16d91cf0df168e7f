// The Model's expressions as GiNaC expressions over definitions.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "elgen/lagrangian.hpp"
#include "formulate/chain_rule.hpp"

namespace elgen {

/// Turns expressions of one Model into GiNaC, each once. Whatever grows beyond a small size becomes
/// a definition of its own; named things of the model (definitions, points, prescribed motions)
/// always do.
class Translation {
 public:
  Translation(const Model& model, Lagrangian& lagrangian);

  /// Every named thing of the model, in the order in which they need each other.
  [[nodiscard]] Diagnostics define_named();

  /// `value` as an expression over definitions; errors (E312, E313) come with the span of what
  /// GiNaC refused.
  [[nodiscard]] Result<GiNaC::ex> operator()(ExpressionId value);

  /// The same; 0 where it has errors, which are kept.
  [[nodiscard]] GiNaC::ex value(ExpressionId id);
  [[nodiscard]] const Diagnostics& errors() const { return errors_; }

  /// One symbol for the value, so that what uses it stays small.
  [[nodiscard]] GiNaC::ex named(ExpressionId id, const std::string& name, Entity origin);
  /// name_x, name_y, name_z
  [[nodiscard]] ExVector3 vector(const Vector3& values, const std::string& name, Entity origin);

 private:
  struct Sized {
    GiNaC::ex value;
    unsigned size = 0;  ///< leaves and operations written out in `value`; 0: not translated yet
  };

  void translate(ExpressionId id);
  [[nodiscard]] Sized compose(const Expression& expression);
  [[nodiscard]] Sized leaf(const Expression& expression) const;
  [[nodiscard]] Sized sum(const std::vector<ExpressionId>& operands);
  [[nodiscard]] Sized product(const std::vector<ExpressionId>& operands);
  [[nodiscard]] Sized function(const Expression& expression);
  [[nodiscard]] Sized small(const Sized& sized);
  [[nodiscard]] Diagnostics define_entity(const Entity& entity);
  [[nodiscard]] Diagnostics define_point(std::uint32_t index);
  [[nodiscard]] Diagnostics define_frame(std::uint32_t index);

  const Model& model_;
  Lagrangian& lagrangian_;
  std::optional<Tangent> along_motion_;  // d/dt of dot(…)
  std::vector<Sized> translated_;
  using Defined = std::optional<GiNaC::ex>;  // none until define_named() reaches it
  std::vector<Defined> definitions_;
  std::vector<Defined> prescribed_;
  std::vector<std::array<Defined, 3>> points_;
  std::vector<std::array<Defined, components_per_frame>> frames_;
  Diagnostics errors_ = {};
};

/// A constant expression of the model over no definitions. Exceptions of GiNaC where it has no
/// value.
[[nodiscard]] GiNaC::ex constant_value(const Model& model, ExpressionId value);

}  // namespace elgen
