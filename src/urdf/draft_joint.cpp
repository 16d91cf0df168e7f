// A joint: its coordinates, its inputs, and its motion.
#include <fmt/format.h>

#include "base/toml_text.hpp"
#include "urdf/draft.hpp"

namespace elgen::urdf {

namespace {

constexpr std::string_view full_turn = "[\"-pi\", \"pi\"]";

/// "[-87, 87]" for the limit 87; "" if the limit is absent or 0.
std::string symmetric_range(const std::optional<FileNumber>& limit) {
  if (!limit || limit->is_zero()) return {};
  return toml_list({toml_number("-" + limit->text), toml_number(limit->text)});
}

/// The length of an axis that is not along x, y or z: "sqrt(0.7^2 + 0.7^2)", or "1" if it is
/// exactly 1.
std::string length_text(const Vector& axis) {
  cln::cl_RA square = 0;
  std::string terms;
  for (const FileNumber& component : axis) {
    if (component.is_zero()) continue;
    square = square + component.value * component.value;
    const bool is_negative = cln::minusp(component.value);
    terms += (terms.empty() ? "" : " + ") +
             (is_negative ? negate_number(component) : component).text + "^2";
  }
  return square == 1 ? "1" : "sqrt(" + terms + ")";
}

/// The rotation about an axis as a list of one step; no step if the angle is "0".
std::vector<std::string> turn_about_axis(const std::string& angle, const Vector& xyz,
                                         AngleRounding digits) {
  if (angle == "0") return {};
  const Axis axis = snap_axis(xyz, digits);
  if (!axis.index) {
    return {turn_text(vector_text({xyz[0].text, xyz[1].text, xyz[2].text}), angle)};
  }
  return {turn_text(toml_string(axis_letter(*axis.index)),
                    axis.is_reversed ? negated_text(angle) : angle)};
}

Components slide_along_axis(const std::string& way, const Vector& xyz, AngleRounding digits) {
  Components result{"0", "0", "0"};
  const Axis axis = snap_axis(xyz, digits);
  if (axis.index) {
    result[*axis.index] = axis.is_reversed ? negated_text(way) : way;
    return result;
  }
  const std::string length = length_text(xyz);
  for (std::size_t i = 0; i < 3; ++i)
    result[i] = quotient_text(product_text(xyz[i].text, way), length);
  return result;
}

class JointDrafter {
 public:
  JointDrafter(ModelDraft& draft, const Branch& branch)
      : robot_(draft.robot),
        glossary_(draft.glossary),
        draft_(draft),
        branch_(branch),
        joint_(robot_.joints[branch.joint]),
        name_(glossary_.joint_name(branch.joint)) {}

  JointMotion draft() {
    switch (joint_.type) {
      case JointType::revolute:
      case JointType::continuous:
        return {
            {"0", "0", "0"},
            turn_about_axis(draft_single_coordinate().position_text(), joint_.axis, robot_.digits),
            {}};
      case JointType::prismatic:
        return {
            slide_along_axis(draft_single_coordinate().position_text(), joint_.axis, robot_.digits),
            {},
            {}};
      case JointType::floating:
        return draft_floating();
      case JointType::planar:
        return draft_planar();
      case JointType::fixed:
        return {};
    }
    return {};
  }

 private:
  [[nodiscard]] std::string doc() const {
    return fmt::format("{} joint: {} to {}", type_word(joint_.type),
                       robot_.links[branch_.parent].name.text,
                       robot_.links[branch_.child].name.text);
  }

  const Coupling& draft_single_coordinate() {
    const Coupling& coupling = find_or_add_coupling(draft_, branch_.joint);
    if (joint_.moves() && !draft_.tree.mimicked_joints[branch_.joint]) {
      draft_coordinate();
      add_input(name_, joint_.type != JointType::prismatic, symmetric_range(joint_.limit.effort));
    }
    draft_joint_dynamics(draft_, branch_.joint);
    return coupling;
  }

