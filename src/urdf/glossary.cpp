// Glossary: names coordinates first, then frames. If a joint and its link have the same name in the
// URDF, the joint therefore keeps the name.
#include "urdf/glossary.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "base/ascii.hpp"
#include "base/toml_text.hpp"
#include "check/names/reserved_names.hpp"

namespace elgen::urdf {

namespace {

/// Reserved, because parameters are members of a struct whose initialisers use these names.
constexpr std::array<std::string_view, 5> names_of_headers{"Parameters", "Scalar", "constant",
                                                           "detail", "std"};

bool is_reserved(const std::string& name) {
  return !reserved_reason(name).empty() ||
         std::ranges::find(names_of_headers, name) != names_of_headers.end();
}

/// False for "q", "q1" and "q_1", which are short enough to be symbols in formulas.
bool is_long(const std::string& name) { return name.size() > 1 && is_letter(name[1]); }

/// m_1 or I_{xx,1}
std::string with_subscript(std::string_view base, const std::string& script) {
  return fmt::format(fmt::runtime(script.size() == 1 ? "{}_{}" : "{}_{{{}}}"), base, script);
}

}  // namespace

std::string well_formed_name(std::string_view text) {
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

std::string NameRegistry::claim(std::string_view wanted, std::string_view kind) {
  std::string name = well_formed_name(wanted);
  if (is_reserved(name) || used_.count(name) > 0) name = std::string(kind) + "_" + name;
  const std::string stem = name;
  for (std::size_t i = 2; is_reserved(name) || !used_.insert(name).second; ++i) {
    name = stem + "_" + std::to_string(i);
  }
  return name;
}

std::string model_name(std::string_view robot) {
  std::string name = well_formed_name(robot);
  std::transform(name.begin(), name.end(), name.begin(), to_lower_case);
  return is_reserved(name) ? "robot_" + name : name;
}

Glossary::Glossary(const Robot& robot, const LinkTree& tree)
    : frames_(robot.links.size()), joints_(robot.joints.size()), numbers_(robot.joints.size()) {
  std::vector<std::size_t> coordinates;
  for (const char* own : {"g", "world"}) names_.claim(own, "");
  for (const Branch& branch : tree.branches) {
    const Joint& joint = robot.joints[branch.joint];
    const std::string& name = joint.name.text;
    const bool is_coordinate =
        has_one_coordinate(joint.type) && joint.moves() && !tree.mimicked_joints[branch.joint];
    joints_[branch.joint] = is_coordinate ? names_.claim(name, "joint") : well_formed_name(name);
    if (is_coordinate) coordinates.push_back(branch.joint);
    record_name_change(name, joints_[branch.joint]);
  }
  frames_[tree.root] = "world";
  for (const Branch& branch : tree.branches) {
    const std::string& name = robot.links[branch.child].name.text;
    frames_[branch.child] = names_.claim(name, "link");
    record_name_change(name, frames_[branch.child]);
  }
  number_joints(robot, std::move(coordinates));
}

void Glossary::number_joints(const Robot& robot, std::vector<std::size_t> coordinates) {
  const auto name = [this](std::size_t joint) { return joints_[joint]; };
  if (std::ranges::none_of(coordinates, is_long, name)) return;
  const auto rank = [&](std::size_t joint) { return robot.joints[joint].rank; };
  std::ranges::stable_sort(coordinates, {}, rank);
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    numbers_[coordinates[i]] = std::to_string(i + 1);
  }
}

std::string Glossary::joint_symbol(std::size_t joint) const {
  return numbers_[joint].empty() ? "" : with_subscript("q", numbers_[joint]);
}

/// "Ixx_elbow" -> I_{xx,2}, "damping_elbow" -> \mathrm{damping}_2; empty for names of another form.
std::string Glossary::parameter_symbol(const std::string& name) const {
  const std::string& number = numbers_[open_.joint];
  const std::string& joint = joints_[open_.joint];
  if (number.empty()) return {};
  if (name == joint + "_stiction_rate") return with_subscript("\\mathrm{stiction}", number);
  const std::string stem = name.substr(0, name.find('_'));
  const std::string owner = name.substr(std::min(stem.size() + 1, name.size()));
  if (owner != joint && owner != frames_[open_.child]) return {};
  if (stem.size() > 3) return with_subscript("\\mathrm{" + stem + "}", number);
  return with_subscript(stem.substr(0, 1),
                        stem.size() > 1 ? stem.substr(1) + "," + number : number);
}

void Glossary::record_name_change(const std::string& from, const std::string& to) {
  const std::string change = fmt::format("`{}` is called {}", from, to);
  const bool is_known = std::ranges::find(name_changes_, change) != name_changes_.end();
  if (from != to && !is_known) name_changes_.push_back(change);
}

void Glossary::open_group(std::string title, const Branch& branch) {
  groups_.push_back({std::move(title), {}});
  open_ = branch;
}

std::string Glossary::add_parameter(const std::string& name, const FileNumber& number,
                                    const std::string& unit, const std::string& more) {
  if (number.is_zero()) return "0";
  const std::string claimed = names_.claim(name, "parameter");
  // a negative value contradicts `more`, which assumes a positive or nonnegative value
  const bool is_negative = number.text.front() == '-';
  std::vector<std::string> last;
  if (!more.empty() && !is_negative) last.push_back(more);
  const std::string symbol = parameter_symbol(name);
  if (!symbol.empty()) last.push_back(fmt::format("latex = '{}'", symbol));
  std::vector<std::string> row{
      claimed, fmt::format(" = {{ value = {}, ", toml_number(number.text)),
      fmt::format("unit = {}{}", toml_string(unit), last.empty() ? " }" : ", ")};
  if (!last.empty()) row.push_back(fmt::format("{} }}", fmt::join(last, ", ")));
  groups_.back().rows.push_back(std::move(row));
  return claimed;
}

}  // namespace elgen::urdf
