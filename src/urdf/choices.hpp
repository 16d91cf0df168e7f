// Choices: which joints move, as options of the command line say.
#pragma once

#include "elgen/urdf.hpp"
#include "urdf/tree.hpp"

namespace elgen::urdf {

/// `--joints` and `--weld JOINT[=VALUE]`. E821: a joint that is not there, or does not move; E804.
/// E820: a joint that limits do not let be held at 0.
[[nodiscard]] Diagnostics choose_joints(Robot& robot, const ImportOptions& options,
                                        const Limits& limits);

/// Joints that mimic a held joint are held as well.
void weld_followers(Robot& robot);

/// Whether `--weld massless` is among the options.
[[nodiscard]] bool welds_massless(const ImportOptions& options);

/// Holds joints that move no mass at 0: E820.
[[nodiscard]] Diagnostics weld_massless(Robot& robot, const LinkTree& tree);

/// Adds a joint `base` of type floating from a new root link to `root`.
void let_float(Robot& robot, std::size_t root);

/// The joint by which a base without mass floats already.
[[nodiscard]] const Joint* floating_joint(const Robot& robot, const LinkTree& tree);

}  // namespace elgen::urdf
