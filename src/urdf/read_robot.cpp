// <robot>: its links and joints. Elements that xacro would have expanded are refused, because what
// they stand for is missing.
#include <fmt/format.h>

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
                       fmt::format("{} is a macro", in_backticks("<" + child.name + ">")),
                       "expand the file with xacro first"});
    }
    is_first = false;
    reader.ignore({child.name});
  }
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
    reading.found.push_back(
        {Code::E802, root.span,
         fmt::format("{} is no `<robot>`", in_backticks("<" + root.name + ">"))});
    return robot;
  }
  ElementReader reader(root, reading);
  refuse_macros(reader, root, reading.found);
  robot.name = reader.required_text("name").text;
  for (const Element* link : reader.children("link")) {
    robot.links.push_back(read_link(*link, reading));
  }
  for (const Element* joint : reader.children("joint")) {
    robot.joints.push_back(read_joint(*joint, reading));
  }
  reader.ignore({"version", "material", "transmission"});
  reader.note_the_rest();
  return robot;
}

}  // namespace elgen::urdf