  /// Adds a coordinate of the joint. `range` and `rates` are TOML lists; these and `symbol` may be
  /// empty.
  void add_coordinate(const std::string& name, std::string_view unit, const std::string& symbol,
                      const std::string& range, const std::string& rates = {}) {
    TomlTable table("[[coordinate]]");
    table.add("name", toml_string(name));
    table.add(unit.empty() ? "kind" : "unit", toml_string(unit.empty() ? "rotation" : unit));
    if (!range.empty()) table.add("range", range);
    if (!rates.empty()) table.add("rate_range", rates);
    if (range == full_turn) table.add("wrap", "true");
    if (!symbol.empty()) table.add("latex", "'" + symbol + "'");
    table.add("doc", toml_string(doc()));
    draft_.coordinates.push_back({branch_.joint, std::move(table)});
  }

  void draft_coordinate() {
    const JointLimit& limit = joint_.limit;
    const FileNumber low = limit.lower.value_or(FileNumber{});
    const FileNumber high = limit.upper.value_or(FileNumber{});
    std::string range;
    if (joint_.type == JointType::continuous) {
      range = full_turn;
    } else if (low.value < high.value) {
      range = toml_list({low.text, high.text});
    }
    add_coordinate(name_, joint_units(joint_.type).position, glossary_.joint_symbol(branch_.joint),
                   range, symmetric_range(limit.velocity));
  }

  /// Adds a torque or force on a coordinate.
  void add_input(const std::string& coordinate, bool turns, const std::string& limits = {}) {
    TomlTable table("[[input]]");
    table.add("name", toml_string(glossary_.claim((turns ? "tau_" : "f_") + coordinate, "input")));
    table.add("unit", toml_string(turns ? "N*m" : "N"));
    table.add("on", toml_string(coordinate));
    if (!limits.empty()) table.add("limits", limits);
    table.add("doc",
              toml_string(fmt::format("{} of {}", turns ? "torque" : "force", joint_.name.text)));
    draft_.inputs.push_back({branch_.joint, std::move(table)});
  }

  /// Adds a coordinate and returns its name: the joint's name with the suffix `end`. The coordinate
  /// is called `symbol` in formulas, without a joint number.
  std::string draft_extra_coordinate(const std::string& end, const std::string& unit,
                                     const std::string& symbol) {
    const std::string name = glossary_.claim(name_ + "_" + end, "joint");
    add_coordinate(name, unit, symbol, std::string(unit == "rad" ? full_turn : ""));
    return name;
  }

  JointMotion draft_floating() {
    JointMotion motion;
    if (joint_.weld_position) return motion;
    for (std::size_t i = 0; i < 3; ++i) {
      motion.translate[i] = draft_extra_coordinate(axis_letter(i), "m", axis_letter(i));
    }
    motion.attitude = draft_extra_coordinate("attitude", "", "e");
    return motion;
  }

  JointMotion draft_planar() {
    const std::size_t normal = *snap_axis(joint_.axis, AngleRounding::round).index;
    JointMotion motion;
    if (joint_.weld_position) return motion;
    for (const std::size_t i : {(normal + 1) % 3, (normal + 2) % 3}) {
      const std::string name = draft_extra_coordinate(axis_letter(i), "m", axis_letter(i));
      motion.translate[i] = name;
      add_input(name, false);
    }
    if (joint_.is_angle_welded) return motion;
    const std::string angle = draft_extra_coordinate("angle", "rad", "\\varphi");
    add_input(angle, true);
    motion.turn = turn_about_axis(angle, joint_.axis, robot_.digits);
    return motion;
  }

  const Robot& robot_;
  Glossary& glossary_;
  ModelDraft& draft_;
  const Branch& branch_;
  const Joint& joint_;
  const std::string& name_;
};

}  // namespace

std::string axis_letter(std::size_t axis) { return std::string(1, "xyz"[axis]); }

JointMotion draft_joint(ModelDraft& draft, const Branch& branch) {
  return JointDrafter(draft, branch).draft();
}

}  // namespace elgen::urdf
