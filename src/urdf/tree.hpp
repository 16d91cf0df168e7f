// LinkTree: the links as a tree, in the order of the model: parents first, otherwise in the order
// of the file.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "urdf/robot.hpp"

namespace elgen::urdf {

struct Branch {
  std::size_t joint = 0;   ///< index in Robot::joints
  std::size_t parent = 0;  ///< indices in Robot::links
  std::size_t child = 0;
  std::size_t depth = 0;   ///< joints between the root and the parent
  bool is_moving = false;  ///< a joint on the path from the root to the child moves
};

struct LinkTree {
  std::size_t root = 0;
  std::vector<Branch> branches = {};
  std::vector<std::optional<std::size_t>> mimicked_joints = {};  ///< by joint: the joint it mimics

  /// The joint at the end of the chain of mimics, whose coordinate all joints of the chain share.
  [[nodiscard]] std::size_t leader(std::size_t joint) const {
    while (mimicked_joints[joint]) joint = *mimicked_joints[joint];
    return joint;
  }
  [[nodiscard]] bool has_moving_link() const {
    return std::ranges::any_of(branches, &Branch::is_moving);
  }
};

/// Returns errors if the links form no tree (E803, E807 to E809) or a mimic is invalid (E812).
[[nodiscard]] Result<LinkTree> make_tree(const Robot& robot);

/// Reports missing or misplaced masses and impossible inertias (E508, E810, E816, E817), and E803
/// if no link moves.
[[nodiscard]] Diagnostics check_masses(const Robot& robot, const LinkTree& tree);

/// Reports E819 if angles or axes were rounded, so that they differ from the file.
[[nodiscard]] Diagnostics report_rounded_angles(const Robot& robot, const LinkTree& tree);

}  // namespace elgen::urdf
