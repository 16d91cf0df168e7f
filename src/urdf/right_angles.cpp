// Bounds on the change of the links' poses if angles are rounded to right angles. The bounds hold
// for all joint positions.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "urdf/tree.hpp"

namespace elgen::urdf {

namespace {

double length(const Vector& xyz) {
  const auto number = [&](std::size_t i) { return clamped_double(xyz[i].value); };
  return std::hypot(number(0), number(1), number(2));
}

/// The change of a pose, in rad and m.
struct PoseChange {
  double angle = 0.0;
  double position = 0.0;
};

class PoseChangeBounds {
 public:
  explicit PoseChangeBounds(const Robot& robot) : robot_(robot), changes_(robot.links.size()) {}

  Diagnostics report_changes(const LinkTree& tree) {
    for (const Branch& branch : tree.branches) {
      add_branch_change(branch);
      const auto& inertial = robot_.links[branch.child].inertial;
      if (!branch.is_moving || !inertial) continue;
      const PoseChange& link = changes_[branch.child];
      update_worst({link.angle + rotation_change(inertial->origin.rpy),
                    link.position + link.angle * length(inertial->origin.xyz)});
    }
    if (count_ == 0) return {};
    return {{Code::E819, robot_.span,
             fmt::format(
                 "{} {} rounded to right angles: no pose changes by more than {:.1e} rad and "
                 "{:.1e} m",
                 count_, count_ == 1 ? "angle is" : "angles are", worst_.angle, worst_.position),
             "`--exact-angles` keeps their digits"}};
  }

 private:
  /// Computes the change of a link's pose from the change of its parent's pose.
  void add_branch_change(const Branch& branch) {
    const Joint& joint = robot_.joints[branch.joint];
    PoseChange change = changes_[branch.parent];
    change.position += change.angle * length(joint.origin.xyz);
    change.angle += rotation_change(joint.origin.rpy);
    if (has_one_coordinate(joint.type)) {
      const Axis axis = snap_axis(joint.axis, robot_.digits);
      count_ += axis.is_rounded ? 1 : 0;
      change.angle += axis.change;
      if (joint.type == JointType::prismatic)
        change.position += change.angle * largest_displacement(joint);
    }
    changes_[branch.child] = change;
    update_worst(change);
  }

  /// A bound in rad on the change of a rotation by rounding; also counts the rounded angles.
  double rotation_change(const Vector& rpy) {
    double change = 0.0;
    for (const Angle& angle : round_rotation(rpy, robot_.digits).rpy) {
      count_ += angle.is_rounded ? 1 : 0;
      change += angle.change;
    }
    return change;
  }

  static double largest_displacement(const Joint& joint) {
    double farthest = 0.0;
    for (const auto& end : {joint.limit.lower, joint.limit.upper, joint.weld_position}) {
      if (end) farthest = std::max(farthest, std::abs(clamped_double(end->value)));
    }
    return farthest;
  }

  void update_worst(const PoseChange& change) {
    worst_.angle = std::max(worst_.angle, change.angle);
    worst_.position = std::max(worst_.position, change.position);
  }

  const Robot& robot_;
  std::vector<PoseChange> changes_;  ///< by link
  PoseChange worst_ = {};
  int count_ = 0;
};

}  // namespace

Diagnostics report_rounded_angles(const Robot& robot, const LinkTree& tree) {
  return PoseChangeBounds(robot).report_changes(tree);
}

}  // namespace elgen::urdf
