// lock: coordinates become prescribed functions, their rates those functions' rates.
//
//     before    q = (q1, q2)    T = 1/2*I1*dot(q1)^2 + 1/2*I2*dot(q2)^2     q1 locked at w*t
//     after     q = (q2)        q1(t) = w*t, T = 1/2*I1*dot(q1)^2 + 1/2*I2*dot(q2)^2
//
// Nodes of the arena change their kind in place, so that whatever refers to them stays.
#include "check/scene/lock.hpp"

#include <algorithm>
#include <utility>

#include "elgen/references.hpp"

namespace elgen {
namespace {

/// Where coordinates, velocities and rotations go; none: locked.
struct NewIndices {
  std::vector<std::optional<std::uint32_t>> coordinates;
  std::vector<std::optional<std::uint32_t>> velocities;
  std::vector<std::optional<std::uint32_t>> rotations;
};

using Indices = std::vector<std::optional<std::uint32_t>>;

void number_those_left(Indices& indices) {
  std::uint32_t next = 0;
  for (auto& index : indices) {
    if (index) index = next++;
  }
}

NewIndices indices_without(const Model& model) {
  NewIndices indices{Indices(model.coordinates.size(), 0), Indices(model.velocities.size(), 0),
                     Indices(model.rotations.size(), 0)};
  for (const Lock& lock : model.locks) {
    const auto rotation = model.coordinates[lock.coordinate].rotation;
    if (rotation) indices.rotations[*rotation] = std::nullopt;
    for (std::uint32_t i = 0; i < lock.values.size(); ++i) {
      indices.coordinates[lock.coordinate + i] = std::nullopt;
    }
    for (std::uint32_t i = 0; i < lock.velocity_count(); ++i) {
      indices.velocities[lock.velocity + i] = std::nullopt;
    }
  }
  number_those_left(indices.coordinates);
  number_those_left(indices.velocities);
  number_those_left(indices.rotations);
  return indices;
}

/// The prescribed functions that take the places of a locked coordinate and of its rate.
struct LockReplacement {
  std::uint32_t value = 0;
  std::uint32_t rate = 0;
};

class Locking {
 public:
  explicit Locking(const Model& unlocked)
      : unlocked_(unlocked),
        indices_(indices_without(unlocked)),
        replacements_(unlocked.coordinates.size()),
        model_(unlocked) {}

  Model operator()() && {
    for (const Lock& lock : unlocked_.locks) {
      for (std::uint32_t i = 0; i < lock.values.size(); ++i) replace(lock, i);
    }
    for (std::size_t i = 0; i < unlocked_.expressions.size(); ++i) {
      rewrite(model_.expressions[i]);
    }
    renumber_variables();
    renumber_users();
    renumber_approximation();
    model_.locks.clear();
    model_.expectations.clear();
    return std::move(model_);
  }

 private:
  /// d/dt s(t) has a name too: `rate` nodes have no operand to put it in.
  void replace(const Lock& lock, std::uint32_t component) {
    const std::uint32_t index = lock.coordinate + component;
    const Coordinate& coordinate = unlocked_.coordinates[index];
    const ExpressionId value = lock.values[component];
    const Expression rate{
        .kind = ExpressionKind::time_derivative, .operands = {value}, .span = lock.span};
    replacements_[index] = {prescribe({coordinate.name, coordinate.identifier, value,
                                       coordinate.latex, coordinate.doc, lock.span}),
                            prescribe({"dot(" + coordinate.name + ")",
                                       coordinate.identifier + "_dot",
                                       append(rate),
                                       {},
                                       {},
                                       lock.span})};
    if (coordinate.armature) add_armature(coordinate, replacements_[index].rate);
    model_.uses_time = model_.uses_time || depends_on_time(value);
    model_.may_drift = model_.may_drift || model_.uses_time;
  }

