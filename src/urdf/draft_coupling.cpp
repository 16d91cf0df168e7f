// A joint with one coordinate: its position, damping, friction and rotor. The terms are sums,
// products and quotients of short expressions.
#include <fmt/format.h>

#include "base/toml_text.hpp"
#include "urdf/draft.hpp"

namespace elgen::urdf {

namespace {

std::string ratio_unit(JointType type, JointType other) {
  const auto own = units_of(type).position;
  const auto others = units_of(other).position;
  return own == others ? "1" : fmt::format("{}/{}", own, others);
}

std::string ratio_of(Draft& draft, std::size_t index, JointType other) {
  const Joint& joint = draft.robot.joints[index];
  const FileNumber& ratio = joint.mimic->multiplier;
  const std::string unit = ratio_unit(joint.type, other);
  // 1 rad/m has a unit, so it stays a parameter
  const bool is_sign = unit == "1" && cln::abs(ratio.value) == 1;
  if (is_sign) return cln::minusp(ratio.value) ? "-1" : "1";
  return draft.glossary.parameter("ratio_" + draft.glossary.joint(index), ratio, unit);
}

Coupling mimic_coupling(Draft& draft, std::size_t index, std::size_t mimicked) {
  const Joint& joint = draft.robot.joints[index];
  const Coupling& other = coupling_of(draft, mimicked);
  const std::string ratio = ratio_of(draft, index, draft.robot.joints[mimicked].type);
  const std::string offset =
      draft.glossary.parameter("offset_" + draft.glossary.joint(index), joint.mimic->offset,
                               std::string(units_of(joint.type).position));
  return {other.coordinate, product_text(ratio, other.factor),
          sum_text(product_text(ratio, other.offset), offset)};
}

void draft_damping(Draft& draft, std::size_t index, const Coupling& coupling) {
  const Joint& joint = draft.robot.joints[index];
  const std::string damping = draft.glossary.parameter(
      "damping_" + draft.glossary.joint(index), joint.damping,
      std::string(units_of(joint.type).damping), "assume = \"nonnegative\"");
  if (damping == "0") return;
  const std::string plain = fmt::format("dot({})", coupling.coordinate);
  draft.dissipation.push_back(fmt::format(
      "1/2*{}*{}^2", damping, coupling.has_sign_only() ? plain : "(" + coupling.rate() + ")"));
}

/// Dry friction, smoothed: -friction*tanh(rate/stiction_rate).
void draft_friction(Draft& draft, std::size_t index, const Coupling& coupling) {
  const Joint& joint = draft.robot.joints[index];
  const std::string& name = draft.glossary.joint(index);
  const JointUnits units = units_of(joint.type);
  const std::string friction = draft.glossary.parameter(
      "friction_" + name, joint.friction, std::string(units.force), "assume = \"nonnegative\"");
  if (friction == "0") return;
  const FileNumber scale{"0.01", cln::cl_RA(1) / 100, {}};
  const std::string stiction_rate = draft.glossary.parameter(
      name + "_stiction_rate", scale, std::string(units.rate),
      "assume = \"positive\", doc = \"friction is full at some times this rate\"");
  const bool is_plain = coupling.has_sign_only();
  const std::string factor = is_plain ? "" : coupling.factor + "*";
  const std::string rate = is_plain ? fmt::format("dot({})", coupling.coordinate) : coupling.rate();
  TomlTable table("[[force]]");
  table.add("on", toml_string(coupling.coordinate));
  table.add("value",
            toml_string(fmt::format("-{}{}*tanh({}/{})", factor, friction, rate, stiction_rate)));
  draft.forces.push_back(table.text());
}

/// Adds the armature of a rotor to its coordinate: J N^2 times (d joint/d coordinate)^2.
void draft_rotor(Draft& draft, std::size_t index, const Coupling& coupling) {
  const Joint& joint = draft.robot.joints[index];
  if (!has_rotor(joint)) return;
  const std::string& name = draft.glossary.joint(index);
  std::string armature = draft.glossary.parameter("rotor_" + name, joint.rotor->inertia, "kg*m^2",
                                                  "assume = \"positive\"");
  const bool slides = joint.type == JointType::prismatic;
  const FileNumber& ratio = joint.rotor->gear_ratio;
  if (slides || ratio.value != 1) {
    armature = product_text(
        armature, draft.glossary.parameter("gear_" + name, ratio, slides ? "rad/m" : "1") + "^2");
  }
  if (!coupling.has_sign_only()) armature += fmt::format("*({})^2", coupling.factor);
  std::string& sum_of_all =
      draft.armatures.try_emplace(draft.tree.leader(index), "0").first->second;
  sum_of_all = sum_text(sum_of_all, armature);
}

/// The position at which a joint is held, as a parameter or expression.
std::string held_position_text(Draft& draft, std::size_t index) {
  const Joint& joint = draft.robot.joints[index];
  if (joint.type != JointType::prismatic) {
    return angle_of(*joint.welded, draft.robot.digits).text;
  }
  return draft.glossary.parameter("at_" + draft.glossary.joint(index), *joint.welded, "m");
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

JointUnits units_of(JointType type) {
  if (type == JointType::prismatic) return {"m", "m/s", "N", "N*s/m"};
  return {"rad", "rad/s", "N*m", "N*m*s"};
}

const Coupling& coupling_of(Draft& draft, std::size_t joint) {
  const auto known = draft.couplings.find(joint);
  if (known != draft.couplings.end()) return known->second;
  const auto& mimicked = draft.tree.mimicked[joint];
  const bool is_welded = draft.robot.joints[joint].welded.has_value();
  Coupling coupling = is_welded  ? Coupling{{}, "0", held_position_text(draft, joint)}
                      : mimicked ? mimic_coupling(draft, joint, *mimicked)
                                 : Coupling{draft.glossary.joint(joint)};
  return draft.couplings.emplace(joint, std::move(coupling)).first->second;
}

void draft_resistance(Draft& draft, std::size_t joint) {
  const Coupling& coupling = coupling_of(draft, joint);
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

std::string negated(const std::string& expression) {
  if (expression == "0") return expression;
  if (is_sum(expression)) return "-" + parenthesise(expression);
  return expression.front() == '-' ? expression.substr(1) : "-" + expression;
}

std::string product_text(const std::string& factor, const std::string& expression) {
  if (factor == "0" || expression == "0") return "0";
  if (factor == "1") return expression;
  if (factor == "-1") return negated(expression);
  if (expression == "1") return factor;
  if (expression == "-1") return negated(factor);
  return factor + "*" + parenthesise_factor(expression);
}

std::string quotient(const std::string& expression, const std::string& divisor) {
  if (expression == "0" || divisor == "1") return expression;
  return (is_sum(expression) ? parenthesise(expression) : expression) + "/" + divisor;
}

std::string Coupling::position() const {
  return sum_text(product_text(factor, coordinate), offset);
}

std::string Coupling::rate() const {
  return product_text(factor, fmt::format("dot({})", coordinate));
}

}  // namespace elgen::urdf
