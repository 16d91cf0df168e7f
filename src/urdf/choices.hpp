// Choices: command-line options that select which joints move.
#pragma once

#include "elgen/urdf.hpp"
#include "urdf/tree.hpp"

namespace elgen::urdf {

/// Applies `--joints` and `--weld JOINT[=VALUE]`. E821: an unknown joint, or a joint that does not
/// move; E804. E820: the limits of a joint exclude 0, so it is held at the nearest limit.
[[nodiscard]] Diagnostics choose_joints(Robot& robot, const ImportOptions& options,
                                        const Limits& limits);

/// Holds the joints that mimic a held joint.
void weld_followers(Robot& robot);

/// Whether `--weld massless` is among the options.
[[nodiscard]] bool welds_massless(const ImportOptions& options);

/// Holds at 0 the joints that move no mass: E820.
[[nodiscard]] Diagnostics weld_massless(Robot& robot, const LinkTree& tree);

/// Adds a new root link, and a joint `base` of type floating from it to `root`.
void add_floating_joint(Robot& robot, std::size_t root);

/// The floating joint by which the robot already floats: its parent is the root or is fixed to it,
/// and these links have no mass. Null if there is none.
[[nodiscard]] const Joint* floating_joint(const Robot& robot, const LinkTree& tree);

}  // namespace elgen::urdf