  /// A moving lock carries energy: 1/2 J (ds/dt)^2.
  void add_armature(const Coordinate& coordinate, std::uint32_t rate) {
    const ExpressionId speed = append({.kind = ExpressionKind::prescribed, .index = rate});
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

  [[nodiscard]] bool depends_on_time(ExpressionId id) const {
    const std::vector<ExpressionId> all = reached(unlocked_, {id});
    return std::any_of(all.begin(), all.end(), [this](ExpressionId each) {
      return unlocked_.expressions[each].kind == ExpressionKind::time;
    });
  }

  void rewrite(Expression& node) const {
    if (node.kind == ExpressionKind::coordinate) {
      if (const auto index = indices_.coordinates[node.index]) {
        node.index = *index;
      } else {
        node.kind = ExpressionKind::prescribed;
        node.index = replacements_[node.index].value;
      }
    } else if (node.kind == ExpressionKind::rate || node.kind == ExpressionKind::acceleration) {
      const auto index = indices_.velocities[node.index];
      index ? void(node.index = *index) : rewrite_rate(node);
    }
  }

  /// Of a rotation 0: it is locked at a constant. (Accelerations occur in closed forms only.)
  void rewrite_rate(Expression& node) const {
    const Velocity& velocity = unlocked_.velocities[node.index];
    if (velocity.rotation) {
      node.kind = ExpressionKind::number;
      node.number = 0;
      return;
    }
    node.kind = ExpressionKind::prescribed;
    node.index = replacements_[velocity.coordinate].rate;
  }

  void renumber_variables() {
    model_.coordinates.clear();
    model_.velocities.clear();
    model_.rotations.clear();
    for (const Coordinate& old : unlocked_.coordinates) {
      const auto velocity = indices_.velocities[old.velocity];
      if (!velocity) continue;
      Coordinate& coordinate = model_.coordinates.emplace_back(old);
      coordinate.velocity = *velocity;
      if (old.rotation) coordinate.rotation = indices_.rotations[*old.rotation];
    }
    for (std::size_t i = 0; i < unlocked_.velocities.size(); ++i) {
      if (!indices_.velocities[i]) continue;
      Velocity& velocity = model_.velocities.emplace_back(unlocked_.velocities[i]);
      velocity.coordinate = *indices_.coordinates[velocity.coordinate];
      if (velocity.rotation) velocity.rotation = indices_.rotations[*velocity.rotation];
    }
    for (const Rotation& old : unlocked_.rotations) {
      const auto coordinate = indices_.coordinates[old.first_coordinate];
      if (!coordinate) continue;
      Rotation& rotation = model_.rotations.emplace_back(old);
      rotation.first_coordinate = *coordinate;
      rotation.first_velocity = *indices_.velocities[old.first_velocity];
    }
  }

  void renumber_users() {
    for (Frame& frame : model_.frames) {
      for (FrameStep& step : frame.steps) {
        if (step.rotation) step.rotation = indices_.rotations[*step.rotation];
      }
    }
    for (Input& input : model_.inputs) {
      if (input.on) input.on = indices_.velocities[*input.on];
    }
    std::vector<Force> acting;
    for (Force& force : model_.forces) {
      const bool is_direct = force.on.has_value();
      if (is_direct) force.on = indices_.velocities[*force.on];
      if (!is_direct || force.on) acting.push_back(std::move(force));
    }
    model_.forces = std::move(acting);
  }

  void renumber_approximation() {
    if (!model_.approximation) return;
    const Approximation& old = *unlocked_.approximation;
    Approximation& left = *model_.approximation;
    left.coordinates.clear();
    left.small.clear();
    for (std::size_t i = 0; i < indices_.coordinates.size(); ++i) {
      if (!indices_.coordinates[i]) continue;
      left.coordinates.push_back(old.coordinates[i]);
      left.small.push_back(old.small[i]);
    }
  }

  const Model& unlocked_;
  NewIndices indices_;
  std::vector<LockReplacement> replacements_;
  Model model_;
};

}  // namespace

Model locked(Model model) {
  if (model.locks.empty()) return model;
  const auto unlocked = std::make_shared<const Model>(std::move(model));
  Model result = Locking(*unlocked)();
  result.unlocked = unlocked;
  return result;
}

}  // namespace elgen
