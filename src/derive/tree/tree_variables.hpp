// What moves a tree: its angles, the components of its offsets, and the velocities of rotations.
#pragma once

#include "derive/tree/tree.hpp"

namespace elgen {

/// A unit twist (angular; linear) in the axes after a step.
struct TreeVariable {
  std::uint32_t step = 0;
  ExVector3 spin{0, 0, 0};
  ExVector3 velocity{0, 0, 0};
  GiNaC::ex value = 0;                               ///< x(q, t)
  std::optional<std::uint32_t> velocity_index = {};  ///< of a rotation instead of x
};

/// One entry of dx/dq.
struct Coefficient {
  std::size_t velocity = 0;
  GiNaC::ex value = 0;
};

/// Those that depend on coordinates, steps ascending. Quaternions written over coordinates have
/// none: `is_complete` is false then, and matrices are derived from forces instead.
struct TreeVariables {
  std::vector<TreeVariable> list = {};
  bool is_complete = true;
};

[[nodiscard]] TreeVariables tree_variables(const Tree& tree);

/// dx/dq without its zeros.
[[nodiscard]] std::vector<Coefficient> jacobian_row(Tree& tree, const TreeVariable& variable);

/// Whether no entry of any row depends on coordinates or time.
[[nodiscard]] bool is_constant(const Definitions& definitions, const std::vector<Coefficient>& row);

}  // namespace elgen
