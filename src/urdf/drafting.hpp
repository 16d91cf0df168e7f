// The parts of make_draft(): each adds what one joint or link is in the model.
#pragma once

#include "urdf/draft.hpp"
#include "urdf/expressions.hpp"
#include "urdf/glossary.hpp"
#include "urdf/rotations.hpp"

namespace elgen::urdf {

struct Drafting {
  const Robot& robot;
  Glossary& glossary;
  Draft& draft;
};

/// How a joint moves, in the axes of its origin.
struct JointMotion {
  Components translate = {"0", "0", "0"};
  std::vector<AxisAngle> turn = {};  ///< at most one
  std::string attitude = {};         ///< a coordinate of kind rotation
};

/// "x" of 0, "y" of 1, "z" of 2.
[[nodiscard]] std::string axis_letter(std::size_t axis);

/// Adds the coordinates, inputs, damping and friction of a joint.
[[nodiscard]] JointMotion draft_joint(Drafting& drafting, const Branch& branch);

/// Constant turns, z y x: R = Rz(yaw) Ry(pitch) Rx(roll).
[[nodiscard]] std::vector<AxisAngle> steps_of(const RollPitchYaw& rotation);

/// "rpy in the URDF: 1.57079632679 0 0" where angles were rounded.
[[nodiscard]] std::vector<std::string> rounding_comment(const RollPitchYaw& rotation,
                                                        const Vector& rpy);

/// The frame of the branch's child, after one for the joint's origin where one does not do.
[[nodiscard]] std::vector<FrameDraft> draft_frames(Drafting& drafting, const Branch& branch,
                                                   const JointMotion& motion);

/// The body of a link in its frame; adds a frame in its principal axes where it needs one.
void draft_body(Drafting& drafting, std::size_t link, LinkDraft& to);

}  // namespace elgen::urdf
