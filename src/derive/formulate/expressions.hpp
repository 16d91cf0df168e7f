// The Model's expressions as GiNaC expressions over definitions.
#pragma once

#include <optional>
#include <vector>

#include "derive/formulate/chain_rule.hpp"
#include "elgen/lagrangian.hpp"

namespace elgen {

/// Turns expressions of one Model into GiNaC, each once. Whatever grows beyond a small size becomes
/// a definition of its own; named things of the model (definitions, points, prescribed motions)
/// always do.
class Translation {
 public:
  Translation(const Model& model, Lagrangian& lagrangian);

  /// Definitions, prescribed motions and points of the world: under their own names, and with their
  /// errors, whether something uses them or not. Entries of the frames that forces mention: the
  /// tree computes them without asking, and a reader is given their names.
  void define_named();

  /// An expression over definitions. 0 where GiNaC refuses a part of it, E312 or E313, and after
  /// that: the first error is kept.
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

  [[nodiscard]] bool translate(ExpressionId id);
  [[nodiscard]] Sized compose(const Expression& expression);
  [[nodiscard]] Sized leaf(const Expression& expression) const;
  [[nodiscard]] Sized open(const Expression& expression) const;
  [[nodiscard]] Sized component(const Expression& expression);
  [[nodiscard]] Sized sum(const std::vector<ExpressionId>& operands);
  [[nodiscard]] Sized product(const std::vector<ExpressionId>& operands);
  [[nodiscard]] Sized function(const Expression& expression);
  [[nodiscard]] Sized small(const Sized& sized);

  const Model& model_;
  Lagrangian& lagrangian_;
  std::optional<Tangent> along_motion_;  // d/dt of dot(…), of a model with symbols
  std::vector<Sized> translated_;
  Diagnostics errors_ = {};
};

/// A constant expression of the model over no definitions. Exceptions of GiNaC where it has no
/// value.
[[nodiscard]] GiNaC::ex constant_value(const Model& model, ExpressionId value);

/// Whether energies and forces are sums in the world, as an expansion and R need them.
[[nodiscard]] inline bool sums_energies(const Model& model) {
  return model.approximation.has_value() || !model.variant.cyclic.empty();
}

/// The frames of a model as a tree of elementary motions, and what moves with them: fills
/// lagrangian.tree and the twists of its outputs. Steps that move nothing are left out, and
/// so are frames that carry no body, torque, force or output. Where the energies are sums the tree
/// is for outputs only. Errors are those of the translation.
void add_frame_tree(const Model& model, Translation& translation, Lagrangian& lagrangian);

}  // namespace elgen
