// Indices into tables of the Model are printed as names.
#include "check/model_text.hpp"

#include "numbers/exact_number.hpp"

namespace elgen::test {
namespace {

class ModelDump {
 public:
  explicit ModelDump(const Model& model) : model_(model) {}

  std::string text() {
    line("model " + model_.name);
    dump_variables();
    dump_frames();
    dump_masses();
    dump_energies();
    dump_forces();
    for (const UserOutput& output : model_.outputs) {
      line("output " + output.name + (output.frame ? " of " + frame_name(output.frame) : "") +
           " = " + list(output.values) + (output.has_jacobian ? ", jacobian" : "") +
           (output.is_in_world ? "" : ", in its axes"));
    }
    for (const Equilibrium& equilibrium : model_.equilibria) dump_equilibrium(equilibrium);
    for (const Expectation& expectation : model_.expectations) {
      line("expect " + expectation.output + " " + std::to_string(expectation.rows) + " " +
           std::to_string(expectation.columns) + " = " + list(expectation.entries));
    }
    dump_scene();
    line(std::string("quadratic ") + (model_.is_quadratic ? "yes" : "no"));
    line(std::string("time ") + (model_.uses_time ? "yes" : "no"));
    line(std::string("drift ") + (model_.may_drift ? "yes" : "no"));
    return std::move(text_);
  }

 private:
  void line(const std::string& content) { text_ += content + "\n"; }

  [[nodiscard]] std::string expression(ExpressionId id) const { return to_string(model_, id); }

  template <class Ids>
  [[nodiscard]] std::string list(const Ids& ids) const {
    std::string result;
    for (const ExpressionId id : ids) {
      result += (result.empty() ? "" : ", ") + expression(id);
    }
    return "[" + result + "]";
  }

  static std::string unit_text(const std::optional<Unit>& unit) {
    return unit ? " [" + to_string(*unit) + "]" : "";
  }

  static std::string interval_text(std::string_view name, const std::optional<Interval>& range) {
    return range ? ", " + std::string(name) + " " + number_text(range->low) + " to " +
                       number_text(range->high)
                 : "";
  }

  static std::string assumption_text(Assumption assumption) {
    switch (assumption) {
      case Assumption::positive:
        return ", positive";
      case Assumption::nonnegative:
        return ", nonnegative";
      case Assumption::none:
        break;
    }
    return "";
  }

  void dump_variables() {
    for (const Coordinate& q : model_.coordinates) {
      const Velocity& v = model_.velocities[q.velocity];
      line("coordinate " + q.name + unit_text(q.unit) + interval_text("range", q.range) +
           interval_text("rate range", v.rate_range) +
           (q.armature ? ", armature " + expression(*q.armature) : "") +
           (q.singular_condition ? ", singular " + expression(*q.singular_condition) : ""));
    }
    for (const Rotation& rotation : model_.rotations) {
      line("rotation " + rotation.name);
    }
    for (const Parameter& p : model_.parameters) {
      line("parameter " + p.name + " = " + number_text(p.value) + unit_text(p.unit) +
           interval_text("range", model_.parameter_arrays[p.array].range) +
           assumption_text(p.assumption));
    }
    for (const NamedExpression& prescribed : model_.prescribed) {
      line("prescribed " + prescribed.name + " = " + expression(prescribed.value));
    }
    for (const NamedExpression& definition : model_.definitions) {
      line("definition " + definition.name + " = " + expression(definition.value));
    }
    for (const Input& input : model_.inputs) {
      line("input " + input.name + unit_text(input.unit) + interval_text("limits", input.limits) +
           (input.velocity ? ", on " + model_.velocities[*input.velocity].name : ""));
    }
  }

  [[nodiscard]] std::string frame_name(const std::optional<std::uint32_t>& frame) const {
    return frame ? model_.frames[*frame].name : "world";
  }

  [[nodiscard]] std::string step_text(const ElementaryTransform& step) const {
    switch (step.kind) {
      case TransformKind::translation:
        return ", moved by " + list(step.vector);
      case TransformKind::turn:
        return ", turned by " + expression(step.angle) + " about " + list(step.vector);
      case TransformKind::quaternion:
        break;
    }
    return step.rotation ? ", turned by " + model_.rotations[*step.rotation].name
                         : ", turned by " + list(step.quaternion);
  }

