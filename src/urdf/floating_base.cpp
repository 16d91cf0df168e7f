// A robot that nothing holds: its root link gets a joint of type floating, from a new root.
#include <algorithm>

#include "urdf/choices.hpp"

namespace elgen::urdf {

namespace {

/// `wanted`, or with a number behind it where an element is called so.
template <class Named>
std::string free_name(const std::vector<Named>& elements, const std::string& wanted) {
  std::string name = wanted;
  const auto is_taken = [&](const Named& element) { return element.name.text == name; };
  for (int i = 2; std::ranges::any_of(elements, is_taken); ++i) {
    name = wanted + "_" + std::to_string(i);
  }
  return name;
}

}  // namespace

void let_float(Robot& robot, std::size_t root) {
  const Text base = robot.links[root].name;
  const Text world{free_name(robot.links, "world"), base.span};
  Joint joint;
  joint.name = {free_name(robot.joints, "base"), base.span};
  joint.type = JointType::floating;
  joint.parent = world;
  joint.child = base;
  robot.links.push_back({world, {}});
  robot.joints.push_back(std::move(joint));
}

const Joint* floating_joint(const Robot& robot, const LinkTree& tree) {
  std::vector<bool> is_base(robot.links.size());
  is_base[tree.root] = true;
  const Joint* floating = nullptr;
  bool base_has_mass = robot.links[tree.root].has_mass();
  for (const Branch& branch : tree.branches) {
    const Joint& joint = robot.joints[branch.joint];
    if (!is_base[branch.parent]) continue;
    if (joint.moves()) {
      if (joint.type == JointType::floating) floating = &joint;
      continue;
    }
    is_base[branch.child] = true;
    base_has_mass = base_has_mass || robot.links[branch.child].has_mass();
  }
  return base_has_mass ? nullptr : floating;
}

}  // namespace elgen::urdf
