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
struct HeldLeaf {
  std::uint32_t value = 0;
  std::uint32_t rate = 0;
  std::uint32_t acceleration = 0;
};

Expression derivative_of(ExpressionId value, const Span& span) {
  return {.kind = ExpressionKind::time_derivative, .operands = {value}, .span = span};
}

/// Turns a node into the name of a prescribed function.
void rename(Expression& node, std::uint32_t prescribed) {
  node.kind = ExpressionKind::named;
  node.named = NamedKind::prescribed;
  node.index = prescribed;
}

bool names_acceleration(const Model& model, std::uint32_t velocity) {
  return std::ranges::any_of(model.expressions, [velocity](const Expression& node) {
    return is_leaf(node, Opcode::acceleration) && node.index == velocity;
  });
}

class VariantBuilder {
 public:
  explicit VariantBuilder(const Model& whole)
      : whole_(whole),
        left_(remaining_variables(whole)),
        replacements_(whole.coordinates.size()),
        model_(whole) {}

  Model operator()() && {
    for (const Lock& lock : whole_.variant.locks) {
      for (std::uint32_t i = 0; i < lock.values.size(); ++i) {
        replace(lock.coordinate + i, lock.values[i], lock.span);
      }
    }
    for (const Cyclic& cyclic : whole_.variant.cyclic) {
      replace(cyclic.coordinate, no_expression, cyclic.span);
      model_.may_drift = true;
    }
    for (std::size_t i = 0; i < whole_.expressions.size(); ++i) rewrite(model_.expressions[i]);
    RemainingPositions rotations(whole_.rotations.size());
    for (std::uint32_t i = 0; i < whole_.rotations.size(); ++i) {
      if (!left_.coordinates[whole_.rotations[i].first_coordinate]) rotations.remove(i, 1);
    }
    renumber_variables(rotations);
    renumber_users(rotations);
    if (model_.approximation) {
      left_.coordinates.erase_removed(model_.approximation->coordinates);
      left_.coordinates.erase_removed(model_.approximation->small);
      left_.inputs.erase_removed(model_.approximation->inputs);
    }
    model_.equilibria.clear();
    model_.expectations.clear();
    return std::move(model_);
  }

 private:
  /// Adds s(t) and ds/dt as prescribed functions. ds/dt needs a name, because a velocity leaf has
  /// no operand that could hold the expression.
  void replace(std::uint32_t index, ExpressionId value, const Span& span) {
    const Coordinate& c = whole_.coordinates[index];
    HeldLeaf& held = replacements_[index];
    held.value = prescribe({c.name, c.identifier, value, c.latex, c.doc, span});
    const std::string dot = "dot(" + c.name + ")";
    const ExpressionId rate = append(derivative_of(value, span));
    held.rate = prescribe({dot, c.identifier + "_dot", rate, {}, {}, span});
    if (names_acceleration(whole_, c.velocity)) {
      const ExpressionId second = append(derivative_of(rate, span));
      const std::string ddot = "dot(" + dot + ")";
      held.acceleration = prescribe({ddot, c.identifier + "_ddot", second, {}, {}, span});
    }
    if (c.armature) add_armature(c, held.rate);
    if (contains_leaf(whole_, value, Opcode::time)) model_.uses_time = true;
    if (model_.uses_time) model_.may_drift = true;
  }

  /// Adds the energy 1/2 J (ds/dt)^2 of the armature J of a locked coordinate that moves.
  void add_armature(const Coordinate& coordinate, std::uint32_t rate) {
    const ExpressionId speed =
        append({.kind = ExpressionKind::named, .named = NamedKind::prescribed, .index = rate});
    const ExpressionId half = append({.number = cln::cl_RA(1) / 2});
    const ExpressionId square =
        append({.kind = ExpressionKind::power, .number = 2, .operands = {speed}});
    const ExpressionId energy = append(
        {.kind = ExpressionKind::multiply, .operands = {half, *coordinate.armature, square}});
    auto& total = model_.energies.L ? model_.energies.L : model_.energies.T;
    Expression sum{.kind = ExpressionKind::add};
    if (total) sum.operands = {*total};
    sum.operands.push_back(energy);
    total = append(sum);
  }

