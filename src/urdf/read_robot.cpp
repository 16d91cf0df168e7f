// <robot>: links with masses and inertias (shapes do not affect the motion), joints with limits,
// damping and friction, and the rotors of transmissions. Unexpanded elements of xacro are refused,
// because their content is missing.
#include <fmt/ranges.h>

#include <algorithm>

#include "elgen/wording.hpp"
#include "urdf/element_reader.hpp"
#include "urdf/rotations.hpp"

namespace elgen::urdf {

namespace {

/// Reports E802 once, at the first macro.
void report_macros(ElementReader& reader, const Element& root, Diagnostics& found) {
  bool is_first = true;
  for (const Element& child : root.children) {
    if (!child.name.starts_with("xacro:")) continue;
    if (is_first) {
      found.push_back({Code::E802, child.span,
                       fmt::format("{} is a macro of xacro", quote_text("<" + child.name + ">")),
                       std::string(xacro_remedy)});
    }
    is_first = false;
    reader.ignore({child.name});
  }
}

/// Other robot formats, by their root elements.
struct ForeignFormat {
  std::string_view element;
  std::string_view name;
};
constexpr std::array formats{ForeignFormat{"sdf", "SDF"}, ForeignFormat{"mujoco", "MJCF"},
                             ForeignFormat{"mujocoinclude", "MJCF"}};

Diagnostic foreign_format_error(const Element& root) {
  const std::string shown = quote_text("<" + root.name + ">");
  const auto format = std::ranges::find(formats, root.name, &ForeignFormat::element);
  if (format == formats.end()) return {Code::E802, root.span, shown + " is no `<robot>`"};
  return {Code::E802, root.span, fmt::format("{} is {}, and elgen reads URDF", shown, format->name),
          "convert it to URDF first"};
}

constexpr std::array<std::string_view, 6> inertia_attributes{"ixx", "iyy", "izz",
                                                             "ixy", "ixz", "iyz"};

void read_mass(ElementReader& inertial, Inertial& to, RobotReadState& reading) {
  inertial.require_child("mass", [&](ElementReader& mass) {
    to.mass = mass.require_number("value").value_or(FileNumber{});
  });
  if (cln::minusp(to.mass.value)) {
    reading.diagnostics.push_back(
        {Code::E811, to.mass.span, fmt::format("the mass `{}` is negative", to.mass.text)});
  }
}

void read_inertia(ElementReader& inertial, Inertial& to) {
  inertial.require_child("inertia", [&](ElementReader& inertia) {
    to.span = inertia.span();
    for (std::size_t i = 0; i < inertia_attributes.size(); ++i) {
      to.inertia[i] = inertia.require_number(inertia_attributes[i]).value_or(FileNumber{});
    }
  });
}

Link read_link(const Element& element, RobotReadState& reading) {
  ElementReader reader(element, reading);
  Link link{reader.require_text("name"), {}};
  reader.read_child("inertial", [&](ElementReader& parts) {
    Inertial& inertial = link.inertial.emplace();
    inertial.origin = read_origin(parts);
    read_mass(parts, inertial, reading);
    read_inertia(parts, inertial);
  });
  reader.ignore({"visual", "collision", "type"});
  reader.report_unread();
  return link;
}

const Element* child_of(const Element* parent, std::string_view name) {
  if (parent == nullptr) return nullptr;
  const auto found = std::ranges::find(parent->children, name, &Element::name);
  return found == parent->children.end() ? nullptr : &*found;
}

Joint* find_joint(Robot& robot, const std::string& name) {
  for (Joint& joint : robot.joints) {
    if (joint.name.text == name && has_one_coordinate(joint.type)) return &joint;
  }
  return nullptr;
}

FileNumber read_value(const Element& element, RobotReadState& reading) {
  return ElementReader(element, reading).require_number("value").value_or(FileNumber{});
}

/// Reads the rotor of a joint from Drake's elements in a `<transmission>`.
void read_transmission(const Element& element, Robot& robot, RobotReadState& reading) {
  const Element* actuator = child_of(&element, "actuator");
  const Element* inertia = child_of(actuator, "drake:rotor_inertia");
  const Element* named = child_of(&element, "joint");
  if (inertia == nullptr || named == nullptr) return;
  const std::string name = ElementReader(*named, reading).require_text("name").text;
  Joint* joint = find_joint(robot, name);
  if (joint == nullptr) {
    reading.diagnostics.push_back(
        {Code::E815, inertia->span, "`<drake:rotor_inertia>` in `<actuator>` is not imported",
         fmt::format("{} is neither revolute nor prismatic", quote_text(name))});
    return;
  }
  Rotor& rotor = joint->rotor.emplace();
  rotor.inertia = read_value(*inertia, reading);
  if (const Element* gear = child_of(actuator, "drake:gear_ratio")) {
    rotor.gear_ratio = read_value(*gear, reading);
  }
  if (cln::minusp(rotor.inertia.value)) {
    reading.diagnostics.push_back(
        {Code::E811, rotor.inertia.span,
         fmt::format("the rotor inertia `{}` is negative", rotor.inertia.text)});
  }
}

struct TypeRow {
  JointType type;
  std::string_view word;
};

constexpr std::array types{
    TypeRow{JointType::revolute, "revolute"},   TypeRow{JointType::continuous, "continuous"},
    TypeRow{JointType::prismatic, "prismatic"}, TypeRow{JointType::fixed, "fixed"},
    TypeRow{JointType::floating, "floating"},   TypeRow{JointType::planar, "planar"},
};

/// Names of ball joints in Bullet and Drake.
constexpr std::array<std::string_view, 2> balls{"spherical", "ball"};

std::string type_hint(const std::string& type) {
  std::vector<std::string> words;
  for (const TypeRow& row : types) words.emplace_back(row.word);
  const std::string near = suggestion(type, words);
  if (!near.empty()) return near;
  const std::string known = fmt::format("there are {}", fmt::join(words, ", "));
  if (std::ranges::find(balls, type) == balls.end()) return known;
  return known +
         "; a `floating` joint is imported with a rotation and three lengths: remove the lengths";
}

JointType read_type(ElementReader& joint, RobotReadState& reading) {
  const SpannedText text = joint.require_text("type");
  const auto row = std::ranges::find(types, text.text, &TypeRow::word);
  if (row != types.end()) return row->type;
  if (text.text.empty()) return JointType::fixed;  // E803 is already reported
  reading.diagnostics.push_back({Code::E806, text.span,
                                 fmt::format("{} is no type of joint", quote_text(text.text)),
                                 type_hint(text.text)});
  return JointType::fixed;
}

SpannedText read_link_name(ElementReader& joint, std::string_view role) {
  SpannedText name;
  joint.require_child(role, [&](ElementReader& link) { name = link.require_text("link"); });
  return name;
}

void read_axis(ElementReader& reader, Joint& joint, RobotReadState& reading) {
  if (joint.type == JointType::fixed || joint.type == JointType::floating) return;
  bool is_read = false;
  reader.read_child("axis", [&](ElementReader& axis) {
    joint.axis_span = axis.require_text("xyz").span;
    is_read = axis.read_vector("xyz", joint.axis);
  });
  if (!is_read) return;
  const bool is_zero = std::ranges::all_of(joint.axis, &FileNumber::is_zero);
  if (is_zero)
    reading.diagnostics.push_back({Code::E813, joint.axis_span, "the axis has no direction"});
  if (joint.type == JointType::planar && !is_zero &&
      !snap_axis(joint.axis, AngleRounding::round).index) {
    reading.diagnostics.push_back({Code::E108, joint.axis_span,
                                   "a planar joint is imported only with an axis along x, y or z"});
  }
}

constexpr const char* no_limit = "the model omits this limit";

/// The bound `name`; an invalid bound is dropped with E814, because no equation contains limits.
std::optional<FileNumber> read_bound(ElementReader& limit, std::string_view name, bool is_signed,
                                     Diagnostics& found) {
  const SpannedText text = limit.read_text(name);
  const bool is_finite = !is_not_finite(text.text);
  const std::optional<FileNumber> number = is_finite ? limit.read_number(name) : std::nullopt;
  if (is_finite && (is_signed || !number || !cln::minusp(number->value))) return number;
  found.push_back({Code::E814, text.span,
                   fmt::format("{} {} is {}", name, quote_text(text.text),
                               is_finite ? "negative" : "not finite"),
                   no_limit});
  return std::nullopt;
}

void read_limit(ElementReader& reader, JointLimit& limit, Diagnostics& found) {
  reader.read_child("limit", [&](ElementReader& numbers) {
    const std::size_t known = found.size();
    limit.lower = read_bound(numbers, "lower", true, found);
    limit.upper = read_bound(numbers, "upper", true, found);
    if (limit.lower && limit.upper && limit.lower->value > limit.upper->value) {
      found.push_back(
          {Code::E814, limit.lower->span,
           fmt::format("lower `{}` is above upper `{}`", limit.lower->text, limit.upper->text),
           no_limit});
    }
    if (found.size() > known) limit = {};
    limit.velocity = read_bound(numbers, "velocity", false, found);
    limit.effort = read_bound(numbers, "effort", false, found);
  });
}

void read_dynamics(ElementReader& reader, Joint& joint) {
  reader.read_child("dynamics", [&](ElementReader& dynamics) {
    joint.damping = dynamics.read_number("damping").value_or(FileNumber{});
    joint.friction = dynamics.read_number("friction").value_or(FileNumber{});
  });
}

/// E822 for damping and friction of a joint with several coordinates: they are not imported.
void warn_of_dynamics(ElementReader& reader, const Joint& joint, Diagnostics& found) {
  reader.read_child("dynamics", [&](ElementReader& dynamics) {
    for (const char* const name : {"damping", "friction"}) {
      const std::optional<FileNumber> number = dynamics.read_number(name);
      if (!number || number->is_zero()) continue;
      found.push_back({Code::E822, number->span,
                       fmt::format("the {} of {}, a {} joint, is not imported", name,
                                   quote_text(joint.name.text), type_word(joint.type)),
                       "the model ignores it: add it to `[energy] D`"});
    }
  });
}

/// E815 for `<mimic>` in a fixed joint. `<mimic>` remains in robots whose gripper joints were
/// changed to fixed.
void report_mimic_of_fixed_joint(ElementReader& reader, RobotReadState& reading) {
  for (const Element* mimic : reader.take_children("mimic")) {
    reading.diagnostics.push_back({Code::E815, mimic->span,
                                   "`<mimic>` in a fixed `<joint>` is not imported",
                                   "the joint has no coordinate"});
  }
}

void read_mimic(ElementReader& reader, Joint& joint) {
  reader.read_child("mimic", [&](ElementReader& mimic) {
    joint.mimic = Mimic{mimic.require_text("joint"),
                        mimic.read_number("multiplier").value_or(make_file_number(1)),
                        mimic.read_number("offset").value_or(FileNumber{})};
  });
}

Joint read_joint(const Element& element, RobotReadState& reading) {
  ElementReader reader(element, reading);
  Joint joint;
  joint.name = reader.require_text("name");
  joint.type = read_type(reader, reading);
  joint.parent = read_link_name(reader, "parent");
  joint.child = read_link_name(reader, "child");
  joint.origin = read_origin(reader);
  if (has_one_coordinate(joint.type)) {
    read_limit(reader, joint.limit, reading.diagnostics);
    read_dynamics(reader, joint);
  }
  if (joint.type == JointType::fixed) reader.ignore({"axis", "limit", "dynamics"});
  if (joint.type == JointType::floating) reader.ignore({"axis"});
  const bool has_several = joint.type == JointType::floating || joint.type == JointType::planar;
  if (has_several) warn_of_dynamics(reader, joint, reading.diagnostics);
  read_axis(reader, joint, reading);
  if (joint.type == JointType::fixed) {
    report_mimic_of_fixed_joint(reader, reading);
  } else {
    read_mimic(reader, joint);
  }
  reader.ignore({"calibration", "safety_controller"});
  reader.report_unread();
  return joint;
}

/// Adds the link `world`, which is implicit in SDF and Drake, if `world` is the parent of a joint.
void add_world(Robot& robot) {
  const auto is_world = [](const Link& link) { return link.name.text == "world"; };
  const auto hangs_on_it = [](const Joint& joint) { return joint.parent.text == "world"; };
  const auto first = std::ranges::find_if(robot.joints, hangs_on_it);
  if (first == robot.joints.end() || std::ranges::any_of(robot.links, is_world)) return;
  robot.links.push_back({first->parent, {}});
}

}  // namespace

std::string_view type_word(JointType type) {
  return std::ranges::find(types, type, &TypeRow::type)->word;
}

bool has_one_coordinate(JointType type) {
  return type == JointType::revolute || type == JointType::continuous ||
         type == JointType::prismatic;
}

Robot read_robot(const Element& root, RobotReadState& reading) {
  Robot robot;
  robot.file = reading.file.empty() ? file_name(*root.span.source) : reading.file;
  robot.span = root.span;
  if (root.name != "robot") {
    reading.diagnostics.push_back(foreign_format_error(root));
    return robot;
  }
  ElementReader reader(root, reading);
  robot.uses_xacro =
      std::ranges::find(root.attributes, "xmlns:xacro", &Attribute::name) != root.attributes.end();
  report_macros(reader, root, reading.diagnostics);
  robot.name = reader.read_text("name").text;
  if (robot.name.empty()) robot.name = robot.file.substr(0, robot.file.rfind('.'));
  robot.model = robot.name;
  for (const Element* link : reader.take_children("link")) {
    robot.links.push_back(read_link(*link, reading));
  }
  for (const Element* joint : reader.take_children("joint")) {
    robot.joints.push_back(read_joint(*joint, reading));
  }
  add_world(robot);
  for (const Element* transmission : reader.take_children("transmission")) {
    read_transmission(*transmission, robot, reading);
  }
  reader.ignore({"version", "material"});
  reader.report_unread();
  return robot;
}

}  // namespace elgen::urdf
