// import_urdf: XML -> Robot -> LinkTree -> ModelDraft -> text.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "elgen/urdf.hpp"
#include "elgen/wording.hpp"
#include "urdf/choices.hpp"
#include "urdf/draft.hpp"

namespace elgen {

namespace urdf {

namespace {

void append_diagnostics(Diagnostics& to, const Diagnostics& more) {
  to.insert(to.end(), more.begin(), more.end());
}

/// The tree after adding a floating joint above the root: because no joint moves (E818), or because
/// the user asks for it; E821 if the robot floats already.
Result<LinkTree> make_floating_tree(Robot& robot, const LinkTree& tree, bool is_asked_for,
                                    Diagnostics& found) {
  const SpannedText& root = robot.links[tree.root].name;
  if (!is_asked_for) {
    found.push_back({Code::E818, root.span, fmt::format("{} floats", quote_text(root.text)),
                     "no joint of the robot moves"});
  } else if (const Joint* joint = find_floating_joint(robot, tree)) {
    found.push_back({Code::E821, joint->name.span,
                     fmt::format("{} floats already", quote_text(joint->name.text)),
                     "omit `--floating-base`"});
    return found;
  }
  add_floating_joint(robot, tree.root);
  return make_tree(robot);
}

/// The tree after all options are applied. Options are not applied after an error.
Result<LinkTree> make_tree_with_options(Robot& robot, const ImportOptions& options,
                                        Diagnostics& found) {
  Result<LinkTree> tree = make_tree(robot);
  append_diagnostics(found, tree.diagnostics);
  if (!tree || has_errors(found)) return tree;
  if (welds_massless_joints(options)) {
    append_diagnostics(found, weld_massless_joints(robot, *tree));
    tree = make_tree(robot);
  }
  const bool floats = options.floating_base || (!tree->has_moving_link() && has_mass(robot));
  return floats ? make_floating_tree(robot, *tree, options.floating_base, found) : tree;
}

/// Keeps only the errors E802: the file has another format, or contains macros that are not
/// expanded.
Diagnostics keep_foreign_errors(Diagnostics found) {
  std::erase_if(found, [](const Diagnostic& diagnostic) { return diagnostic.code != Code::E802; });
  return found;
}

}  // namespace

}  // namespace urdf

Result<ImportedModel> import_urdf(const SourcePointer& source, const Limits& limits,
                                  const ImportOptions& options) {
  const Result<urdf::Element> root = urdf::read_xml(*source);
  if (!root) return root.diagnostics;
  Diagnostics found;
  urdf::RobotReadState reading{limits, found, options.file};
  urdf::Robot robot = urdf::read_robot(*root, reading);
  const Diagnostics foreign = urdf::keep_foreign_errors(found);
  if (!foreign.empty()) return foreign;
  if (!options.name.empty()) robot.model = options.name;
  if (options.exact_angles) robot.digits = urdf::AngleRounding::exact;
  urdf::append_diagnostics(found, urdf::apply_joint_options(robot, options, limits));
  const bool is_read = !has_errors(found);
  const Result<urdf::LinkTree> tree = urdf::make_tree_with_options(robot, options, found);
  if (is_read && tree) {
    urdf::append_diagnostics(found, urdf::check_masses(robot, *tree));
    urdf::append_diagnostics(found, urdf::report_rounded_angles(robot, *tree));
  }
  sort_by_position(found);
  if (has_errors(found)) return found;
  return {ImportedModel{urdf::model_text(robot, *tree), urdf::model_name(robot.model)},
          std::move(found)};
}

}  // namespace elgen
