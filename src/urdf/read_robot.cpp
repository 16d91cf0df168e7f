// <robot>: its links and joints. Elements that xacro would have expanded are refused, because what
// they stand for is missing.
#include <fmt/format.h>

#include "element_reader.hpp"
#include "parse/utf8.hpp"

namespace elgen::urdf {

namespace {

void refuse_macros(const Element& root, Diagnostics& found) {
  for (const Element& child : root.children) {
    if (!child.name.starts_with("xacro:")) continue;
    found.push_back({Code::E802, child.span,
                     fmt::format("{} is a macro", parsing::in_ticks("<" + child.name + ">")),
                     "expand the file with xacro first"});
    return;
  }
}

std::string file_name(const Span& span) {
  const std::string& path = span.source->path;
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? path : path.substr(slash + 1);
}

}  // namespace

Robot read_robot(const Element& root, Reading& reading) {
  Robot robot;
  robot.file = file_name(root.span);
  robot.span = root.span;
  if (root.name != "robot") {
    reading.found.push_back(
        {Code::E802, root.span,
         fmt::format("{} is no `<robot>`", parsing::in_ticks("<" + root.name + ">"))});
    return robot;
  }
  refuse_macros(root, reading.found);
  ElementReader reader(root, reading);
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
