// Routh: a cyclic coordinate is eliminated, and its conserved momentum becomes a parameter.
//
//     before    q = (r, phi)    L = 1/2*m*(dot(r)^2 + r^2*dot(phi)^2) - V
//     after     q = (r)         R = L - p_phi*dot(phi) at dot(phi) = p_phi/(m*r^2)
//
// Forces, inputs and D are checked here, by the variables in them. The expressions do not show
// whether L depends on the coordinate, since terms may cancel: find_momenta() asks the oracle. In
// the reduced model the coordinate and its rate are 0.
#include <utility>

#include "base/reason.hpp"
#include "check/scene/scene.hpp"
#include "elgen/references.hpp"

namespace elgen {

namespace {

/// Finds the entries that act on a coordinate, and the entries of other coordinates that contain
/// it.
class ObstacleSearch {
 public:
  ObstacleSearch(const Model& model, const Scene& scene, const Held& variable)
      : model_(model), scene_(scene), variable_(variable) {}

  std::vector<CyclicObstacle> operator()() && {
    const std::vector<ExpressionId> dissipation = dissipation_roots(model_);
    if (!dissipation.empty()) check_value(dissipation, "D contains it");
    for (const Force& force : model_.forces) check_force(force);
    for (const Input& input : model_.inputs) {
      if (input.on == variable_.velocity) {
        add("the input " + in_backticks(input.name) + " acts on it", input.span);
      }
      if (const ExpressionId* const law = find_law(scene_, input)) {
        check_value({*law}, "the law of " + in_backticks(input.name) + " contains it");
      }
    }
    return std::move(found_);
  }

 private:
  using Expressions = std::vector<ExpressionId>;

  void add(const std::string& reason, const Span& at) { found_.push_back({reason, at}); }

  void check_value(const Expressions& values, const std::string& reason) {
    if (!contains_variable(model_, values, variable_)) return;
    add(reason, model_.expressions[values.front()].span);
  }

  void check_force(const Force& force) {
    const std::string name =
        force.name.empty() ? "a force" : "the force " + in_backticks(force.name);
    if (force.on == variable_.velocity) add(name + " acts on it", force.span);
    if (force.on && force.on != variable_.velocity) check_value(force.value, name + " contains it");
    if (force.at) check_place(force, model_.points[*force.at].at, force.value, name);
    if (force.from) check_place(force, model_.points[*force.from].at, force.value, name);
    if (force.frame) check_place(force, model_.frames[*force.frame].spin, force.value, name);
    if (force.from_frame) {
      check_place(force, model_.frames[*force.from_frame].spin, force.reaction, name);
    }
  }

  /// Checks the components of a force, and the position components along which the force is not 0.
  void check_place(const Force& force, const Vector3& place, const Expressions& components,
                   const std::string& name) {
    Expressions all = components;
    for (std::size_t i = 0; i < components.size(); ++i) {
      const Expression& component = model_.expressions[components[i]];
      const bool is_absent =
          component.kind == ExpressionKind::number && cln::zerop(component.number);
      if (!is_absent) all.push_back(place[i]);
    }
    if (contains_variable(model_, all, variable_))
      add(name + ", or the point or frame where it acts, contains it", force.span);
  }

  const Model& model_;
  const Scene& scene_;
  const Held& variable_;
  std::vector<CyclicObstacle> found_ = {};
};

}  // namespace

void check_routh(Context& context, const Scene& scene) {
  const Model& model = context.model;
  if (model.variant.cyclic.empty()) return;
  if (!model.quadratic) {
    const Span& written = model.expressions[*model.energies.L].span;
    context.report.add({Reason::routh_not_quadratic, model.variant.cyclic.front().span,
                        "`[routh]` needs a Lagrangian at most quadratic in the rates", "", written,
                        "L is given here"});
  }
  for (const Lock& lock : model.variant.locks) {
    if (!lock.reaction) continue;
    context.report.add(Reason::reaction_unknown, lock.span,
                       "the reaction on " + in_backticks(model.coordinates[lock.coordinate].name) +
                           " is not available together with `[routh]`",
                       "request it in a scene without `[routh]`");
  }
  for (const Cyclic& cyclic : model.variant.cyclic) {
    const std::string name = in_backticks(model.coordinates[cyclic.coordinate].name);
    for (const CyclicObstacle& obstacle : obstacles_of(model, scene, cyclic)) {
      context.report.add({Reason::not_cyclic, cyclic.span,
                          name + " is not cyclic: " + obstacle.reason, "", obstacle.span, "here"});
    }
  }
}

std::vector<CyclicObstacle> obstacles_of(const Model& model, const Scene& scene,
                                         const Held& variable) {
  return ObstacleSearch(model, scene, variable)();
}

}  // namespace elgen
