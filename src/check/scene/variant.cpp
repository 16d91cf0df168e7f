// Eliminates the variables that a scene holds. Locked coordinates become prescribed functions of
// time, and their rates the rates of these functions; cyclic coordinates become 0.
//
//     before    q = (q1, q2)    T = 1/2*I1*dot(q1)^2 + 1/2*I2*dot(q2)^2     q1 locked at w*t
//     after     q = (q2)        q1(t) = w*t, T = 1/2*I1*dot(q1)^2 + 1/2*I2*dot(q2)^2
//
// Nodes of the arena change kind in place, so that references to them stay valid.
#include <algorithm>
#include <utility>

#include "check/scene/scene.hpp"
#include "elgen/references.hpp"

namespace elgen {

namespace {

/// Indices of the prescribed functions that replace a held coordinate, its rate and its
/// acceleration. The acceleration is replaced only if a node names it.
struct HeldReplacement {
  std::uint32_t value = 0;
  std::uint32_t rate = 0;
  std::uint32_t acceleration = 0;
};

Expression time_derivative_node(ExpressionId value, const Span& span) {
  return {.kind = ExpressionKind::time_derivative, .operands = {value}, .span = span};
}

/// Turns a node into the name of a prescribed function.
void set_prescribed_name(Expression& node, std::uint32_t prescribed) {
  node.kind = ExpressionKind::named;
  node.named = NamedKind::prescribed;
  node.index = prescribed;
}

bool contains_acceleration(const Model& model, std::uint32_t velocity) {
  return std::ranges::any_of(model.expressions, [velocity](const Expression& node) {
    return is_leaf(node, Opcode::acceleration) && node.index == velocity;
  });
}

class ModelReducer {
 public:
  explicit ModelReducer(const Model& whole)
      : whole_(whole),
        remaining_(remaining_variables(whole)),
        replacements_(whole.coordinates.size()),
        model_(whole) {}

  Model operator()() && {
    for (const LockedCoordinate& lock : whole_.reduction.locks) {
      for (std::uint32_t i = 0; i < lock.values.size(); ++i) {
        replace_coordinate(lock.coordinate + i, lock.values[i], lock.span);
      }
    }
    for (const CyclicCoordinate& cyclic : whole_.reduction.cyclic) {
      replace_coordinate(cyclic.coordinate, no_expression, cyclic.span);
      model_.may_drift = true;
    }
    for (std::size_t i = 0; i < whole_.expressions.size(); ++i) rewrite_leaf(model_.expressions[i]);
    RemainingIndices rotations(whole_.rotations.size());
    for (std::uint32_t i = 0; i < whole_.rotations.size(); ++i) {
      if (!remaining_.coordinates[whole_.rotations[i].first_coordinate]) rotations.remove(i, 1);
    }
    renumber_variables(rotations);
    renumber_references(rotations);
    if (model_.approximation) {
      remaining_.coordinates.erase_removed(model_.approximation->coordinates);
      remaining_.coordinates.erase_removed(model_.approximation->small);
      remaining_.inputs.erase_removed(model_.approximation->inputs);
    }
    model_.equilibria.clear();
    std::erase_if(model_.expectations, [this](const Expectation& expectation) {
      return !is_of_scene(whole_, expectation.span);
    });
    return std::move(model_);
  }

 private:
  /// Adds s(t) and ds/dt as prescribed functions. ds/dt needs a name, because a velocity leaf has
  /// no operand that could hold the expression.
  void replace_coordinate(std::uint32_t index, ExpressionId value, const Span& span) {
    const Coordinate& c = whole_.coordinates[index];
    HeldReplacement& held = replacements_[index];
    held.value = add_prescribed_function({c.name, c.identifier, value, c.latex, c.doc, span});
    const std::string dot = "dot(" + c.name + ")";
    const ExpressionId rate = append_expression(time_derivative_node(value, span));
    held.rate = add_prescribed_function({dot, c.identifier + "_dot", rate, {}, {}, span});
    if (contains_acceleration(whole_, c.velocity)) {
      const ExpressionId second = append_expression(time_derivative_node(rate, span));
      const std::string ddot = "dot(" + dot + ")";
      held.acceleration =
          add_prescribed_function({ddot, c.identifier + "_ddot", second, {}, {}, span});
    }
    if (c.armature) add_armature(c, held.rate);
    if (contains_leaf(whole_, value, Opcode::time)) model_.uses_time = true;
    if (model_.uses_time) model_.may_drift = true;
  }