  ExpressionId append(Expression expression) {
    model_.expressions.push_back(std::move(expression));
    return static_cast<ExpressionId>(model_.expressions.size() - 1);
  }

  std::uint32_t prescribe(NamedExpression function) {
    model_.prescribed.push_back(std::move(function));
    return static_cast<std::uint32_t>(model_.prescribed.size() - 1);
  }

  void rewrite(Expression& node) const {
    if (is_leaf(node, Opcode::coordinate)) {
      if (const auto index = left_.coordinates[node.index]) {
        node.index = *index;
      } else {
        rename(node, replacements_[node.index].value);
      }
    } else if (is_leaf(node, Opcode::velocity) || is_leaf(node, Opcode::acceleration)) {
      const auto index = left_.velocities[node.index];
      index ? void(node.index = *index) : rewrite_rate(node);
    } else if (is_leaf(node, Opcode::input)) {
      // A removed input occurs only in forces that are removed too.
      const auto index = left_.inputs[node.index];
      index ? void(node.index = *index) : void(node = {.number = 0, .span = node.span});
    }
  }

  /// Replaces the rate or acceleration of a held variable; for a rotation by 0, since rotations are
  /// locked at constants.
  void rewrite_rate(Expression& node) const {
    const Velocity& velocity = whole_.velocities[node.index];
    if (velocity.rotation) {
      node = {.number = 0, .span = node.span};
      return;
    }
    const HeldLeaf& held = replacements_[velocity.coordinate];
    const bool is_rate = is_leaf(node, Opcode::velocity);
    rename(node, is_rate ? held.rate : held.acceleration);
  }

  void renumber_variables(const RemainingPositions& rotations) {
    left_.coordinates.erase_removed(model_.coordinates);
    left_.velocities.erase_removed(model_.velocities);
    rotations.erase_removed(model_.rotations);
    for (Coordinate& coordinate : model_.coordinates) {
      coordinate.velocity = *left_.velocities[coordinate.velocity];
      if (coordinate.rotation) coordinate.rotation = rotations[*coordinate.rotation];
    }
    for (Velocity& velocity : model_.velocities) {
      velocity.coordinate = *left_.coordinates[velocity.coordinate];
      if (velocity.rotation) velocity.rotation = rotations[*velocity.rotation];
    }
    for (Rotation& rotation : model_.rotations) {
      rotation.first_coordinate = *left_.coordinates[rotation.first_coordinate];
      rotation.first_velocity = *left_.velocities[rotation.first_velocity];
    }
  }

  void renumber_users(const RemainingPositions& rotations) {
    for (Frame& frame : model_.frames) {
      for (ElementaryTransform& transform : frame.transforms) {
        if (transform.rotation) transform.rotation = rotations[*transform.rotation];
      }
    }
    left_.inputs.erase_removed(model_.inputs);
    for (Input& input : model_.inputs) {
      if (input.on) input.on = left_.velocities[*input.on];
    }
    std::erase_if(model_.forces,
                  [&](const Force& force) { return force.on && !left_.velocities[*force.on]; });
    for (Force& force : model_.forces) {
      if (force.on) force.on = left_.velocities[*force.on];
    }
  }

  const Model& whole_;
  RemainingVariables left_;
  std::vector<HeldLeaf> replacements_;
  Model model_;
};

}  // namespace

Model variant_of(Model whole) {
  if (whole.variant.locks.empty() && whole.variant.cyclic.empty()) return whole;
  const auto kept = std::make_shared<const Model>(std::move(whole));
  Model result = VariantBuilder(*kept)();
  result.variant.whole = kept;
  return result;
}

}  // namespace elgen
