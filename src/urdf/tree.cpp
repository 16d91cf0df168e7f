// Converts names to indices, and joins the links to a tree.
#include "urdf/tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "elgen/wording.hpp"

namespace elgen::urdf {

namespace {

using Indices = std::map<std::string, std::size_t>;

std::vector<std::string> names_of(const Indices& indices) {
  std::vector<std::string> names;
  for (const auto& [name, index] : indices) names.push_back(name);
  return names;
}

/// The error at a second element if only one is allowed. The error also shows the first element.
Diagnostic duplicate_error(Code code, const Span& span, std::string message, const Span& first) {
  return {code, span, std::move(message), {}, first, "the first is here"};
}

/// The index of every element by its name; E807 for a duplicate. Missing names are already
/// reported.
template <class Named>
Indices index_by_name(const std::vector<Named>& elements, std::string_view noun,
                      Diagnostics& found) {
  Indices indices;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const SpannedText& name = elements[i].name;
    const auto [first, is_new] = indices.emplace(name.text, i);
    if (is_new || name.text.empty()) continue;
    found.push_back(duplicate_error(Code::E807, name.span,
                                    fmt::format("{} names two {}s", quote_text(name.text), noun),
                                    elements[first->second].name.span));
  }
  indices.erase("");
  return indices;
}

/// The joint that a joint mimics; none after E812.
std::optional<std::size_t> find_mimicked(const Joint& joint, const Robot& robot,
                                         const Indices& joints, Diagnostics& found) {
  if (!joint.mimic || joint.weld_position || joint.mimic->joint.text.empty()) return std::nullopt;
  const SpannedText& name = joint.mimic->joint;
  const auto other = joints.find(name.text);
  if (other == joints.end()) {
    found.push_back({Code::E812, name.span,
                     fmt::format("the robot has no joint {}", quote_text(name.text)),
                     suggestion(name.text, names_of(joints))});
    return std::nullopt;
  }
  for (const Joint* one : {&joint, &robot.joints[other->second]}) {
    if (has_one_coordinate(one->type)) continue;
    found.push_back({Code::E812, name.span,
                     fmt::format("{} is {}: it has no coordinate to share",
                                 quote_text(one->name.text), type_word(one->type)),
                     fmt::format("`--weld {}` fixes the joint that mimics", joint.name.text)});
    return std::nullopt;
  }
  return other->second;
}

class TreeBuilder {
 public:
  explicit TreeBuilder(const Robot& robot)
      : robot_(robot),
        links_(index_by_name(robot.links, "link", found_)),
        joints_(index_by_name(robot.joints, "joint", found_)),
        joint_above_(robot.links.size()),
        joints_below_(robot.links.size()) {}

  Result<LinkTree> build() {
    for (std::size_t i = 0; i < robot_.joints.size(); ++i) connect(i);
    if (is_connected_ && !has_errors(found_)) find_root();
    if (is_connected_ && !has_errors(found_)) build_branches();
    tree_.mimicked_joints.resize(robot_.joints.size());
    for (const Branch& branch : tree_.branches) {
      const Joint& joint = robot_.joints[branch.joint];
      tree_.mimicked_joints[branch.joint] = find_mimicked(joint, robot_, joints_, found_);
    }
    for (const Branch& branch : tree_.branches) check_mimic_chain(branch.joint);
    if (has_errors(found_)) return found_;
    return tree_;
  }

 private:
  void connect(std::size_t index) {
    const Joint& joint = robot_.joints[index];
    const auto parent = find_link(joint.parent);
    const auto child = find_link(joint.child);
    if (!parent || !child) return;
    if (const auto& first = joint_above_[*child]) {
      found_.push_back(duplicate_error(
          Code::E809, joint.child.span,
          fmt::format("{} is the child of two joints", quote_text(joint.child.text)),
          robot_.joints[*first].child.span));
      return;
    }
    joint_above_[*child] = index;
    joints_below_[*parent].push_back(index);
  }

