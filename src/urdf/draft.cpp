// A robot's tree, link by link, into the tables of a model.
#include "urdf/draft.hpp"

#include <fmt/format.h>

#include "urdf/drafting.hpp"

namespace elgen::urdf {

namespace {

TreeLine tree_line(const Robot& robot, const Branch& branch) {
  const Joint& joint = robot.joints[branch.joint];
  std::string text = fmt::format("{}, {}", joint.name.text, word(joint.type));
  if (branch.mimics) text += " like " + robot.joints[*branch.mimics].name.text;
  return {branch.depth + 1, robot.links[branch.child].name.text, text};
}

}  // namespace

Draft make_draft(const Robot& robot, const LinkTree& tree) {
  Draft draft;
  draft.name = model_name(robot.name);
  draft.title = robot.name;
  draft.file = robot.file;
  Glossary glossary(robot, tree);
  draft.renamed = glossary.renamed();
  Drafting drafting{robot, glossary, draft};
  draft.tree.push_back({0, robot.links[tree.root].name.text, "the world"});
  for (const Branch& branch : tree.branches) {
    draft.tree.push_back(tree_line(robot, branch));
    glossary.open_group(fmt::format("{}, on {}", robot.links[branch.child].name.text,
                                    robot.joints[branch.joint].name.text));
    const JointMotion motion = draft_joint(drafting, branch);
    LinkDraft link;
    link.frames = draft_frames(drafting, branch, motion);
    if (branch.moves) draft_body(drafting, branch.child, link);
    draft.links.push_back(std::move(link));
  }
  draft.parameters = glossary.take_groups();
  return draft;
}

}  // namespace elgen::urdf