  void dump_frames() {
    for (const Frame& frame : model_.frames) {
      std::string text = "frame " + frame.name + " on " + frame_name(frame.parent);
      for (const ElementaryTransform& step : frame.transforms) text += step_text(step);
      line(text);
    }
  }

  void dump_masses() {
    for (const Point& point : model_.points) {
      const std::vector<ExpressionId> at(point.position.begin(),
                                         point.position.begin() + point.dimension);
      line("point " + point.name + " at " + list(at) +
           (point.mass ? ", mass " + expression(*point.mass) : ""));
    }
    for (const Body& body : model_.bodies) {
      const std::vector<ExpressionId> com(body.com.begin(), body.com.begin() + body.dimension);
      line("body " + body.name + (body.mass ? ", mass " + expression(*body.mass) : "") + ", com " +
           list(com) + ", inertia " + list(body.inertia) + ", spin " + list(body.spin));
    }
    if (model_.gravity) {
      line("gravity " + list(*model_.gravity));
    }
  }

  void dump_energies() {
    const Energies& e = model_.energies;
    for (const auto& [name, energy] :
         {std::pair("T", e.T), std::pair("V", e.V), std::pair("D", e.D), std::pair("L", e.L)}) {
      if (energy) {
        line(std::string("energy ") + name + " = " + expression(*energy));
      }
    }
  }

  void dump_forces() {
    for (const Force& force : model_.forces) {
      line("force " + force.name + place_text(force) + " = " + list(force.value));
    }
  }

  [[nodiscard]] std::string place_text(const Force& force) const {
    if (force.velocity) return " on " + model_.velocities[*force.velocity].name;
    if (force.point) {
      return " at " + model_.points[*force.point].name +
             (force.reaction_point ? " from " + model_.points[*force.reaction_point].name : "");
    }
    return " on " + frame_name(force.frame) +
           (force.reaction_frame ? " from " + frame_name(force.reaction_frame) : "");
  }

  /// Prints the changes that the scene makes to the model: locks and the expansion.
  void dump_scene() {
    for (const LockedCoordinate& lock : model_.reduction.locks) {
      line("lock " + lock_text(unreduced_model(model_), lock) +
           (lock.has_reaction ? ", reaction" : ""));
    }
    if (model_.approximation) dump_approximation(*model_.approximation);
  }

  [[nodiscard]] std::string point_text(const OperatingPoint& point) const {
    std::string text;
    const auto add = [&](const std::string& name, std::optional<ExpressionId> value) {
      if (value) text += (text.empty() ? "" : ", ") + name + " = " + expression(*value);
    };
    for (std::size_t i = 0; i < point.coordinates.size(); ++i) {
      add(model_.coordinates[i].name, point.coordinates[i]);
    }
    for (std::size_t i = 0; i < point.inputs.size(); ++i) {
      add(model_.inputs[i].name, point.inputs[i]);
    }
    if (!point.condition) return text;
    return text + " where " + expression(point.condition->excess) +
           (point.condition->is_strict ? " > 0" : " >= 0");
  }

  void dump_equilibrium(const Equilibrium& equilibrium) {
    line("equilibrium " + equilibrium.name + " at " + point_text(equilibrium) + ", " +
         list(equilibrium.frequencies_squared));
  }

  void dump_approximation(const Approximation& approximation) {
    std::string small;
    for (std::size_t i = 0; i < approximation.small.size(); ++i) {
      if (approximation.small[i]) small += (small.empty() ? "" : ", ") + model_.coordinates[i].name;
    }
    line("approximate order " + std::to_string(approximation.order) + " about " +
         point_text(approximation) + " with " + small + " small");
  }

  static std::string lock_text(const Model& unlocked, const LockedCoordinate& lock) {
    std::string text;
    for (std::uint32_t i = 0; i < lock.values.size(); ++i) {
      text += (text.empty() ? "" : ", ") + unlocked.coordinates[lock.coordinate + i].name + " = " +
              to_string(unlocked, lock.values[i]);
    }
    return text;
  }

  const Model& model_;
  std::string text_ = {};
};

}  // namespace

std::string dump(const Model& model) { return ModelDump(model).text(); }

}  // namespace elgen::test
