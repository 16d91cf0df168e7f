// A joint: its coordinates, and the forces along them.
#include <fmt/format.h>

#include "urdf/drafting.hpp"

namespace elgen::urdf {

namespace {

/// Units of what belongs to a coordinate that turns or slides.
struct JointUnits {
  std::string_view position;
  std::string_view rate;
  std::string_view force;
  std::string_view damping;
};

JointUnits units_of(JointType type) {
  if (type == JointType::prismatic) return {"m", "m/s", "N", "N*s/m"};
  return {"rad", "rad/s", "N*m", "N*m*s"};
}

std::string ratio_unit(JointType type, JointType other) {
  const auto own = units_of(type).position;
  const auto others = units_of(other).position;
  return own == others ? "1" : fmt::format("{}/{}", own, others);
}

class JointDrafter {
 public:
  JointDrafter(Drafting& drafting, const Branch& branch)
      : robot_(drafting.robot),
        glossary_(drafting.glossary),
        draft_(drafting.draft),
        branch_(branch),
        joint_(robot_.joints[branch.joint]),
        name_(glossary_.joint(branch.joint)) {}

  JointMotion draft() {
    switch (joint_.type) {
      case JointType::revolute:
      case JointType::continuous: {
        const Coupling coupling = draft_coupling();
        return {{"0", "0", "0"}, {turn_by(coupling.position())}, {}};
      }
      case JointType::prismatic:
        return {slide_by(draft_coupling().position()), {}, {}};
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
    return fmt::format("{} joint: {} to {}", word(joint_.type),
                       robot_.links[branch_.parent].name.text,
                       robot_.links[branch_.child].name.text);
  }

  Coupling draft_coupling() {
    const Coupling coupling = branch_.mimics ? mimicked() : Coupling{name_};
    if (!branch_.mimics) {
      draft_coordinate();
      draft_input();
    }
    draft_damping(coupling);
    draft_friction(coupling);
    return coupling;
  }

  Coupling mimicked() {
    const Joint& other = robot_.joints[*branch_.mimics];
    Coupling coupling{glossary_.joint(*branch_.mimics)};
    const FileNumber& factor = joint_.mimic->multiplier;
    const std::string unit = ratio_unit(joint_.type, other.type);
    const bool is_sign = unit == "1" && cln::abs(factor.value) == 1;  // 1 rad/m is no 1
    coupling.factor = is_sign ? (cln::minusp(factor.value) ? "-1" : "1")
                              : glossary_.parameter("ratio_" + name_, factor, unit);
    coupling.offset = glossary_.parameter("offset_" + name_, joint_.mimic->offset,
                                          std::string(units_of(joint_.type).position));
    return coupling;
  }

  void draft_coordinate() {
    CoordinateDraft coordinate{name_, std::string(units_of(joint_.type).position), doc()};
    const JointLimit& limit = joint_.limit;
    const FileNumber low = limit.lower.value_or(FileNumber{});
    const FileNumber high = limit.upper.value_or(FileNumber{});
    coordinate.wraps = joint_.type == JointType::continuous;
    if (coordinate.wraps) {
      coordinate.low = "\"-pi\"";
      coordinate.high = "\"pi\"";
    } else if (low.value < high.value) {
      coordinate.low = low.text;
      coordinate.high = high.text;
    }
    if (limit.velocity && !limit.velocity->is_zero()) coordinate.rate = limit.velocity->text;
    draft_.coordinates.push_back(std::move(coordinate));
  }

  void draft_input() {
    const bool slides = joint_.type == JointType::prismatic;
    InputDraft input{glossary_.claim((slides ? "f_" : "tau_") + name_, "input"),
                     std::string(units_of(joint_.type).force), name_};
    const auto& effort = joint_.limit.effort;
    if (effort && !effort->is_zero()) input.limit = effort->text;
    input.doc = fmt::format("{} of {}", slides ? "force" : "torque", joint_.name.text);
    draft_.inputs.push_back(std::move(input));
  }

  void draft_damping(const Coupling& coupling) {
    const std::string damping =
        glossary_.parameter("damping_" + name_, joint_.damping,
                            std::string(units_of(joint_.type).damping), "assume = \"nonnegative\"");
    if (damping == "0" || coupling.factor == "0") return;
    const std::string plain = fmt::format("dot({})", coupling.coordinate);
    const bool is_plain = coupling.factor == "1" || coupling.factor == "-1";
    draft_.dissipation.push_back(
        fmt::format("1/2*{}*{}^2", damping, is_plain ? plain : "(" + coupling.rate() + ")"));
  }

  /// Dry friction, made smooth: -friction*tanh(rate/stiction_rate).
  void draft_friction(const Coupling& coupling) {
    const std::string friction =
        glossary_.parameter("friction_" + name_, joint_.friction,
                            std::string(units_of(joint_.type).force), "assume = \"nonnegative\"");
    if (friction == "0" || coupling.factor == "0") return;
    const FileNumber scale{"0.01", cln::cl_RA(1) / 100, {}};
    const std::string stiction_rate = glossary_.parameter(
        name_ + "_stiction_rate", scale, std::string(units_of(joint_.type).rate),
        "assume = \"positive\", doc = \"friction is full at some times this rate\"");
    const bool is_plain = coupling.factor == "1" || coupling.factor == "-1";
    const std::string factor = is_plain ? "" : coupling.factor + "*";
    const std::string rate =
        is_plain ? fmt::format("dot({})", coupling.coordinate) : coupling.rate();
    draft_.forces.push_back({coupling.coordinate, fmt::format("-{}{}*tanh({}/{})", factor, friction,
                                                              rate, stiction_rate)});
  }

  [[nodiscard]] AxisAngle turn_by(const std::string& angle) const {
    const Axis axis = axis_of(joint_.axis);
    if (axis.along) {
      return {{axis_letter(*axis.along), "", ""}, axis.is_reversed ? negated(angle) : angle};
    }
    return {{joint_.axis[0].text, joint_.axis[1].text, joint_.axis[2].text}, angle};
  }

  [[nodiscard]] Components slide_by(const std::string& way) const {
    Components result{"0", "0", "0"};
    const Axis axis = axis_of(joint_.axis);
    if (axis.along) {
      result[*axis.along] = axis.is_reversed ? negated(way) : way;
      return result;
    }
    const std::string length = axis_length();
    for (std::size_t i = 0; i < 3; ++i) {
      result[i] = quotient(product(joint_.axis[i].text, way), length);
    }
    return result;
  }

  /// "sqrt(0.7^2 + 0.7^2)", or "1" where an oblique axis has exactly that length.
  [[nodiscard]] std::string axis_length() const {
    cln::cl_RA square = 0;
    std::string terms;
    for (const FileNumber& component : joint_.axis) {
      if (component.is_zero()) continue;
      square = square + component.value * component.value;
      const bool is_negative = cln::minusp(component.value);
      terms += (terms.empty() ? "" : " + ") + (is_negative ? negative(component) : component).text +
               "^2";
    }
    return square == 1 ? "1" : "sqrt(" + terms + ")";
  }

  /// A coordinate called NAME_end.
  std::string draft_free(const std::string& end, const std::string& unit) {
    CoordinateDraft coordinate{glossary_.claim(name_ + "_" + end, "joint"), unit, doc()};
    if (unit == "rad") {
      coordinate.low = "\"-pi\"";
      coordinate.high = "\"pi\"";
      coordinate.wraps = true;
    }
    draft_.coordinates.push_back(coordinate);
    return coordinate.name;
  }

  JointMotion draft_floating() {
    JointMotion motion;
    for (std::size_t i = 0; i < 3; ++i) motion.translate[i] = draft_free(axis_letter(i), "m");
    motion.attitude = draft_free("attitude", "");
    return motion;
  }

  JointMotion draft_planar() {
    const std::size_t normal = *axis_of(joint_.axis).along;
    JointMotion motion;
    for (const std::size_t i : {(normal + 1) % 3, (normal + 2) % 3}) {
      const std::string name = draft_free(axis_letter(i), "m");
      motion.translate[i] = name;
      draft_.inputs.push_back({glossary_.claim("f_" + name, "input"),
                               "N",
                               name,
                               {},
                               fmt::format("force of {}", joint_.name.text)});
    }
    const std::string angle = draft_free("angle", "rad");
    draft_.inputs.push_back({glossary_.claim("tau_" + angle, "input"),
                             "N*m",
                             angle,
                             {},
                             fmt::format("torque of {}", joint_.name.text)});
    motion.turn = {turn_by(angle)};
    return motion;
  }

  const Robot& robot_;
  Glossary& glossary_;
  Draft& draft_;
  const Branch& branch_;
  const Joint& joint_;
  const std::string& name_;
};

}  // namespace

std::string axis_letter(std::size_t axis) { return std::string(1, "xyz"[axis]); }

JointMotion draft_joint(Drafting& drafting, const Branch& branch) {
  return JointDrafter(drafting, branch).draft();
}

}  // namespace elgen::urdf
