// A joint's origin and its motion as frames of the model.
#include <fmt/format.h>

#include "base/toml_text.hpp"
#include "urdf/draft.hpp"
#include "urdf/expressions.hpp"

namespace elgen::urdf {

namespace {

std::string description(const Joint& joint, AngleDigits digits) {
  const Axis axis = axis_of(joint.axis, digits);
  const std::string_view type = word(joint.type);
  if (joint.type == JointType::fixed || joint.type == JointType::floating) {
    const std::string_view weld = joint.welded ? ", welded" : "";
    return fmt::format("{}: {}{}", joint.name.text, type, weld);
  }
  const std::string direction =
      axis.along ? (axis.is_reversed ? "-" : "") + axis_letter(*axis.along) : listed(joint.axis);
  const std::string_view relation = joint.type == JointType::prismatic ? "along"
                                    : joint.type == JointType::planar  ? "normal to"
                                                                       : "about";
  const std::string rounded =
      axis.is_rounded ? fmt::format(" (in the URDF: {})", listed(joint.axis)) : "";
  const std::string weld = joint.welded            ? ", welded at " + joint.welded->text
                           : joint.is_angle_welded ? ", its angle welded at 0"
                                                   : "";
  return fmt::format("{}: {} {} {}{}{}", joint.name.text, type, relation, direction, rounded, weld);
}

}  // namespace

std::string listed(const Vector& numbers) {
  return fmt::format("{} {} {}", numbers[0].text, numbers[1].text, numbers[2].text);
}

Components place_of(Glossary& glossary, std::string_view name, const Vector& xyz) {
  Components result;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string of_axis = fmt::format(fmt::runtime(name), axis_letter(i));
    result[i] = glossary.parameter(of_axis, xyz[i], "m");
  }
  return result;
}

std::string step_text(const std::string& axis, const std::string& angle) {
  return toml_list({axis, toml_string(angle)});
}

std::vector<std::string> steps_of(const RollPitchYaw& rotation) {
  std::vector<std::string> steps;
  for (const std::size_t axis : {2U, 1U, 0U}) {
    const Angle& angle = rotation.rpy[axis];
    if (angle.is_zero()) continue;
    steps.push_back(step_text(toml_string(axis_letter(axis)), angle.text));
  }
  return steps;
}

std::vector<std::string> frame_comments(const std::string& title, const RollPitchYaw& rotation,
                                        const Vector& rpy) {
  if (!rotation.is_rounded()) return {title};
  return {title, "rpy in the URDF: " + listed(rpy)};
}

std::string frame_table(const FrameDraft& frame) {
  TomlTable table("[[frame]]");
  table.add("name", toml_string(frame.name));
  table.add("parent", toml_string(frame.parent));
  if (frame.translate != Components{"0", "0", "0"}) {
    table.add("translate", vector_text(frame.translate));
  }
  if (!frame.rotate.empty()) table.add("rotate", toml_list(frame.rotate));
  if (!frame.rotation.empty()) table.add("rotation", toml_string(frame.rotation));
  return comments(frame.comments) + table.text();
}

void draft_frames(Draft& draft, const Branch& branch, const JointMotion& motion) {
  const Joint& joint = draft.robot.joints[branch.joint];
  Glossary& glossary = draft.glossary;
  const std::string& name = glossary.joint(branch.joint);
  const RollPitchYaw rotation = rotation_of(joint.origin.rpy, draft.robot.digits);
  const bool slides = motion.translate != Components{"0", "0", "0"};

  FrameDraft frame;
  frame.comments =
      frame_comments(description(joint, draft.robot.digits), rotation, joint.origin.rpy);
  frame.parent = glossary.frame(branch.parent);
  frame.translate = place_of(glossary, "{}_" + name, joint.origin.xyz);
  frame.rotate = steps_of(rotation);
  if (!rotation.is_zero() && slides) {
    frame.name = glossary.claim(name + "_origin", "frame");
    draft.links.push_back(frame_table(frame));
    frame = {{}, {}, frame.name};
  }
  frame.name = glossary.frame(branch.child);
  for (std::size_t i = 0; i < 3; ++i) {
    frame.translate[i] = sum(frame.translate[i], motion.translate[i]);
  }
  frame.rotate.insert(frame.rotate.end(), motion.turn.begin(), motion.turn.end());
  frame.rotation = motion.attitude;
  draft.links.push_back(frame_table(frame));
}

}  // namespace elgen::urdf
