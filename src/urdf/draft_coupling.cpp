// Writes the model text of a joint with one coordinate: its position, damping, friction and rotor.
// Their expressions are sums, products and quotients of short expressions.
#include <fmt/format.h>

#include "base/toml_text.hpp"
#include "urdf/draft.hpp"

namespace elgen::urdf {

namespace {

std::string ratio_unit(JointType type, JointType other) {
  const auto own = joint_units(type).position;
  const auto others = joint_units(other).position;
  return own == others ? "1" : fmt::format("{}/{}", own, others);
}

std::string mimic_ratio(ModelDraft& draft, std::size_t index, JointType other) {
  const Joint& joint = draft.robot.joints[index];
  const FileNumber& ratio = joint.mimic->multiplier;
  const std::string unit = ratio_unit(joint.type, other);
  // 1 rad/m has a unit, so it stays a parameter
  const bool is_sign = unit == "1" && cln::abs(ratio.value) == 1;
  if (is_sign) return cln::minusp(ratio.value) ? "-1" : "1";
  return draft.glossary.add_parameter("ratio_" + draft.glossary.joint_name(index), ratio, unit);
}

Coupling mimic_coupling(ModelDraft& draft, std::size_t index, std::size_t mimicked) {
  const Joint& joint = draft.robot.joints[index];
  const Coupling& other = find_or_add_coupling(draft, mimicked);
  const std::string ratio = mimic_ratio(draft, index, draft.robot.joints[mimicked].type);
  const std::string offset = draft.glossary.add_parameter(
      "offset_" + draft.glossary.joint_name(index), joint.mimic->offset,
      std::string(joint_units(joint.type).position));
  return {other.coordinate, product_text(ratio, other.factor),
          sum_text(product_text(ratio, other.offset), offset)};
}

void draft_damping(ModelDraft& draft, std::size_t index, const Coupling& coupling) {
  const Joint& joint = draft.robot.joints[index];
  const std::string damping = draft.glossary.add_parameter(
      "damping_" + draft.glossary.joint_name(index), joint.damping,
      std::string(joint_units(joint.type).damping), "assume = \"nonnegative\"");
  if (damping == "0") return;
  const std::string plain = fmt::format("dot({})", coupling.coordinate);
  draft.dissipation.push_back(fmt::format(
      "1/2*{}*{}^2", damping, coupling.has_sign_only() ? plain : "(" + coupling.rate_text() + ")"));
}

/// Adds smoothed dry friction: the force -friction*tanh(rate/stiction_rate) along the joint.
void draft_friction(ModelDraft& draft, std::size_t index, const Coupling& coupling) {
  const Joint& joint = draft.robot.joints[index];
  const std::string& name = draft.glossary.joint_name(index);
  const JointUnits units = joint_units(joint.type);
  const std::string friction = draft.glossary.add_parameter(
      "friction_" + name, joint.friction, std::string(units.force), "assume = \"nonnegative\"");
  if (friction == "0") return;
  const FileNumber scale{"0.01", cln::cl_RA(1) / 100, {}};
  const std::string stiction_rate = draft.glossary.add_parameter(
      name + "_stiction_rate", scale, std::string(units.rate),
      "assume = \"positive\", doc = \"friction is full at some times this rate\"");
  const bool is_plain = coupling.has_sign_only();
  const std::string factor = is_plain ? "" : coupling.factor + "*";
  const std::string rate =
      is_plain ? fmt::format("dot({})", coupling.coordinate) : coupling.rate_text();
  TomlTable table("[[force]]");
  table.add("on", toml_string(coupling.coordinate));
  table.add("value",
            toml_string(fmt::format("-{}{}*tanh({}/{})", factor, friction, rate, stiction_rate)));
  draft.forces.push_back(table.text());
}

/// Adds J N^2 (d joint/d coordinate)^2 to the coordinate's armature; J rotor inertia, N gear ratio.
void draft_rotor(ModelDraft& draft, std::size_t index, const Coupling& coupling) {
  const Joint& joint = draft.robot.joints[index];
  if (!has_rotor(joint)) return;
  const std::string& name = draft.glossary.joint_name(index);
  std::string armature = draft.glossary.add_parameter("rotor_" + name, joint.rotor->inertia,
                                                      "kg*m^2", "assume = \"positive\"");
  const bool slides = joint.type == JointType::prismatic;
  const FileNumber& ratio = joint.rotor->gear_ratio;
  if (slides || ratio.value != 1) {
    armature = product_text(
        armature,
        draft.glossary.add_parameter("gear_" + name, ratio, slides ? "rad/m" : "1") + "^2");
  }
  if (!coupling.has_sign_only()) armature += fmt::format("*({})^2", coupling.factor);
  std::string& sum_of_all =
      draft.armatures.try_emplace(draft.tree.leader(index), "0").first->second;
  sum_of_all = sum_text(sum_of_all, armature);
}

/// The position at which a joint is held, as a parameter or expression.
std::string weld_position_text(ModelDraft& draft, std::size_t index) {
  const Joint& joint = draft.robot.joints[index];
  if (joint.type != JointType::prismatic) {
    return round_angle(*joint.weld_position, draft.robot.digits).text;
  }
  return draft.glossary.add_parameter("at_" + draft.glossary.joint_name(index),
                                      *joint.weld_position, "m");
}

std::string parenthesise(const std::string& expression) { return "(" + expression + ")"; }

/// True if the text has a space outside brackets: only the signs of sums have spaces around them.
bool is_sum(const std::string& expression) {
  int depth = 0;
  for (const char c : expression) {
    depth += (c == '(' ? 1 : 0) - (c == ')' ? 1 : 0);
    if (c == ' ' && depth == 0) return true;
  }
  return false;
}

std::string parenthesise_factor(const std::string& expression) {
  return is_sum(expression) || expression.front() == '-' ? parenthesise(expression) : expression;
}

}  // namespace

JointUnits joint_units(JointType type) {
  if (type == JointType::prismatic) return {"m", "m/s", "N", "N*s/m"};
  return {"rad", "rad/s", "N*m", "N*m*s"};
}

const Coupling& find_or_add_coupling(ModelDraft& draft, std::size_t joint) {
  const auto known = draft.couplings.find(joint);
  if (known != draft.couplings.end()) return known->second;
  const auto& mimicked = draft.tree.mimicked_joints[joint];
  const bool is_welded = draft.robot.joints[joint].weld_position.has_value();
  Coupling coupling = is_welded  ? Coupling{{}, "0", weld_position_text(draft, joint)}
                      : mimicked ? mimic_coupling(draft, joint, *mimicked)
                                 : Coupling{draft.glossary.joint_name(joint)};
  return draft.couplings.emplace(joint, std::move(coupling)).first->second;
}

void draft_joint_dynamics(ModelDraft& draft, std::size_t joint) {
  const Coupling& coupling = find_or_add_coupling(draft, joint);
  if (coupling.is_constant()) return;
  draft_damping(draft, joint, coupling);
  draft_friction(draft, joint, coupling);
  draft_rotor(draft, joint, coupling);
}

std::string sum_text(const std::string& left, const std::string& right) {
  if (left == "0") return right;
  if (right == "0") return left;
  if (right.front() == '-') return left + " - " + right.substr(1);
  return left + " + " + right;
}

std::string negated_text(const std::string& expression) {
  if (expression == "0") return expression;
  if (is_sum(expression)) return "-" + parenthesise(expression);
  return expression.front() == '-' ? expression.substr(1) : "-" + expression;
}

std::string product_text(const std::string& factor, const std::string& expression) {
  if (factor == "0" || expression == "0") return "0";
  if (factor == "1") return expression;
  if (factor == "-1") return negated_text(expression);
  if (expression == "1") return factor;
  if (expression == "-1") return negated_text(factor);
  return factor + "*" + parenthesise_factor(expression);
}

std::string quotient_text(const std::string& expression, const std::string& divisor) {
  if (expression == "0" || divisor == "1") return expression;
  return (is_sum(expression) ? parenthesise(expression) : expression) + "/" + divisor;
}

std::string Coupling::position_text() const {
  return sum_text(product_text(factor, coordinate), offset);
}

std::string Coupling::rate_text() const {
  return product_text(factor, fmt::format("dot({})", coordinate));
}

}  // namespace elgen::urdf
