// masses: whatever joints move must have mass, and an inertia that a rigid body can have.
#include <fmt/format.h>

#include "elgen/inertia.hpp"
#include "elgen/wording.hpp"
#include "urdf/tree.hpp"

namespace elgen::urdf {

namespace {

/// Whether a link, or one behind it, has mass; by link.
std::vector<bool> massive_subtrees(const Robot& robot, const LinkTree& tree) {
  std::vector<bool> massive;
  for (const Link& link : robot.links) massive.push_back(link.has_mass());
  for (auto branch = tree.branches.rbegin(); branch != tree.branches.rend(); ++branch) {
    if (massive[branch->child]) massive[branch->parent] = true;
  }
  return massive;
}

/// Whether a joint's coordinate moves mass: behind itself, or behind a joint that mimics it; by
/// joint.
std::vector<bool> joints_with_mass(const Robot& robot, const LinkTree& tree,
                                   const std::vector<bool>& massive) {
  std::vector<bool> result(robot.joints.size());
  for (const Branch& branch : tree.branches) {
    if (massive[branch.child]) result[branch.mimics.value_or(branch.joint)] = true;
  }
  return result;
}

void check_inertia(const Link& link, Diagnostics& found) {
  const auto& numbers = link.inertial->inertia;
  InertiaTensor tensor;
  std::string listed;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    tensor[i] = numbers[i].value;
    listed += (i == 0 ? "" : ", ") + numbers[i].text;
  }
  if (is_of_a_body(tensor)) return;
  found.push_back(
      {Code::E508, link.inertial->span,
       fmt::format("inertia {} of {} belongs to no body", listed, in_backticks(link.name.text)),
       "a principal inertia exceeds the sum of the other two"});
}

void check_joint(const Robot& robot, const Branch& branch, bool moves_mass, Diagnostics& found) {
  const Joint& joint = robot.joints[branch.joint];
  const Link& child = robot.links[branch.child];
  if (joint.type == JointType::fixed || branch.mimics) return;
  if (!moves_mass) {
    found.push_back({Code::E810, joint.name.span,
                     fmt::format("{} moves no mass", in_backticks(joint.name.text)),
                     fmt::format("{} has no `<inertial>`, nor has a link behind it",
                                 in_backticks(child.name.text))});
  } else if (!child.has_mass()) {
    found.push_back({Code::E816, child.name.span,
                     fmt::format("{} moves without a mass", in_backticks(child.name.text))});
  }
}

}  // namespace

Diagnostics check_masses(const Robot& robot, const LinkTree& tree) {
  Diagnostics found;
  const Link& root = robot.links[tree.root];
  if (root.has_mass()) {
    found.push_back(
        {Code::E817, root.name.span,
         fmt::format("{} is the world: its mass plays no part", in_backticks(root.name.text))});
  }
  for (const Link& link : robot.links) {
    if (link.inertial) check_inertia(link, found);
  }
  const auto moves_mass = joints_with_mass(robot, tree, massive_subtrees(robot, tree));
  bool has_coordinate = false;
  for (const Branch& branch : tree.branches) {
    check_joint(robot, branch, moves_mass[branch.joint], found);
    has_coordinate = has_coordinate || branch.moves;
  }
  if (!has_coordinate) {
    found.push_back({Code::E803, robot.span, "`<robot>` has no `<joint>` that moves"});
  }
  return found;
}

}  // namespace elgen::urdf
