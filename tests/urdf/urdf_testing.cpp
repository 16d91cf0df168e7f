#include "urdf/urdf_testing.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace elgen::test {

namespace {

/// A source that lives until the process ends, because diagnostics point to it without owning it.
const SourceText& kept_source(const std::string& text) {
  static std::vector<SourcePointer> sources;
  return *sources.emplace_back(make_source("folder/r.urdf", text));
}

}  // namespace

std::string messages(const Diagnostics& diagnostics) {
  std::string text;
  for (const Diagnostic& diagnostic : diagnostics) {
    const LineColumn at = line_column(*diagnostic.span.source, diagnostic.span.begin);
    text += fmt::format("{} {}:{} {}{}\n", code_row(diagnostic.code).name, at.line, at.column,
                        diagnostic.message, diagnostic.hint.empty() ? "" : " | " + diagnostic.hint);
  }
  return text;
}

std::string import_messages(const std::string& text, const ImportOptions& options) {
  const SourcePointer source = make_source("folder/r.urdf", text);
  return messages(import_urdf(source, {}, options).diagnostics);
}

std::string imported(const std::string& text, const ImportOptions& options) {
  const SourcePointer source = make_source("folder/r.urdf", text);
  const Result<ImportedModel> model = import_urdf(source, {}, options);
  if (!model) throw std::runtime_error(format(model.diagnostics));
  return model.value->text;
}

std::string with_arm(const std::string& rest) {
  return "<robot name=\"r\">\n  <link name=\"base\"/>\n"
         "  <link name=\"arm\"><inertial><origin xyz=\"0.1 0 0\"/><mass value=\"1\"/><inertia "
         "ixx=\"2\" iyy=\"2\" izz=\"2\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>\n" +
         rest + "\n</robot>\n";
}

std::string arm_on(const std::string& type, const std::string& elements) {
  return with_arm("  <joint name=\"j\" type=\"" + type +
                  "\"><parent link=\"base\"/><child link=\"arm\"/>\n" + elements + "\n  </joint>");
}

std::string joint(const std::string& name, const std::string& type, const std::string& inside) {
  return "<joint name=\"" + name + "\" type=\"" + type + "\"><parent link=\"" + name[0] +
         "\"/><child link=\"" + name[1] + "\"/>" + inside + "</joint>\n";
}

urdf::Element xml_of(const std::string& text) {
  Result<urdf::Element> root = urdf::read_xml(kept_source(text));
  if (!root) throw std::runtime_error(format(root.diagnostics));
  return *root;
}

urdf::Robot robot_of(const std::string& text) {
  Diagnostics found;
  const Limits limits;
  urdf::RobotReadState reading{limits, found};
  const urdf::Element root = xml_of(text);
  urdf::Robot robot = urdf::read_robot(root, reading);
  if (has_errors(found)) throw std::runtime_error(format(found));
  return robot;
}

urdf::LinkTree tree_of(const urdf::Robot& robot) {
  Result<urdf::LinkTree> tree = urdf::make_tree(robot);
  if (!tree) throw std::runtime_error(format(tree.diagnostics));
  return *tree;
}

std::string reading_messages(const std::string& text) {
  Diagnostics found;
  const Limits limits;
  urdf::RobotReadState reading{limits, found};
  const urdf::Element root = xml_of(text);
  (void)urdf::read_robot(root, reading);
  sort_by_position(found);
  return messages(found);
}

std::string after(const std::string& text, const std::string& start) {
  const std::size_t found = text.find(start);
  if (found == std::string::npos) return "";
  const std::size_t begin = found + start.size();
  return text.substr(begin, text.find('\n', begin) - begin);
}

}  // namespace elgen::test
