// <robot>: its links and joints. Elements that xacro would have expanded are refused, because what
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
  for (const Element* transmission : reader.children("transmission")) {
    read_transmission(*transmission, robot, reading);
  }
  reader.ignore({"version", "material"});
  reader.note_the_rest();
  return robot;
}

}  // namespace elgen::urdf
