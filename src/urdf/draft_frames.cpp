// The origin and motion of a joint as frames of the model, and an <inertial> as a body in its
// frame.
#include <fmt/format.h>

#include <algorithm>

#include "base/toml_text.hpp"
#include "urdf/draft.hpp"

namespace elgen::urdf {

namespace {

std::string description(const Joint& joint, AngleRounding digits) {
  const Axis axis = snap_axis(joint.axis, digits);
  const std::string_view type = type_word(joint.type);
  if (joint.type == JointType::fixed || joint.type == JointType::floating) {
    const std::string_view weld = joint.weld_position ? ", welded" : "";
    return fmt::format("{}: {}{}", joint.name.text, type, weld);
  }
  const std::string direction = axis.index
                                    ? (axis.is_reversed ? "-" : "") + axis_letter(*axis.index)
                                    : numbers_text(joint.axis);
  const std::string_view relation = joint.type == JointType::prismatic ? "along"
                                    : joint.type == JointType::planar  ? "normal to"
                                                                       : "about";
  const std::string rounded =
      axis.is_rounded ? fmt::format(" (in the URDF: {})", numbers_text(joint.axis)) : "";
  const std::string weld = joint.weld_position     ? ", welded at " + joint.weld_position->text
                           : joint.is_angle_welded ? ", its angle welded at 0"
                                                   : "";
  return fmt::format("{}: {} {} {}{}{}", joint.name.text, type, relation, direction, rounded, weld);
}

constexpr std::array<std::string_view, 6> inertia_names{"Ixx", "Iyy", "Izz", "Ixy", "Ixz", "Iyz"};

std::vector<std::string> add_inertia_parameters(Glossary& glossary, const std::string& link,
                                                const std::array<FileNumber, 6>& numbers) {
  const auto is_zero = [](const FileNumber& number) { return number.is_zero(); };
  if (std::ranges::all_of(numbers, is_zero)) return {};
  const std::size_t count = std::all_of(numbers.begin() + 3, numbers.end(), is_zero) ? 3 : 6;
  std::vector<std::string> inertia;
  for (std::size_t i = 0; i < count; ++i) {
    const std::string sign = i < 3 ? "assume = \"positive\"" : "";
    inertia.push_back(glossary.add_parameter(fmt::format("{}_{}", inertia_names[i], link),
                                             numbers[i], "kg*m^2", sign));
  }
  return inertia;
}

/// The entries of an inertia as a TOML list. Six entries take two lines: the diagonal, then the
/// off-diagonal entries.
std::string inertia_text(const std::vector<std::string>& inertia) {
  std::string text;
  for (std::size_t i = 0; i < inertia.size(); ++i) {
    text += (i == 0 ? "" : i == 3 ? ",\n           " : ", ") + toml_string(inertia[i]);
  }
  return "[" + text + "]";
}

/// Adds a frame in the axes of the inertia; returns its name.
std::string add_inertia_frame(ModelDraft& draft, const std::string& link, const Inertial& inertial,
                              const Components& com) {
  const RollPitchYaw rotation = round_rotation(inertial.origin.rpy, draft.robot.digits);
  FrameDraft axes;
  axes.comments = frame_comments("axes of the inertia of " + link, rotation, inertial.origin.rpy);
  axes.name = draft.glossary.claim(link + "_inertial", "frame");
  axes.parent = link;
  axes.translate = com;
  axes.rotate = turn_texts(rotation);
  draft.link_tables.push_back(frame_table(axes));
  return axes.name;
}

}  // namespace

std::string numbers_text(const Vector& numbers) {
  return fmt::format("{} {} {}", numbers[0].text, numbers[1].text, numbers[2].text);
}

Components position_components(Glossary& glossary, std::string_view name, const Vector& xyz) {
  Components result;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string of_axis = fmt::format(fmt::runtime(name), axis_letter(i));
    result[i] = glossary.add_parameter(of_axis, xyz[i], "m");
  }
  return result;
}

std::string turn_text(const std::string& axis, const std::string& angle) {
  return toml_list({axis, toml_string(angle)});
}

std::vector<std::string> turn_texts(const RollPitchYaw& rotation) {
  std::vector<std::string> steps;
  for (const std::size_t axis : {2U, 1U, 0U}) {
    const Angle& angle = rotation.rpy[axis];
    if (angle.is_zero()) continue;
    steps.push_back(turn_text(toml_string(axis_letter(axis)), angle.text));
  }
  return steps;
}

std::vector<std::string> frame_comments(const std::string& title, const RollPitchYaw& rotation,
                                        const Vector& rpy) {
  if (!rotation.is_rounded()) return {title};
  return {title, "rpy in the URDF: " + numbers_text(rpy)};
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
  return comment_lines(frame.comments) + table.text();
}

void draft_frames(ModelDraft& draft, const Branch& branch, const JointMotion& motion) {
  const Joint& joint = draft.robot.joints[branch.joint];
  Glossary& glossary = draft.glossary;
  const std::string& name = glossary.joint_name(branch.joint);
  const RollPitchYaw rotation = round_rotation(joint.origin.rpy, draft.robot.digits);
  const bool slides = motion.translate != Components{"0", "0", "0"};

  FrameDraft frame;
  frame.comments =
      frame_comments(description(joint, draft.robot.digits), rotation, joint.origin.rpy);
  frame.parent = glossary.frame_name(branch.parent);
  frame.translate = position_components(glossary, "{}_" + name, joint.origin.xyz);
  frame.rotate = turn_texts(rotation);
  if (!rotation.is_zero() && slides) {
    frame.name = glossary.claim(name + "_origin", "frame");
    draft.link_tables.push_back(frame_table(frame));
    frame = {{}, {}, frame.name};
  }
  frame.name = glossary.frame_name(branch.child);
  for (std::size_t i = 0; i < 3; ++i) {
    frame.translate[i] = sum_text(frame.translate[i], motion.translate[i]);
  }
  frame.rotate.insert(frame.rotate.end(), motion.turn.begin(), motion.turn.end());
  frame.rotation = motion.attitude;
  draft.link_tables.push_back(frame_table(frame));
}

void draft_body(ModelDraft& draft, std::size_t link) {
  const auto& inertial = draft.robot.links[link].inertial;
  if (!inertial) return;
  Glossary& glossary = draft.glossary;
  const std::string& name = glossary.frame_name(link);
  const auto& [xyz, rpy] = inertial->origin;
  const std::string mass =
      glossary.add_parameter("m_" + name, inertial->mass, "kg", "assume = \"positive\"");
  Components com = position_components(glossary, "c{}_" + name, xyz);
  const RollPitchYaw rotation = round_rotation(rpy, draft.robot.digits);
  const auto turned = rotate_inertia(rotation, inertial->inertia);
  const auto inertia = add_inertia_parameters(glossary, name, turned.value_or(inertial->inertia));
  if (mass == "0" && inertia.empty()) return;
  const bool has_axes = !turned && !inertia.empty();
  TomlTable body("[[body]]");
  body.add("name", toml_string(name));
  body.add("frame", toml_string(has_axes ? add_inertia_frame(draft, name, *inertial, com) : name));
  if (has_axes) com = {"0", "0", "0"};
  if (mass != "0") {
    body.add("mass", toml_string(mass));
    body.add("com", vector_text(com));
  }
  if (!inertia.empty()) body.add("inertia", inertia_text(inertia));
  const bool is_turned = turned && !rotation.is_zero() && !inertia.empty();
  draft.link_tables.push_back(
      (is_turned ? toml_comment("inertia turned from axes of rpy " + numbers_text(rpy)) : "") +
      body.text());
}

}  // namespace elgen::urdf