  /// Adds the energy 1/2 J (ds/dt)^2 of a locked coordinate s(t) with the armature J to L or T.
  void add_armature(const Coordinate& coordinate, std::uint32_t rate) {
    const ExpressionId speed = append_expression(
        {.kind = ExpressionKind::named, .named = NamedKind::prescribed, .index = rate});
    const ExpressionId half = append_expression({.number = cln::cl_RA(1) / 2});
    const ExpressionId square =
        append_expression({.kind = ExpressionKind::power, .number = 2, .operands = {speed}});
    const ExpressionId energy = append_expression(
        {.kind = ExpressionKind::multiply, .operands = {half, *coordinate.armature, square}});
    auto& total = model_.energies.L ? model_.energies.L : model_.energies.T;
    Expression sum{.kind = ExpressionKind::add};
    if (total) sum.operands = {*total};
    sum.operands.push_back(energy);
    total = append_expression(sum);
  }

  ExpressionId append_expression(Expression expression) {
    model_.expressions.push_back(std::move(expression));
    return static_cast<ExpressionId>(model_.expressions.size() - 1);
  }

  std::uint32_t add_prescribed_function(NamedExpression function) {
    model_.prescribed.push_back(std::move(function));
    return static_cast<std::uint32_t>(model_.prescribed.size() - 1);
  }

  void rewrite_leaf(Expression& node) const {
    if (is_leaf(node, Opcode::coordinate)) {
      if (const auto index = remaining_.coordinates[node.index]) {
        node.index = *index;
      } else {
        set_prescribed_name(node, replacements_[node.index].value);
      }
    } else if (is_leaf(node, Opcode::velocity) || is_leaf(node, Opcode::acceleration)) {
      const auto index = remaining_.velocities[node.index];
      index ? void(node.index = *index) : rewrite_rate(node);
    } else if (is_leaf(node, Opcode::momentum)) {
      // Only the [[expect]] of the model, which are removed, have momenta of removed coordinates.
      node.index = remaining_.velocities[node.index].value_or(0);
    } else if (is_leaf(node, Opcode::input)) {
      // A removed input occurs only in forces that are removed too.
      const auto index = remaining_.inputs[node.index];
      index ? void(node.index = *index) : void(node = {.number = 0, .span = node.span});
    }
  }

  /// Replaces `node`, the rate or acceleration of a held variable, by a prescribed function; for a
  /// rotation, by 0, since rotations are locked at constants.
  void rewrite_rate(Expression& node) const {
    const Velocity& velocity = whole_.velocities[node.index];
    if (velocity.rotation) {
      node = {.number = 0, .span = node.span};
      return;
    }
    const HeldReplacement& held = replacements_[velocity.coordinate];
    const bool is_rate = is_leaf(node, Opcode::velocity);
    set_prescribed_name(node, is_rate ? held.rate : held.acceleration);
  }

  void renumber_variables(const RemainingIndices& rotations) {
    remaining_.coordinates.erase_removed(model_.coordinates);
    remaining_.velocities.erase_removed(model_.velocities);
    rotations.erase_removed(model_.rotations);
    for (Coordinate& coordinate : model_.coordinates) {
      coordinate.velocity = *remaining_.velocities[coordinate.velocity];
      if (coordinate.rotation) coordinate.rotation = rotations[*coordinate.rotation];
    }
    for (Velocity& velocity : model_.velocities) {
      velocity.coordinate = *remaining_.coordinates[velocity.coordinate];
      if (velocity.rotation) velocity.rotation = rotations[*velocity.rotation];
    }
    for (Rotation& rotation : model_.rotations) {
      rotation.first_coordinate = *remaining_.coordinates[rotation.first_coordinate];
      rotation.first_velocity = *remaining_.velocities[rotation.first_velocity];
    }
  }

  void renumber_references(const RemainingIndices& rotations) {
    for (Frame& frame : model_.frames) {
      for (ElementaryTransform& transform : frame.transforms) {
        if (transform.rotation) transform.rotation = rotations[*transform.rotation];
      }
    }
    remaining_.inputs.erase_removed(model_.inputs);
    for (Input& input : model_.inputs) {
      if (input.velocity) input.velocity = remaining_.velocities[*input.velocity];
    }
    std::erase_if(model_.forces, [&](const Force& force) {
      return force.velocity && !remaining_.velocities[*force.velocity];
    });
    for (Force& force : model_.forces) {
      if (force.velocity) force.velocity = remaining_.velocities[*force.velocity];
    }
  }

  const Model& whole_;
  RemainingVariables remaining_;
  std::vector<HeldReplacement> replacements_;
  Model model_;
};

}  // namespace

Model eliminate_held_coordinates(Model whole) {
  if (whole.reduction.locks.empty() && whole.reduction.cyclic.empty()) return whole;
  const auto kept = std::make_shared<const Model>(std::move(whole));
  Model result = ModelReducer(*kept)();
  result.reduction.unreduced = kept;
  return result;
}

}  // namespace elgen
