// <transmission>: the rotor that turns with a joint, and its gear. Everything else drives, and
// moves nothing.
#include <fmt/format.h>

#include "elgen/wording.hpp"
#include "urdf/element_reader.hpp"

namespace elgen::urdf {

namespace {

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

}  // namespace

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

}  // namespace elgen::urdf
