// A joint's origin and its motion as frames of the model.
#include <fmt/format.h>

#include "urdf/drafting.hpp"

namespace elgen::urdf {

namespace {

std::string listed(const Vector& numbers) {
  return fmt::format("{} {} {}", numbers[0].text, numbers[1].text, numbers[2].text);
}

std::string description(const Joint& joint) {
  const Axis axis = axis_of(joint.axis);
  const std::string_view type = word(joint.type);
  if (joint.type == JointType::fixed || joint.type == JointType::floating) {
    return fmt::format("{}: {}", joint.name.text, type);
  }
  const std::string direction =
      axis.along ? (axis.is_reversed ? "-" : "") + axis_letter(*axis.along) : listed(joint.axis);
  const std::string_view relation = joint.type == JointType::prismatic ? "along"
                                    : joint.type == JointType::planar  ? "normal to"
                                                                       : "about";
  const std::string rounded =
      axis.is_rounded ? fmt::format(" (in the URDF: {})", listed(joint.axis)) : "";
  return fmt::format("{}: {} {} {}{}", joint.name.text, type, relation, direction, rounded);
}

Components origin_of(Glossary& glossary, const Joint& joint, const std::string& name) {
  Components result;
  for (std::size_t i = 0; i < 3; ++i) {
    result[i] = glossary.parameter(axis_letter(i) + "_" + name, joint.origin.xyz[i], "m");
  }
  return result;
}

}  // namespace

std::vector<AxisAngle> steps_of(const RollPitchYaw& rotation) {
  std::vector<AxisAngle> steps;
  for (const std::size_t axis : {2U, 1U, 0U}) {
    const Angle& angle = rotation.rpy[axis];
    if (!angle.is_zero()) steps.push_back({{axis_letter(axis), "", ""}, angle.text});
  }
  return steps;
}

std::vector<std::string> rounding_comment(const RollPitchYaw& rotation, const Vector& rpy) {
  if (!rotation.is_rounded()) return {};
  return {fmt::format("rpy in the URDF: {}", listed(rpy))};
}

std::vector<FrameDraft> draft_frames(Drafting& drafting, const Branch& branch,
                                     const JointMotion& motion) {
  const Joint& joint = drafting.robot.joints[branch.joint];
  Glossary& glossary = drafting.glossary;
  const std::string& name = glossary.joint(branch.joint);
  const RollPitchYaw rotation = rotation_of(joint.origin.rpy);
  const bool turns_only = joint.type == JointType::revolute || joint.type == JointType::continuous;
  const bool needs_origin = !rotation.is_zero() && !turns_only && joint.type != JointType::fixed;

  FrameDraft origin;
  origin.comments = {description(joint)};
  for (std::string& comment : rounding_comment(rotation, joint.origin.rpy)) {
    origin.comments.push_back(std::move(comment));
  }
  origin.parent = glossary.frame(branch.parent);
  origin.translate = origin_of(glossary, joint, name);
  origin.rotate = steps_of(rotation);
  std::vector<FrameDraft> frames{origin};
  if (needs_origin) {
    frames.front().name = glossary.claim(name + "_origin", "frame");
    FrameDraft moving;
    moving.parent = frames.front().name;
    frames.push_back(moving);
  }
  FrameDraft& last = frames.back();
  last.name = glossary.frame(branch.child);
  for (std::size_t i = 0; i < 3; ++i) {
    last.translate[i] = sum(last.translate[i], motion.translate[i]);
  }
  for (const AxisAngle& step : motion.turn) last.rotate.push_back(step);
  last.rotation = motion.attitude;
  return frames;
}

}  // namespace elgen::urdf