  std::optional<std::size_t> find_link(const SpannedText& name) {
    is_connected_ = is_connected_ && !name.text.empty();
    if (name.text.empty()) return std::nullopt;  // E803 is already reported
    const auto link = links_.find(name.text);
    if (link != links_.end()) return link->second;
    found_.push_back({Code::E808, name.span,
                      fmt::format("the robot has no link {}", quote_text(name.text)),
                      suggestion(name.text, names_of(links_))});
    return std::nullopt;
  }

  void find_root() {
    std::optional<std::size_t> root;
    for (std::size_t i = 0; i < robot_.links.size(); ++i) {
      if (joint_above_[i]) continue;
      if (!root) {
        root = i;
        continue;
      }
      const SpannedText& name = robot_.links[i].name;
      found_.push_back(duplicate_error(
          Code::E809, name.span,
          fmt::format("{} is a second root link: no joint leads to it", quote_text(name.text)),
          robot_.links[*root].name.span));
    }
    tree_.root = root.value_or(0);
    if (robot_.links.empty()) {
      found_.push_back({Code::E803, robot_.span, "`<robot>` has no element `link`",
                        robot_.uses_xacro
                            ? "xacro expanded no macro here: expand the file that calls them"
                            : ""});
    } else if (!root) {
      report_loop(0);
    }
  }

  /// Appends the branches depth first, children in the order of the file.
  void build_branches() {
    std::vector<Branch> open;
    const auto open_below = [&](std::size_t link, std::size_t depth, bool moves) {
      const auto& below = joints_below_[link];
      for (auto joint = below.rbegin(); joint != below.rend(); ++joint) {
        const Joint& next = robot_.joints[*joint];
        open.push_back({*joint, link, links_.at(next.child.text), depth, moves || next.moves()});
      }
    };
    std::vector<bool> reached(robot_.links.size());
    reached[tree_.root] = true;
    open_below(tree_.root, 0, false);
    while (!open.empty()) {
      const Branch branch = open.back();
      open.pop_back();
      tree_.branches.push_back(branch);
      reached[branch.child] = true;
      open_below(branch.child, branch.depth + 1, branch.is_moving);
    }
    const auto left = std::find(reached.begin(), reached.end(), false);
    if (left != reached.end()) report_loop(static_cast<std::size_t>(left - reached.begin()));
  }

  /// Reports E809 for the loop of joints above `link`. No joints connect `link` to a root.
  void report_loop(std::size_t link) {
    std::set<std::size_t> seen;
    while (seen.insert(link).second) link = parent_of(link);
    const SpannedText& last = robot_.joints[*joint_above_[link]].child;
    std::string way = last.text;
    for (std::size_t up = parent_of(link); up != link; up = parent_of(up)) {
      way = fmt::format("{} -> {}", robot_.links[up].name.text, way);
    }
    found_.push_back(
        {Code::E809, last.span, fmt::format("the joints form a loop: {} -> {}", last.text, way)});
  }

  std::size_t parent_of(std::size_t link) const {
    return links_.at(robot_.joints[*joint_above_[link]].parent.text);
  }

  /// E812 if a joint mimics itself through other joints, or if the chain of mimics is too long.
  void check_mimic_chain(std::size_t index) {
    constexpr int longest_chain = 100;  // the expressions grow with the length of the chain
    std::optional<std::size_t> at = tree_.mimicked_joints[index];
    for (int length = 1; at && *at != index && length < longest_chain; ++length) {
      at = tree_.mimicked_joints[*at];
    }
    if (!at) return;
    const Joint& joint = robot_.joints[index];
    found_.push_back({Code::E812, joint.mimic->joint.span,
                      *at == index ? fmt::format("{} mimics itself", quote_text(joint.name.text))
                                   : fmt::format("{} mimics through {} joints or more",
                                                 quote_text(joint.name.text), longest_chain)});
  }

  const Robot& robot_;
  Diagnostics found_ = {};
  Indices links_;
  Indices joints_;
  std::vector<std::optional<std::size_t>> joint_above_;  ///< by link
  std::vector<std::vector<std::size_t>> joints_below_;
  bool is_connected_ = true;  ///< every joint names its parent and child
  LinkTree tree_ = {};
};

}  // namespace

Result<LinkTree> make_tree(const Robot& robot) { return TreeBuilder(robot).build(); }

}  // namespace elgen::urdf
