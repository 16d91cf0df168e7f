// <robot>: its links with their masses and inertias (shapes are no mechanics), its joints, and the
// rotors of its transmissions. Elements that xacro would have expanded are refused, because what
// they stand for is missing.
#include <fmt/format.h>

#include <algorithm>

#include "elgen/wording.hpp"
#include "urdf/element_reader.hpp"

namespace elgen::urdf {

namespace {

/// Once for all of them.
void refuse_macros(ElementReader& reader, const Element& root, Diagnostics& found) {
  bool is_first = true;
  for (const Element& child : root.children) {
    if (!child.name.starts_with("xacro:")) continue;
    if (is_first) {
      found.push_back({Code::E802, child.span,
                       fmt::format("{} is a macro of xacro", in_backticks("<" + child.name + ">")),
                       std::string(xacro_remedy)});
    }
    is_first = false;
    reader.ignore({child.name});
  }
}

/// Other formats of robots, by their root elements.
struct ForeignFormat {
  std::string_view element;
  std::string_view name;
};
constexpr std::array formats{ForeignFormat{"sdf", "SDF"}, ForeignFormat{"mujoco", "MJCF"},
                             ForeignFormat{"mujocoinclude", "MJCF"}};

Diagnostic foreign(const Element& root) {
  const std::string shown = in_backticks("<" + root.name + ">");
  const auto format = std::ranges::find(formats, root.name, &ForeignFormat::element);
  if (format == formats.end()) return {Code::E802, root.span, shown + " is no `<robot>`"};
  return {Code::E802, root.span, fmt::format("{} is {}, and elgen reads URDF", shown, format->name),
          "convert it to URDF first"};
}

std::string file_name(const Span& span) {
  const std::string& path = span.source->path;
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? path : path.substr(slash + 1);
}

constexpr std::array<std::string_view, 6> inertia_attributes{"ixx", "iyy", "izz",
                                                             "ixy", "ixz", "iyz"};

void read_mass(ElementReader& inertial, Inertial& to, RobotReading& reading) {
  inertial.required_child("mass", [&](ElementReader& mass) {
    to.mass = mass.required_number("value").value_or(FileNumber{});
  });
  if (cln::minusp(to.mass.value)) {
    reading.found.push_back(
        {Code::E811, to.mass.span, fmt::format("the mass `{}` is negative", to.mass.text)});
  }
}

void read_inertia(ElementReader& inertial, Inertial& to) {
  inertial.required_child("inertia", [&](ElementReader& inertia) {
    to.span = inertia.span();
    for (std::size_t i = 0; i < inertia_attributes.size(); ++i) {
      to.inertia[i] = inertia.required_number(inertia_attributes[i]).value_or(FileNumber{});
    }
  });
}

Link read_link(const Element& element, RobotReading& reading) {
  ElementReader reader(element, reading);
  Link link{reader.required_text("name"), {}};
  reader.child("inertial", [&](ElementReader& parts) {
    Inertial& inertial = link.inertial.emplace();
    inertial.origin = read_origin(parts);
    read_mass(parts, inertial, reading);
    read_inertia(parts, inertial);
  });
  reader.ignore({"visual", "collision", "type"});
  reader.note_the_rest();
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

FileNumber value_of(const Element& element, RobotReading& reading) {
  return ElementReader(element, reading).required_number("value").value_or(FileNumber{});
}

/// The rotor of a joint of the robot, as Drake's elements have it.
void read_transmission(const Element& element, Robot& robot, RobotReading& reading) {
  const Element* actuator = child_of(&element, "actuator");
  const Element* inertia = child_of(actuator, "drake:rotor_inertia");
  const Element* named = child_of(&element, "joint");
  if (inertia == nullptr || named == nullptr) return;
  const std::string name = ElementReader(*named, reading).required_text("name").text;
  Joint* joint = find_joint(robot, name);
  if (joint == nullptr) {
    reading.found.push_back(
        {Code::E815, inertia->span, "`<drake:rotor_inertia>` in `<actuator>` is not imported",
         fmt::format("{} is no joint that turns or slides", in_backticks(name))});
    return;
  }
  Rotor& rotor = joint->rotor.emplace();
  rotor.inertia = value_of(*inertia, reading);
  if (const Element* gear = child_of(actuator, "drake:gear_ratio")) {
    rotor.gear_ratio = value_of(*gear, reading);
  }
  if (cln::minusp(rotor.inertia.value)) {
    reading.found.push_back(
        {Code::E811, rotor.inertia.span,
         fmt::format("the rotor inertia `{}` is negative", rotor.inertia.text)});
  }
}

/// SDF and Drake have a world that no file declares.
void add_world(Robot& robot) {
  const auto is_world = [](const Link& link) { return link.name.text == "world"; };
  const auto hangs_on_it = [](const Joint& joint) { return joint.parent.text == "world"; };
  const auto first = std::ranges::find_if(robot.joints, hangs_on_it);
  if (first == robot.joints.end() || std::ranges::any_of(robot.links, is_world)) return;
  robot.links.push_back({first->parent, {}});
}

}  // namespace

Robot read_robot(const Element& root, RobotReading& reading) {
  Robot robot;
  robot.file = file_name(root.span);
  robot.span = root.span;
  if (root.name != "robot") {
    reading.found.push_back(foreign(root));
    return robot;
  }
  ElementReader reader(root, reading);
  robot.is_of_xacro =
      std::ranges::find(root.attributes, "xmlns:xacro", &Attribute::name) != root.attributes.end();
  refuse_macros(reader, root, reading.found);
  robot.name = reader.text("name").text;
  if (robot.name.empty()) robot.name = robot.file.substr(0, robot.file.rfind('.'));
  robot.model = robot.name;
  for (const Element* link : reader.children("link")) {
    robot.links.push_back(read_link(*link, reading));
  }
  for (const Element* joint : reader.children("joint")) {
    robot.joints.push_back(read_joint(*joint, reading));
  }
  add_world(robot);
  for (const Element* transmission : reader.children("transmission")) {
    read_transmission(*transmission, robot, reading);
  }
  reader.ignore({"version", "material"});
  reader.note_the_rest();
  return robot;
}

}  // namespace elgen::urdf
