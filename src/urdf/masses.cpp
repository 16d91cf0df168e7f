// masses: every moving joint must move mass, and every inertia must belong to a rigid body.
#include <fmt/format.h>

#include <algorithm>

#include "elgen/inertia.hpp"
#include "elgen/wording.hpp"
#include "urdf/choices.hpp"
#include "urdf/rotations.hpp"

namespace elgen::urdf {

namespace {

enum class CarriedLinks : unsigned char { all_carried, rigidly_carried };

/// One flag per link: true if the link, or a link that it carries, satisfies `has`. If `behind` is
/// CarriedLinks::rigidly_carried, links behind a moving joint do not count.
std::vector<bool> links_carrying_mass(const Robot& robot, const LinkTree& tree, CarriedLinks behind,
                                      bool (Link::*has)() const = &Link::has_mass) {
  std::vector<bool> massive;
  for (const Link& link : robot.links) massive.push_back((link.*has)());
  for (auto branch = tree.branches.rbegin(); branch != tree.branches.rend(); ++branch) {
    const bool counts = behind == CarriedLinks::all_carried || !robot.joints[branch->joint].moves();
    if (counts && massive[branch->child]) massive[branch->parent] = true;
  }
  return massive;
}

/// One flag per joint: true if it moves mass or turns an inertia.
std::vector<bool> joints_moving_mass(const Robot& robot, const LinkTree& tree,
                                     CarriedLinks behind) {
  const std::vector<bool> massive = links_carrying_mass(robot, tree, behind);
  const std::vector<bool> inert = links_carrying_mass(robot, tree, behind, &Link::has_inertia);
  std::vector<bool> result(robot.joints.size());
  for (const Branch& branch : tree.branches) {
    const JointType type = robot.joints[branch.joint].type;
    const bool turns = type == JointType::revolute || type == JointType::continuous;
    result[branch.joint] = massive[branch.child] || (turns && inert[branch.child]);
  }
  return result;
}

/// One flag per joint: true if its coordinate moves a rotor, or mass behind the joint or behind a
/// joint that mimics it.
std::vector<bool> coordinates_moving_mass(const Robot& robot, const LinkTree& tree) {
  const std::vector<bool> moves = joints_moving_mass(robot, tree, CarriedLinks::all_carried);
  std::vector<bool> result(robot.joints.size());
  for (const Branch& branch : tree.branches) {
    if (moves[branch.joint] || has_rotor(robot.joints[branch.joint])) {
      result[tree.leader(branch.joint)] = true;
    }
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
  if (is_physical_inertia(tensor)) return;
  found.push_back(
      {Code::E508, link.inertial->span,
       fmt::format("inertia {} of {} belongs to no body", listed, quote_text(link.name.text)),
       "a principal inertia exceeds the sum of the other two"});
}

bool are_zero(const auto& numbers) {
  return std::ranges::all_of(numbers, [](const FileNumber& x) { return x.is_zero(); });
}

/// Finds whether a link, with the links fixed to it, has inertia about an axis through its origin.
/// The link has none if all mass is in points on the axis. Mass behind a moving joint counts as
/// inertia, because it may leave the axis. Mass behind a fixed joint that is rotated or off the
/// axis counts, too.
class AxisInertia {
 public:
  AxisInertia(const Robot& robot, const LinkTree& tree, std::size_t axis)
      : robot_(robot),
        tree_(tree),
        axis_(axis),
        massive_(links_carrying_mass(robot, tree, CarriedLinks::all_carried)),
        inert_(links_carrying_mass(robot, tree, CarriedLinks::all_carried, &Link::has_inertia)) {}

  [[nodiscard]] bool carries_mass_or_inertia(std::size_t link) const {
    return massive_[link] || inert_[link];
  }

  [[nodiscard]] bool has_inertia(std::size_t link) const {
    if (robot_.links[link].inertial && resists_turning(*robot_.links[link].inertial)) return true;
    return std::ranges::any_of(tree_.branches, [&](const Branch& branch) {
      if (branch.parent != link || !carries_mass_or_inertia(branch.child)) return false;
      const Joint& joint = robot_.joints[branch.joint];
      const bool stays_on_axis =
          joint.type == JointType::fixed && are_zero(joint.origin.rpy) && is_on_axis(joint.origin);
      return !stays_on_axis || has_inertia(branch.child);
    });
  }

 private:
  [[nodiscard]] bool is_on_axis(const Pose& pose) const {
    return pose.xyz[(axis_ + 1) % 3].is_zero() && pose.xyz[(axis_ + 2) % 3].is_zero();
  }

  [[nodiscard]] bool resists_turning(const Inertial& inertial) const {
    const bool has_inertia = are_zero(inertial.origin.rpy) ? !inertial.inertia[axis_].is_zero()
                                                           : !are_zero(inertial.inertia);
    return has_inertia || (!inertial.mass.is_zero() && !is_on_axis(inertial.origin));
  }

  const Robot& robot_;
  const LinkTree& tree_;
  std::size_t axis_;
  std::vector<bool> massive_;
  std::vector<bool> inert_;
};

/// True if the planar joint has inertia about its normal, or carries neither mass nor inertia.
bool turns_inertia(const Robot& robot, const LinkTree& tree, const Branch& planar) {
  const std::size_t normal =
      *snap_axis(robot.joints[planar.joint].axis, AngleRounding::round).index;
  const AxisInertia about(robot, tree, normal);
  const bool is_rotor_alone = !about.carries_mass_or_inertia(planar.child);
  return is_rotor_alone || about.has_inertia(planar.child);
}

/// `has_mass`: the joint's coordinate moves mass or a rotor. `has_rigid_mass`: the joint moves mass
/// with no other moving joint between the joint and the mass.
struct MovedMass {
  bool has_mass = false;
  bool has_rigid_mass = false;
};

void check_joint(const Robot& robot, const Branch& branch, const MovedMass& moved,
                 Diagnostics& found) {
  const Joint& joint = robot.joints[branch.joint];
  const Link& child = robot.links[branch.child];
  if (!moved.has_mass) {
    const char* const mass = child.inertial
                                 ? "has a `<mass>` of 0, and no link that it carries has mass"
                                 : "has no `<mass>`, nor has any link that it carries";
    found.push_back({Code::E810, joint.name.span,
                     fmt::format("{} moves no mass", quote_text(joint.name.text)),
                     fmt::format("{} {}; `--weld massless` fixes such joints",
                                 quote_text(child.name.text), mass)});
  } else if (!moved.has_rigid_mass) {
    found.push_back({Code::E816, child.name.span,
                     fmt::format("{} moves but has no mass", quote_text(child.name.text))});
  }
}

/// E817 if links with mass are fixed to the root and so never move. No error if the root is called
/// `world`: then this is intended.
void check_world(const Robot& robot, const LinkTree& tree, Diagnostics& found) {
  const Link& root = robot.links[tree.root];
  if (root.name.text == "world") return;
  std::vector<const Link*> held;
  if (root.has_mass()) held.push_back(&root);
  std::vector<bool> is_held(robot.links.size());
  is_held[tree.root] = true;
  for (const Branch& branch : tree.branches) {
    is_held[branch.child] =
        is_held[branch.parent] && robot.joints[branch.joint].type == JointType::fixed;
    const Link& child = robot.links[branch.child];
    if (is_held[branch.child] && child.has_mass()) held.push_back(&child);
  }
  if (held.empty()) return;
  const SpannedText& first = held.front()->name;
  const std::string name = quote_text(first.text);
  const std::string others = count_text(held.size() - 1, "more link");
  found.push_back(
      {Code::E817, first.span,
       held.size() > 1
           ? fmt::format("{} and {} belong to the world: their mass has no effect", name, others)
           : fmt::format("{} belongs to the world: its mass has no effect", name),
       "`--floating-base` lets it move"});
}

}  // namespace

Diagnostics check_masses(const Robot& robot, const LinkTree& tree) {
  Diagnostics found;
  check_world(robot, tree, found);
  for (const Link& link : robot.links) {
    if (link.inertial) check_inertia(link, found);
  }
  const auto moves_mass = coordinates_moving_mass(robot, tree);
  const auto moves_mass_directly = joints_moving_mass(robot, tree, CarriedLinks::rigidly_carried);
  for (const Branch& branch : tree.branches) {
    const bool has_coordinate =
        robot.joints[branch.joint].moves() && !tree.mimicked_joints[branch.joint];
    const MovedMass moved{moves_mass[branch.joint], moves_mass_directly[branch.joint]};
    if (has_coordinate) check_joint(robot, branch, moved, found);
  }
  if (!tree.has_moving_link()) {
    found.push_back({Code::E803, robot.span, "no link of `<robot>` has a `<mass>`"});
  }
  return found;
}

Diagnostics weld_massless_joints(Robot& robot, const LinkTree& tree) {
  Diagnostics found;
  const std::vector<bool> moves_mass = coordinates_moving_mass(robot, tree);
  for (const Branch& branch : tree.branches) {
    Joint& joint = robot.joints[branch.joint];
    if (!joint.moves() || tree.mimicked_joints[branch.joint] || moves_mass[branch.joint]) continue;
    joint.weld_position = FileNumber{};
    found.push_back({Code::E820, joint.name.span,
                     fmt::format("{} is held at 0", quote_text(joint.name.text)),
                     "it moves no mass"});
  }
  for (const Branch& branch : tree.branches) {
    Joint& joint = robot.joints[branch.joint];
    if (joint.type != JointType::planar || joint.weld_position ||
        turns_inertia(robot, tree, branch)) {
      continue;
    }
    joint.is_angle_welded = true;
    found.push_back({Code::E820, joint.name.span,
                     fmt::format("the angle of {} is held at 0", quote_text(joint.name.text)),
                     "it moves no inertia"});
  }
  weld_mimics_of_welded(robot);
  return found;
}

}  // namespace elgen::urdf
