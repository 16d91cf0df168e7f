// Coordinates are named first, then frames: where a joint and its link share a name, the joint
// keeps it.
#include "urdf/glossary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/ascii.hpp"
#include "base/toml_text.hpp"
#include "check/names/reserved_names.hpp"

namespace elgen::urdf {

namespace {

/// A parameter is a member of a struct, whose initialisers call these.
constexpr std::array<std::string_view, 5> names_of_headers{"Parameters", "Scalar", "constant",
                                                           "detail", "std"};

bool is_reserved(const std::string& name) {
  return !reserved_reason(name).empty() ||
         std::find(names_of_headers.begin(), names_of_headers.end(), name) !=
             names_of_headers.end();
}

}  // namespace

std::string well_formed(std::string_view text) {
  std::string name;
  for (const char c : text) {
    if (is_letter(c) || is_digit(c)) {
      name += c;
    } else if (!name.empty() && name.back() != '_') {
      name += '_';
    }
  }
  while (!name.empty() && name.back() == '_') name.pop_back();
  if (name.empty()) return "unnamed";
  return is_digit(name.front()) ? "n" + name : name;
}

std::string Names::claim(std::string_view wanted, std::string_view kind) {
  std::string name = well_formed(wanted);
  if (is_reserved(name) || taken_.count(name) > 0) name = std::string(kind) + "_" + name;
  const std::string stem = name;
  for (std::size_t i = 2; is_reserved(name) || !taken_.insert(name).second; ++i) {
    name = stem + "_" + std::to_string(i);
  }
  return name;
}

std::string model_name(std::string_view robot) {
  std::string name = well_formed(robot);
  std::transform(name.begin(), name.end(), name.begin(), in_lower_case);
  return is_reserved(name) ? "robot_" + name : name;
}

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
