// import_urdf: XML -> Robot -> Tree -> Draft -> text.
#include <utility>

#include "elgen/urdf.hpp"
#include "urdf/draft.hpp"

namespace elgen {

namespace {

void append(Diagnostics& to, const Diagnostics& more) {
  to.insert(to.end(), more.begin(), more.end());
}

}  // namespace

Result<ImportedModel> import_urdf(const SourcePointer& source, const Limits& limits) {
  const Result<urdf::Element> root = urdf::read_xml(*source);
  if (!root) return root.diagnostics;
  Diagnostics found;
  urdf::RobotReading reading{limits, found};
  const urdf::Robot robot = urdf::read_robot(*root, reading);
  const bool is_read = !has_errors(found);
  Result<urdf::LinkTree> tree;
  if (root->name == "robot") tree = urdf::make_tree(robot);
  append(found, tree.diagnostics);
  if (is_read && tree) append(found, urdf::check_masses(robot, *tree));
  sort_by_position(found);
  if (has_errors(found)) return found;
  return {{urdf::model_text(robot, *tree)}, std::move(found)};
}

}  // namespace elgen
