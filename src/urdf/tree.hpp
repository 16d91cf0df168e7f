// LinkTree: which link hangs on which, in the order the model is written: parents first, and
// otherwise in the order of the file.
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
  std::size_t depth = 0;  ///< joints between the root and the parent
  bool moves = false;     ///< the child moves: a joint on its way to the root does
};

struct LinkTree {
  std::size_t root = 0;
  std::vector<Branch> branches = {};
  std::vector<std::optional<std::size_t>> mimicked = {};  ///< by joint: the joint it mimics

  /// The joint at the end of a chain of mimics, whose coordinate is shared.
  [[nodiscard]] std::size_t leader(std::size_t joint) const {
    while (mimicked[joint]) joint = *mimicked[joint];
    return joint;
  }
  [[nodiscard]] bool has_moving_link() const {
    return std::ranges::any_of(branches, &Branch::moves);
  }
};

/// Fails unless the links form a tree (E807 to E809), or if a joint mimics in vain (E812).
[[nodiscard]] Result<LinkTree> make_tree(const Robot& robot);

/// E508, E810, E816, E817; E803 where nothing moves: masses that are missing, or in the wrong
/// place.
[[nodiscard]] Diagnostics check_masses(const Robot& robot, const LinkTree& tree);

/// E819, where angles or axes are not those of the file.
[[nodiscard]] Diagnostics note_right_angles(const Robot& robot, const LinkTree& tree);

}  // namespace elgen::urdf
