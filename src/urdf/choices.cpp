// Applies options to a robot: holds ("welds") joints at a position, and orders the moving joints. A
// robot that should float gets a new root link, and a floating joint from the new to the old root.
#include "urdf/choices.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "elgen/wording.hpp"
#include "parse/decimal.hpp"

namespace elgen::urdf {

namespace {

constexpr std::string_view massless = "massless";

Span subspan(const SourcePointer& source, std::size_t begin, std::size_t end) {
  return {source.get(), static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
}

/// The words between commas.
std::vector<Span> split_words(const SourcePointer& source) {
  std::vector<Span> words;
  const std::string& text = source->text;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    words.push_back(subspan(source, begin, end));
    begin = end + 1;
  }
  return words;
}

/// The position closest to 0 in the range of the joint.
FileNumber position_nearest_zero(const Joint& joint) {
  const auto& [lower, upper, velocity, effort] = joint.limit;
  const bool is_limited = joint.type != JointType::continuous && lower && upper;
  if (is_limited && cln::plusp(lower->value)) return *lower;
  return is_limited && cln::minusp(upper->value) ? *upper : FileNumber{};
}

class JointChooser {
 public:
  JointChooser(Robot& robot, const Limits& limits) : robot_(robot), limits_(limits) {}

  Diagnostics choose(const ImportOptions& options) {
    for (const SourcePointer& weld : options.welds) {
      if (weld->text != massless) read_weld(weld);
    }
    std::size_t rank = 0;
    for (const SourcePointer& list : options.joints) {
      for (const Span& name : split_words(list)) keep_joint(name, ++rank);
    }
    if (!options.joints.empty()) weld_other_joints();
    weld_mimics_of_welded(robot_);
    return found_;
  }

 private:
  /// The moving joint with this name; null after E821.
  Joint* find_moving_joint(const Span& name) {
    const std::string text(covered_text(name));
    std::vector<std::string> names;
    for (Joint& joint : robot_.joints) {
      if (joint.name.text != text) {
        if (joint.moves()) names.push_back(joint.name.text);
        continue;
      }
      if (joint.moves()) return &joint;
      report_joint_error(name, fmt::format("{} is {}", quote_text(text),
                                           joint.weld_position ? "welded" : type_word(joint.type)));
      return nullptr;
    }
    report_joint_error(name, fmt::format("the robot has no joint {}", quote_text(text)),
                       suggestion(text, names));
    return nullptr;
  }

  void report_joint_error(const Span& span, std::string message, std::string hint = {}) {
    found_.push_back({Code::E821, span, std::move(message), std::move(hint)});
  }

  void read_weld(const SourcePointer& weld) {
    const std::size_t size = weld->text.size();
    const std::size_t equals = std::min(weld->text.find('='), size);
    Joint* joint = find_moving_joint(subspan(weld, 0, equals));
    if (joint == nullptr) return;
    joint->weld_position = FileNumber{};
    if (equals == size) return;
    const Span value = subspan(weld, equals + 1, size);
    const Result<FileNumber> number = read_decimal(value, limits_);
    found_.insert(found_.end(), number.diagnostics.begin(), number.diagnostics.end());
    if (number) joint->weld_position = *number;
    if (number && !number->is_zero() && !has_one_coordinate(joint->type)) {
      report_joint_error(value, fmt::format("{} is {}, so it can be fixed only at 0",
                                            quote_text(joint->name.text), type_word(joint->type)));
    }
  }

  void keep_joint(const Span& name, std::size_t rank) {
    Joint* joint = find_moving_joint(name);
    if (joint == nullptr) return;
    if (joint->mimic) {
      const std::string leader = joint->mimic->joint.text;
      return report_joint_error(
          name, fmt::format("{} mimics {}", quote_text(joint->name.text), quote_text(leader)),
          fmt::format("it moves with {}", quote_text(leader)));
    }
    if (joint->rank != 0) {
      return report_joint_error(name,
                                fmt::format("{} is named twice", quote_text(joint->name.text)));
    }
    joint->rank = rank;
  }

