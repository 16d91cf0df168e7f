// Routh: a cyclic coordinate is eliminated, and its conserved momentum becomes a parameter.
//
//     before    q = (r, phi)    L = 1/2*m*(dot(r)^2 + r^2*dot(phi)^2) - V
//     after     q = (r)         R = L - p_phi*dot(phi) at dot(phi) = p_phi/(m*r^2)
//
// Forces, inputs and D are checked here, by the variables in them. The expressions do not show
// whether L depends on the coordinate, since terms may cancel: set_routh_momenta() asks the oracle.
// In the reduced model the coordinate and its rate are 0.
#include <utility>

#include "base/reason.hpp"
#include "check/scene/scene.hpp"
#include "elgen/references.hpp"

namespace elgen {

namespace {

/// Finds the inputs and forces that act on a coordinate, and the forces, laws and D that contain
/// the coordinate.
class ObstacleSearch {
 public:
  ObstacleSearch(const Model& model, const Scene& scene, const HeldCoordinate& variable)
      : model_(model), scene_(scene), variable_(variable) {}

  std::vector<CyclicObstacle> operator()() && {
    const std::vector<ExpressionId> dissipation = dissipation_roots(model_);
    if (!dissipation.empty()) check_value(dissipation, "D contains it");
    for (const Force& force : model_.forces) check_force(force);
    for (const Input& input : model_.inputs) {
      if (input.velocity == variable_.velocity) {
        add_obstacle("the input " + quote_text(input.name) + " acts on it", input.span);
      }
      if (const ExpressionId* const law = find_law(scene_, input)) {
        check_value({*law}, "the law of " + quote_text(input.name) + " contains it");
      }
    }
    return std::move(found_);
  }

 private:
  using Expressions = std::vector<ExpressionId>;

  void add_obstacle(const std::string& reason, const Span& at) { found_.push_back({reason, at}); }

  void check_value(const Expressions& values, const std::string& reason) {
    if (!contains_variable(model_, values, variable_)) return;
    add_obstacle(reason, model_.expressions[values.front()].span);
  }

  void check_force(const Force& force) {
    const std::string name = force.name.empty() ? "a force" : "the force " + quote_text(force.name);
    if (force.velocity == variable_.velocity) add_obstacle(name + " acts on it", force.span);
    if (force.velocity && force.velocity != variable_.velocity)
      check_value(force.value, name + " contains it");
    if (force.point)
      check_force_position(force, model_.points[*force.point].position, force.value, name);
    if (force.reaction_point)
      check_force_position(force, model_.points[*force.reaction_point].position, force.value, name);
    if (force.frame)
      check_force_position(force, model_.frames[*force.frame].spin, force.value, name);
    if (force.reaction_frame) {
      check_force_position(force, model_.frames[*force.reaction_frame].spin, force.reaction, name);
    }
  }

  /// Adds an obstacle if `components`, or the entries of `place` (a position or a spin) along which
  /// the component is not 0, contain the coordinate.
  void check_force_position(const Force& force, const Vector3& place, const Expressions& components,
                            const std::string& name) {
    Expressions all = components;
    for (std::size_t i = 0; i < components.size(); ++i) {
      const Expression& component = model_.expressions[components[i]];
      const bool is_absent =
          component.kind == ExpressionKind::number && cln::zerop(component.number);
      if (!is_absent) all.push_back(place[i]);
    }
    if (contains_variable(model_, all, variable_))
      add_obstacle(name + ", or the point or frame where it acts, contains it", force.span);
  }

  const Model& model_;
  const Scene& scene_;
  const HeldCoordinate& variable_;
  std::vector<CyclicObstacle> found_ = {};
};

}  // namespace

void check_routh(Context& context, const Scene& scene) {
  const Model& model = context.model;
  if (model.reduction.cyclic.empty()) return;
  if (!model.is_quadratic) {
    const Span& written = model.expressions[*model.energies.L].span;
    context.report.add({Reason::routh_not_quadratic, model.reduction.cyclic.front().span,
                        "`[routh]` needs a Lagrangian at most quadratic in the rates", "", written,
                        "L is given here"});
  }
  for (const LockedCoordinate& lock : model.reduction.locks) {
    if (!lock.has_reaction) continue;
    context.report.add(Reason::reaction_unknown, lock.span,
                       "the reaction on " + quote_text(model.coordinates[lock.coordinate].name) +
                           " is not available together with `[routh]`",
                       "request it in a scene without `[routh]`");
  }
  for (const CyclicCoordinate& cyclic : model.reduction.cyclic) {
    const std::string name = quote_text(model.coordinates[cyclic.coordinate].name);
    for (const CyclicObstacle& obstacle : find_cyclic_obstacles(model, scene, cyclic)) {
      context.report.add({Reason::not_cyclic, cyclic.span,
                          name + " is not cyclic: " + obstacle.reason, "", obstacle.span, "here"});
    }
  }
}

std::vector<CyclicObstacle> find_cyclic_obstacles(const Model& model, const Scene& scene,
                                                  const HeldCoordinate& variable) {
  return ObstacleSearch(model, scene, variable)();
}

}  // namespace elgen
