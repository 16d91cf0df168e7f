// A draft as the text of a model file: what the robot is made of first, then the tables.
#include <fmt/format.h>

#include <algorithm>

#include "urdf/draft.hpp"
#include "urdf/toml_text.hpp"

namespace elgen::urdf {

namespace {

constexpr std::string_view legend =
    "#\n"
    "# Every link is a frame of its name, every joint that moves a coordinate. Of a joint: x y z "
    "its\n"
    "# origin in the axes of the parent. Of a link, in its own axes: m its mass, cx cy cz its "
    "centre\n"
    "# of mass, Ixx ... its inertia about that. What the URDF has as 0 is 0, not a parameter.\n";

std::string head(const Draft& draft) {
  constexpr std::size_t deepest_indent = 20;  // a long chain would not fit on any line
  std::vector<std::vector<std::string>> rows;
  for (const TreeLine& line : draft.tree) {
    const std::string indent(2 * std::min(line.depth, deepest_indent), ' ');
    rows.push_back({"  " + indent + line.link + "  ", line.joint});
  }
  std::string text = comment(fmt::format("{}, imported from {}.", draft.title, draft.file)) + "#\n";
  for (const std::string& line : aligned(rows)) text += comment(line);
  text += legend;
  if (!draft.renamed.empty()) text += "#\n";
  for (const std::string& change : draft.renamed) text += comment(change);
  return text;
}

std::string model_table(const Draft& draft) {
  Table table("[model]");
  table.add("name", toml_string(draft.name));
  table.add("title", toml_string(draft.title));
  table.add("description",
            toml_string(
                fmt::format("Imported from {}; coordinates are those of its joints.", draft.file)));
  return "format = 1\n\n" + table.text();
}

std::string symmetric_range(const std::string& high) {
  return toml_list({toml_number("-" + high), toml_number(high)});
}

std::string coordinate_table(const CoordinateDraft& coordinate) {
  Table table("[[coordinate]]");
  table.add("name", toml_string(coordinate.name));
  if (coordinate.unit.empty()) {
    table.add("kind", "\"rotation\"");
  } else {
    table.add("unit", toml_string(coordinate.unit));
  }
  if (!coordinate.low.empty()) {
    table.add("range", toml_list({coordinate.low, coordinate.high}));
  }
  if (!coordinate.rate.empty()) {
    table.add("rate_range", symmetric_range(coordinate.rate));
  }
  if (coordinate.wraps) table.add("wrap", "true");
  table.add("doc", toml_string(coordinate.doc));
  return table.text();
}

std::vector<std::string> cells(const ParameterDraft& parameter) {
  const std::string value = fmt::format(" = {{ value = {}, ", toml_number(parameter.value));
  const std::string unit = "unit = " + toml_string(parameter.unit);
  if (parameter.more.empty()) return {parameter.name, value, unit + " }"};
  return {parameter.name, value, unit + ", ", parameter.more + " }"};
}

std::string parameters_table(const Draft& draft) {
  std::string text =
      "[parameters]\ng = { value = 9.81, unit = \"m/s^2\", min = 0, max = 25, doc = \"gravity\" "
      "}\n";
  for (const ParameterGroup& group : draft.parameters) {
    if (group.parameters.empty()) continue;
    text += "\n" + comment(group.title);
    std::vector<std::vector<std::string>> rows;
    for (const ParameterDraft& parameter : group.parameters) rows.push_back(cells(parameter));
    for (const std::string& line : aligned(rows)) text += line + "\n";
  }
  return text;
}

std::string vector_text(const Components& components) {
  std::vector<std::string> quoted;
  for (const std::string& component : components) quoted.push_back(toml_string(component));
  return toml_list(quoted);
}

std::string step_text(const AxisAngle& step) {
  const std::string axis =
      step.axis[1].empty() ? toml_string(step.axis[0]) : vector_text(step.axis);
  return toml_list({axis, toml_string(step.angle)});
}

std::string comments(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += comment(line);
  return text;
}

std::string frame_table(const FrameDraft& frame) {
  Table table("[[frame]]");
  table.add("name", toml_string(frame.name));
  table.add("parent", toml_string(frame.parent));
  if (frame.translate != Components{"0", "0", "0"}) {
    table.add("translate", vector_text(frame.translate));
  }
  if (!frame.rotate.empty()) {
    std::vector<std::string> steps;
    for (const AxisAngle& step : frame.rotate) steps.push_back(step_text(step));
    table.add("rotate", toml_list(steps));
  }
  if (!frame.rotation.empty()) table.add("rotation", toml_string(frame.rotation));
  return comments(frame.comments) + table.text();
}

/// Six inertias on two lines: first the diagonal.
std::string inertia_text(const std::vector<std::string>& inertia) {
  std::string text;
  for (std::size_t i = 0; i < inertia.size(); ++i) {
    text += (i == 0 ? "" : i == 3 ? ",\n           " : ", ") + toml_string(inertia[i]);
  }
  return "[" + text + "]";
}

std::string body_table(const BodyDraft& body) {
  Table table("[[body]]");
  table.add("name", toml_string(body.name));
  table.add("frame", toml_string(body.frame));
  if (body.mass != "0") {
    table.add("mass", toml_string(body.mass));
    table.add("com", vector_text(body.com));
  }
  if (!body.inertia.empty()) table.add("inertia", inertia_text(body.inertia));
  return comments(body.comments) + table.text();
}

std::string dissipation_table(const std::vector<std::string>& terms) {
  std::string text = "[energy]\nD = \"\"\"\n";
  for (std::size_t i = 0; i < terms.size(); ++i) {
    text += (i == 0 ? "  " : "  + ") + terms[i] + "\n";
  }
  return text + "\"\"\"\n";
}

std::string input_table(const InputDraft& input) {
  Table table("[[input]]");
  table.add("name", toml_string(input.name));
  table.add("unit", toml_string(input.unit));
  table.add("on", toml_string(input.on));
  if (!input.limit.empty()) {
    table.add("limits", symmetric_range(input.limit));
  }
  table.add("doc", toml_string(input.doc));
  return table.text();
}

std::string force_table(const ForceDraft& force) {
  Table table("[[force]]");
  table.add("on", toml_string(force.on));
  table.add("value", toml_string(force.value));
  return table.text();
}

}  // namespace

std::string print(const Draft& draft) {
  std::vector<std::string> parts{model_table(draft)};
  for (const CoordinateDraft& coordinate : draft.coordinates) {
    parts.push_back(coordinate_table(coordinate));
  }
  parts.push_back(parameters_table(draft));
  for (const LinkDraft& link : draft.links) {
    for (const FrameDraft& frame : link.frames) parts.push_back(frame_table(frame));
    for (const BodyDraft& body : link.bodies) parts.push_back(body_table(body));
  }
  parts.emplace_back("[gravity]\nvector = [\"0\", \"0\", \"-g\"]\n");
  if (!draft.dissipation.empty()) parts.push_back(dissipation_table(draft.dissipation));
  for (const ForceDraft& force : draft.forces) parts.push_back(force_table(force));
  for (const InputDraft& input : draft.inputs) parts.push_back(input_table(input));
  return head(draft) + fmt::format("{}", fmt::join(parts, "\n"));
}

}  // namespace elgen::urdf
