// Variables of the tree.
#include "derive/tree/tree_variables.hpp"

#include <algorithm>

namespace elgen {

using GiNaC::ex;

namespace {

bool moves(const Tree& tree, const ex& value) {
  return dependence(tree.derivation().definitions, value).has_any(Opcode::coordinate);
}

void append_variables(const Tree& tree, std::uint32_t index, TreeVariables& variables) {
  const TreeStep& step = tree.step(index);
  TreeVariable variable;
  variable.step = index;
  if (step.kind == FrameStepKind::turn) {
    if (!moves(tree, step.angle)) return;
    variable.spin = step.vector;
    variable.value = step.angle;
    variables.list.push_back(variable);
    return;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    TreeVariable component = variable;
    if (step.kind == FrameStepKind::translation) {
      if (!moves(tree, step.vector[i])) continue;
      component.velocity[i] = 1;
      component.value = step.vector[i];
    } else if (step.rotation) {
      component.spin[i] = 1;
      component.velocity_index = *step.rotation + static_cast<std::uint32_t>(i);
    } else {
      continue;
    }
    variables.list.push_back(component);
  }
  if (step.kind != FrameStepKind::quaternion || step.rotation) return;
  variables.is_complete =
      variables.is_complete && std::none_of(step.quaternion.begin(), step.quaternion.end(),
                                            [&](const ex& q) { return moves(tree, q); });
}

}  // namespace

TreeVariables tree_variables(const Tree& tree) {
  TreeVariables variables;
  for (std::uint32_t k = 0; k < tree.size(); ++k) append_variables(tree, k, variables);
  return variables;
}

std::vector<Coefficient> jacobian_row(Tree& tree, const TreeVariable& variable) {
  if (variable.velocity_index) return {{*variable.velocity_index, 1}};
  const Vector row = tree.derivation().by_position({{variable.value, 1}});
  std::vector<Coefficient> result;
  for (std::size_t j = 0; j < row.size(); ++j) {
    if (!row[j].is_zero()) result.push_back({j, tree.algebra.define(row[j])});
  }
  return result;
}

bool is_constant(const Definitions& definitions, const std::vector<Coefficient>& row) {
  return std::all_of(row.begin(), row.end(), [&](const Coefficient& c) {
    return !dependence(definitions, c.value).has_any(Opcode::coordinate | Opcode::time);
  });
}

}  // namespace elgen
