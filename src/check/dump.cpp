// Text of a Model and a Scene, one entry a line, for `--dump check` and for tests.
#include <algorithm>

#include "elgen/scene.hpp"
#include "number_text.hpp"

namespace elgen {
namespace {

using checking::number_text;

class ModelDump {
 public:
  explicit ModelDump(const Model& model) : model_(model) {}

  std::string text() {
    line("model " + model_.name);
    dump_variables();
    dump_masses();
    dump_energies();
    dump_forces();
    for (const UserOutput& output : model_.outputs) {
      line("output " + output.name + " = " + list(output.values) +
           (output.jacobian ? ", jacobian" : ""));
    }
    for (const Expectation& expectation : model_.expectations) {
      line("expect " + expectation.output + " " + std::to_string(expectation.rows) + " " +
           std::to_string(expectation.columns) + " = " + list(expectation.entries));
    }
    line(std::string("quadratic ") + (model_.quadratic ? "yes" : "no"));
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

  void dump_variables() {
    for (const Coordinate& q : model_.coordinates) {
      const Velocity& v = model_.velocities[q.velocity];
      line("coordinate " + q.name + unit_text(q.unit) + interval_text("range", q.range) +
           interval_text("rate range", v.rate_range) +
           (q.armature ? ", armature " + expression(*q.armature) : "") +
           (q.singular ? ", singular " + expression(*q.singular) : ""));
    }
    for (const Parameter& p : model_.parameters) {
      line("parameter " + p.name + " = " + number_text(p.value) + unit_text(p.unit));
    }
    for (const NamedExpression& prescribed : model_.prescribed) {
      line("prescribed " + prescribed.name + " = " + expression(prescribed.value));
    }
    for (const NamedExpression& definition : model_.definitions) {
      line("definition " + definition.name + " = " + expression(definition.value));
    }
    for (const Input& input : model_.inputs) {
      line("input " + input.name + unit_text(input.unit) + interval_text("limits", input.limits) +
           (input.on ? ", on " + model_.velocities[*input.on].name : ""));
    }
  }

  void dump_masses() {
    for (const Point& point : model_.points) {
      const std::vector<ExpressionId> at(point.at.begin(), point.at.begin() + point.dimension);
      line("point " + point.name + " at " + list(at) +
           (point.mass ? ", mass " + expression(*point.mass) : ""));
    }
    for (const Body& body : model_.bodies) {
      const std::vector<ExpressionId> com(body.com.begin(), body.com.begin() + body.dimension);
      line("body " + body.name + (body.mass ? ", mass " + expression(*body.mass) : "") + ", com " +
           list(com) + ", inertia " + list(body.inertia) + ", spin " + list(body.spin) +
           (body.inertia_about_origin ? ", about origin" : ""));
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
      const std::string place = force.on   ? " on " + model_.velocities[*force.on].name
                                : force.at ? " at " + model_.points[*force.at].name
                                           : "";
      line("force " + force.name + place +
           (force.from ? " from " + model_.points[*force.from].name : "") + " = " +
           list(force.value));
    }
  }

  const Model& model_;
  std::string text_ = {};
};

}  // namespace

std::string dump(const Model& model) { return ModelDump(model).text(); }

std::string dump(const Scene& scene) {
  std::string text = "scene " + (scene.name.empty() ? "full" : scene.name) + "\n";
  text += "base name " + scene.base_name + "\n";
  text += "namespace " + scene.emission.name_space + "\n";
  text += "language " + std::string(language_row(scene.emission.language).name) + ", " +
          std::string(name_of(scene.emission.storage)) + (scene.emission.eigen ? ", eigen" : "") +
          "\n";
  for (const auto& [parameter, value] : scene.specialisation.fixed) {
    text += "fixed parameter " + std::to_string(parameter) + " = " + number_text(value) + "\n";
  }
  for (const OutputRequest& output : scene.outputs) {
    text += "output " + output.name + " " + std::to_string(output.rows) + " " +
            std::to_string(output.columns) + "\n";
  }
  if (scene.dropping) text += "drop below " + number_text(scene.dropping->below) + "\n";
  return text;
}

}  // namespace elgen
