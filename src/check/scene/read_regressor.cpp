// read_regressor: the parameters for which the regressor has columns. All forces must be affine in
// these parameters.
#include <fmt/format.h>

#include <algorithm>

#include "base/report.hpp"
#include "check/expressions/parameters.hpp"
#include "check/scene/scene.hpp"
#include "elgen/inertial_parameters.hpp"
#include "elgen/references.hpp"

namespace elgen {
namespace {

/// True for energies and forces: a parameter of the regressor may occur only in these terms of tau.
bool is_energy_or_force(const Root& root) {
  return root.entity.kind == EntityKind::energy || root.entity.kind == EntityKind::force;
}

class RegressorReader {
 public:
  RegressorReader(Context& context, const FixedParameters& fixed)
      : context_(context), fixed_(fixed) {}

  void read(const ValueSyntax* names) {
    regressed_parameters() = friction_parameters(context_.model);
    std::erase_if(regressed_parameters(), [&](std::uint32_t i) { return fixed_.count(i) > 0; });
    if (names == nullptr) return;
    for (const ValueSyntax& name : names->items) {
      const std::string text(covered_text(name.expression.span));
      for (const std::uint32_t i : find_parameters(context_, text, name.expression.span, "")) {
        add_regressed_parameter(i, name.expression.span);
      }
    }
  }

 private:
  [[nodiscard]] std::vector<std::uint32_t>& regressed_parameters() {
    return context_.model.affine_parameters;
  }

  void report_regressor_error(const Span& span, const std::string& reason) {
    context_.report.add(Code::E649, span, reason);
  }

  void add_regressed_parameter(std::uint32_t parameter, const Span& span) {
    const Model& model = context_.model;
    const std::string name = quote_text(model.parameters[parameter].name);
    if (fixed_.count(parameter) > 0) {
      return report_regressor_error(span, name + " is fixed, so it is no parameter of the code");
    }
    if (std::ranges::count(regressed_parameters(), parameter) > 0) return;
    if (occurs_elsewhere(parameter)) {
      return report_regressor_error(
          span, name +
                    " occurs in a mass, an inertia, a position, gravity or a constraint, "
                    "not only in energies and forces");
    }
    regressed_parameters().push_back(parameter);
    for (const ExpressionId root : filter_roots(model, is_energy_or_force)) {
      const auto coupled = find_coupled_parameters(model, root, regressed_parameters());
      if (!coupled) continue;
      regressed_parameters().pop_back();
      const auto other = [&](std::uint32_t i) { return quote_text(model.parameters[i].name); };
      const std::string reason =
          coupled->first == coupled->second
              ? fmt::format("forces are not affine in {}", other(coupled->first))
              : fmt::format("forces have a product of {} and {}", other(coupled->first),
                            other(coupled->second));
      return report_regressor_error(span, reason);
    }
  }

  [[nodiscard]] bool occurs_elsewhere(std::uint32_t parameter) const {
    const Model& model = context_.model;
    std::vector<ExpressionId> others = equation_roots(model);
    for (const ExpressionId root : filter_roots(model, is_energy_or_force))
      std::erase(others, root);
    return std::ranges::any_of(reachable_expressions(model, others), [&](ExpressionId id) {
      const Expression& e = model.expressions[id];
      return is_leaf(e, Opcode::parameter) && e.index == parameter;
    });
  }

  Context& context_;
  const FixedParameters& fixed_;
};

}  // namespace

void read_regressor(Context& context, const FileSyntax* scene, const FixedParameters& fixed) {
  const KeySyntax* const names = find_key(scene, "regressor", "parameters");
  RegressorReader(context, fixed).read(names == nullptr ? nullptr : &names->value);
}

}  // namespace elgen
