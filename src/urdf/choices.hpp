// Choices: command-line options that select which joints move.
#pragma once

#include "elgen/urdf.hpp"
#include "urdf/tree.hpp"

namespace elgen::urdf {

/// Applies `--joints` and `--weld JOINT[=VALUE]`. E804, E903, E904: VALUE is no valid number. E821:
/// a joint does not exist or cannot be chosen. E820: a joint is held at the limit nearest to 0,
/// because its limits exclude 0.
[[nodiscard]] Diagnostics apply_joint_options(Robot& robot, const ImportOptions& options,
                                              const Limits& limits);

/// Holds the joints that mimic a held joint.
void weld_mimics_of_welded(Robot& robot);

/// True if `--weld massless` is among the options.
[[nodiscard]] bool welds_massless_joints(const ImportOptions& options);

/// Holds each joint that moves no mass, and each angle of a planar joint that turns no inertia, at
/// the position 0. Returns E820 for each held joint and angle.
[[nodiscard]] Diagnostics weld_massless_joints(Robot& robot, const LinkTree& tree);

/// Adds a new root link, and a joint `base` of type floating from the new link to `root`.
void add_floating_joint(Robot& robot, std::size_t root);

/// The floating joint by which the robot already floats: its parent is the root or is fixed to the
/// root. Null if there is none, or if the root or a link fixed to the root has mass.
[[nodiscard]] const Joint* find_floating_joint(const Robot& robot, const LinkTree& tree);

}  // namespace elgen::urdf
