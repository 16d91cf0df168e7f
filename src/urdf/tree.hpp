// LinkTree: which link hangs on which, in the order the model is written: parents first, and
// otherwise in the order of the file.
#pragma once

#include <optional>
#include <vector>

#include "urdf/robot.hpp"

namespace elgen::urdf {

struct Branch {
  std::size_t joint = 0;   ///< index in Robot::joints
  std::size_t parent = 0;  ///< indices in Robot::links
  std::size_t child = 0;
  std::size_t depth = 0;                   ///< joints between the root and the parent
  bool moves = false;                      ///< the child moves: a joint on its way to the root does
  std::optional<std::size_t> mimics = {};  ///< the joint it copies, index in Robot::joints
};

struct LinkTree {
  std::size_t root = 0;
  std::vector<Branch> branches = {};
};

/// Not a value where the links are no tree: E807 to E809; E812 for what mimics in vain.
[[nodiscard]] Result<LinkTree> make_tree(const Robot& robot);

/// E508, E810, E816, E817; E803 where nothing moves: masses that are missing, or in the wrong
/// place.
[[nodiscard]] Diagnostics check_masses(const Robot& robot, const LinkTree& tree);

}  // namespace elgen::urdf
