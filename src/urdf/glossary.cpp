// Coordinates are named first, then frames: where a joint and its link share a name, the joint
// keeps it.
#include "urdf/glossary.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/toml_text.hpp"

namespace elgen::urdf {

Glossary::Glossary(const Robot& robot, const LinkTree& tree)
    : frames_(robot.links.size()), joints_(robot.joints.size()) {
  for (const char* own : {"g", "world"}) names_.claim(own, "");
  for (const Branch& branch : tree.branches) {
    const Joint& joint = robot.joints[branch.joint];
    const std::string& name = joint.name.text;
    const bool is_coordinate =
        has_one_coordinate(joint.type) && joint.moves() && !tree.mimicked[branch.joint];
    joints_[branch.joint] = is_coordinate ? names_.claim(name, "joint") : well_formed(name);
    note_change(name, joints_[branch.joint]);
  }
  frames_[tree.root] = "world";
  for (const Branch& branch : tree.branches) {
    const std::string& name = robot.links[branch.child].name.text;
    frames_[branch.child] = names_.claim(name, "link");
    note_change(name, frames_[branch.child]);
  }
}

void Glossary::note_change(const std::string& from, const std::string& to) {
  const std::string change = fmt::format("`{}` is called {}", from, to);
  const bool is_known = std::find(renamed_.begin(), renamed_.end(), change) != renamed_.end();
  if (from != to && !is_known) renamed_.push_back(change);
}

void Glossary::open_group(std::string title) { groups_.push_back({std::move(title), {}}); }

std::string Glossary::parameter(const std::string& name, const FileNumber& number,
                                const std::string& unit, const std::string& more) {
  if (number.is_zero()) return "0";
  const std::string claimed = names_.claim(name, "parameter");
  const bool is_negative = number.text.front() == '-';  // then what `more` assumes is not so
  const bool has_more = !more.empty() && !is_negative;
  std::vector<std::string> row{
      claimed, fmt::format(" = {{ value = {}, ", toml_number(number.text)),
      fmt::format("unit = {}{}", toml_string(unit), has_more ? ", " : " }")};
  if (has_more) row.push_back(more + " }");
  groups_.back().rows.push_back(std::move(row));
  return claimed;
}

}  // namespace elgen::urdf
