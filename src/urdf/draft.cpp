// The text of a model file: first the links and joints of the robot as a comment, then the tables.
#include "urdf/draft.hpp"

#include <fmt/ranges.h>

#include <algorithm>

#include "base/toml_text.hpp"

namespace elgen::urdf {

namespace {

constexpr std::string_view legend =
    "#\n"
    "# Every link is a frame of its name, every joint that moves a coordinate. Of a joint: x y z "
    "its\n"
    "# origin in the axes of the parent. Of a link, in its own axes: m its mass, cx cy cz its "
    "centre\n"
    "# of mass, Ixx ... its inertia about that. Zeros of the URDF are 0, not parameters.\n";

/// Two cells: the name of a link, indented by its depth, and the text about the joint that carries
/// it.
std::vector<std::string> tree_row(std::size_t depth, const Link& link, const std::string& joint) {
  constexpr std::size_t deepest_indent = 20;  // the lines of a long chain would be too long
  const std::string indent(2 * std::min(depth, deepest_indent), ' ');
  return {"  " + indent + link.name.text + "  ", joint};
}

std::vector<std::vector<std::string>> tree_rows(const Robot& robot, const LinkTree& tree) {
  std::vector<std::vector<std::string>> rows{tree_row(0, robot.links[tree.root], "the world")};
  for (const Branch& branch : tree.branches) {
    const Joint& joint = robot.joints[branch.joint];
    std::string text = fmt::format("{}, {}", joint.name.text, type_word(joint.type));
    if (const auto& mimicked = tree.mimicked_joints[branch.joint]) {
      text += " like " + robot.joints[*mimicked].name.text;
    }
    if (joint.weld_position) text += ", welded at " + joint.weld_position->text;
    rows.push_back(tree_row(branch.depth + 1, robot.links[branch.child], text));
  }
  return rows;
}

std::string header_comment(const ModelDraft& draft, const LinkTree& tree) {
  const Robot& robot = draft.robot;
  std::string text = toml_comment(fmt::format("{}, imported from {}.", robot.name, robot.file)) +
                     "#\n" + comment_lines(align_columns(tree_rows(robot, tree)));
  text += legend;
  const std::vector<std::string>& renamed = draft.glossary.name_changes();
  return text + (renamed.empty() ? "" : "#\n") + comment_lines(renamed);
}

std::string model_table(const Robot& robot) {
  TomlTable table("[model]");
  table.add("name", toml_string(model_name(robot.model)));
  table.add("title", toml_string(robot.name));
  table.add("description",
            toml_string(
                fmt::format("Imported from {}; coordinates are those of its joints.", robot.file)));
  return "format = 1\n\n" + table.text();
}

std::string parameters_table(const std::vector<ParameterGroup>& groups) {
  std::string text =
      "[parameters]\ng = { value = 9.81, unit = \"m/s^2\", min = 0, max = 25, doc = \"gravity\" "
      "}\n";
  for (const ParameterGroup& group : groups) {
    if (group.rows.empty()) continue;
    text += fmt::format("\n{}{}\n", toml_comment(group.title),
                        fmt::join(align_columns(group.rows), "\n"));
  }
  return text;
}

std::string dissipation_table(const std::vector<std::string>& terms) {
  return fmt::format("[energy]\nD = \"\"\"\n  {}\n\"\"\"\n", fmt::join(terms, "\n  + "));
}

/// The texts of the tables in the order of `--joints`; without this option, in the order of the
/// tree.
std::vector<std::string> table_texts(const Robot& robot, std::vector<JointTable> tables) {
  const auto rank = [&](const JointTable& table) { return robot.joints[table.joint].rank; };
  std::ranges::stable_sort(tables, {}, rank);
  std::vector<std::string> result;
  for (const JointTable& table : tables) result.push_back(table.table.text());
  return result;
}

std::vector<JointTable> coordinate_tables(const ModelDraft& draft) {
  std::vector<JointTable> tables = draft.coordinates;
  for (JointTable& table : tables) {
    const auto armature = draft.armatures.find(table.joint);
    if (armature == draft.armatures.end()) continue;
    table.table.add("armature", toml_string(armature->second));
  }
  return tables;
}

std::string model_text(const ModelDraft& draft, const LinkTree& tree) {
  std::vector<std::string> parts{model_table(draft.robot)};
  const auto append = [&](const std::vector<std::string>& tables) {
    parts.insert(parts.end(), tables.begin(), tables.end());
  };
  append(table_texts(draft.robot, coordinate_tables(draft)));
  parts.push_back(parameters_table(draft.glossary.groups()));
  append(draft.link_tables);
  parts.emplace_back("[gravity]\nvector = [\"0\", \"0\", \"-g\"]\n");
  if (!draft.dissipation.empty()) parts.push_back(dissipation_table(draft.dissipation));
  append(draft.forces);
  append(table_texts(draft.robot, draft.inputs));
  return header_comment(draft, tree) + fmt::format("{}", fmt::join(parts, "\n"));
}

}  // namespace

std::string comment_lines(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += toml_comment(line);
  return text;
}

std::string vector_text(const Components& components) {
  std::vector<std::string> quoted;
  for (const std::string& component : components) quoted.push_back(toml_string(component));
  return toml_list(quoted);
}

std::string model_text(const Robot& robot, const LinkTree& tree) {
  ModelDraft draft{robot, tree, Glossary(robot, tree)};
  for (const Branch& branch : tree.branches) {
    draft.glossary.open_group(fmt::format("{}, on {}", robot.links[branch.child].name.text,
                                          robot.joints[branch.joint].name.text),
                              branch);
    const JointMotion motion = draft_joint(draft, branch);
    draft_frames(draft, branch, motion);
    if (branch.is_moving) draft_body(draft, branch.child);
  }
  return model_text(draft, tree);
}

}  // namespace elgen::urdf