  void weld_other_joints() {
    for (Joint& joint : robot_.joints) {
      if (!joint.moves() || joint.mimic || joint.rank != 0) continue;
      joint.weld_position = position_nearest_zero(joint);
      if (joint.weld_position->is_zero()) continue;
      found_.push_back(
          {Code::E820, joint.name.span,
           fmt::format("{} is held at {}", quote_text(joint.name.text), joint.weld_position->text),
           fmt::format("its limits are {} to {}", joint.limit.lower->text,
                       joint.limit.upper->text)});
    }
  }

  Robot& robot_;
  const Limits& limits_;
  Diagnostics found_ = {};
};

/// The position of a joint that mimics a held joint; none for other joints.
std::optional<FileNumber> mimicked_weld_position(const Robot& robot, const Joint& joint) {
  if (!joint.mimic || !joint.moves() || !has_one_coordinate(joint.type)) return std::nullopt;
  const auto is_mimicked = [&](const Joint& other) {
    return other.name.text == joint.mimic->joint.text;
  };
  const auto other = std::ranges::find_if(robot.joints, is_mimicked);
  if (other == robot.joints.end() || !other->weld_position) return std::nullopt;
  const cln::cl_RA place =
      joint.mimic->multiplier.value * other->weld_position->value + joint.mimic->offset.value;
  return FileNumber{decimal_text(place), place, {}};
}

/// `wanted`; if an element already has this name, a number is appended.
template <class Named>
std::string unused_name(const std::vector<Named>& elements, const std::string& wanted) {
  std::string name = wanted;
  const auto is_used = [&](const Named& element) { return element.name.text == name; };
  for (int i = 2; std::ranges::any_of(elements, is_used); ++i) {
    name = wanted + "_" + std::to_string(i);
  }
  return name;
}

}  // namespace

Diagnostics apply_joint_options(Robot& robot, const ImportOptions& options, const Limits& limits) {
  return JointChooser(robot, limits).choose(options);
}

void weld_mimics_of_welded(Robot& robot) {
  constexpr int longest_chain = 100;
  bool has_changed = true;
  for (int round = 0; has_changed && round < longest_chain; ++round) {
    has_changed = false;
    for (Joint& joint : robot.joints) {
      const auto place = mimicked_weld_position(robot, joint);
      if (!place) continue;
      joint.weld_position = place;
      has_changed = true;
    }
  }
}

bool welds_massless_joints(const ImportOptions& options) {
  return std::ranges::any_of(options.welds,
                             [](const SourcePointer& weld) { return weld->text == massless; });
}

void add_floating_joint(Robot& robot, std::size_t root) {
  const SpannedText base = robot.links[root].name;
  const SpannedText world{unused_name(robot.links, "world"), base.span};
  Joint joint;
  joint.name = {unused_name(robot.joints, "base"), base.span};
  joint.type = JointType::floating;
  joint.parent = world;
  joint.child = base;
  robot.links.push_back({world, {}});
  robot.joints.push_back(std::move(joint));
}

const Joint* find_floating_joint(const Robot& robot, const LinkTree& tree) {
  std::vector<bool> is_base(robot.links.size());
  is_base[tree.root] = true;
  const Joint* floating = nullptr;
  bool base_has_mass = robot.links[tree.root].has_mass();
  for (const Branch& branch : tree.branches) {
    const Joint& joint = robot.joints[branch.joint];
    if (!is_base[branch.parent]) continue;
    if (joint.moves()) {
      if (joint.type == JointType::floating) floating = &joint;
      continue;
    }
    is_base[branch.child] = true;
    base_has_mass = base_has_mass || robot.links[branch.child].has_mass();
  }
  return base_has_mass ? nullptr : floating;
}

}  // namespace elgen::urdf
