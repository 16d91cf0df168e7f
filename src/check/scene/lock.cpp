// Locks: `[lock] NAME = { value, reaction }`, NAME a coordinate ("q[2]") or a rotation. Coordinates
// become prescribed functions, their rates those functions' rates.
//
//     before    q = (q1, q2)    T = 1/2*I1*dot(q1)^2 + 1/2*I2*dot(q2)^2     q1 locked at w*t
//     after     q = (q2)        q1(t) = w*t, T = 1/2*I1*dot(q1)^2 + 1/2*I2*dot(q2)^2
//
// Nodes of the arena change their kind in place, so that whatever refers to them stays.
#include <algorithm>
#include <utility>

#include "check/expressions/node_builder.hpp"
#include "check/expressions/places.hpp"
#include "check/expressions/values.hpp"
#include "check/scene/scene.hpp"
#include "elgen/references.hpp"

namespace elgen {

namespace {

template <class List>
auto find_named(const List& list, std::string_view name) {
  return std::find_if(list.begin(), list.end(), [&](const auto& row) { return row.name == name; });
}

class LockReader {
 public:
  explicit LockReader(Context& context)
      : context_(context), values_(context, Scope(context.sizes)) {}

  void read(const KeySyntax& key) {
    const Model& model = context_.model;
    const KeySyntax* value = key.value.find("value");
    const KeySyntax* reaction = key.value.find("reaction");
    if (value == nullptr) return;  // reported when the file was parsed
    Lock lock;
    lock.span = key.key_span;
    lock.reaction = reaction != nullptr && reaction->value.boolean;
    if (const auto rotation = find_named(model.rotations, key.key);
        rotation != model.rotations.end()) {
      lock.coordinate = rotation->first_coordinate;
      lock.velocity = rotation->first_velocity;
      lock.is_rotation = true;
      lock.values = quaternion(value->value);
    } else if (const auto coordinate = find_named(model.coordinates, key.key);
               coordinate != model.coordinates.end() && !coordinate->rotation) {
      lock.coordinate = static_cast<std::uint32_t>(coordinate - model.coordinates.begin());
      lock.velocity = coordinate->velocity;
      lock.values = {function_of_time(value->value, *coordinate)};
    } else {
      report_unknown_coordinate(context_, key);
      return;
    }
    context_.model.locks.push_back(std::move(lock));
  }

 private:
  ExpressionId function_of_time(const ValueSyntax& value, const Coordinate& coordinate) {
    if (value.kind == ValueKind::list) {
      context_.report.add({Code::E615, value.span, "a list, but the coordinate is one number", "",
                           coordinate.span, in_backticks(coordinate.name) + " is declared here"});
      return no_expression;
    }
    const Place place{"the value of a lock", place::of_time};
    const ExpressionId id = values_.scene_value(value, {place, coordinate.unit});
    note_degrees(context_.report, value.span, coordinate, context_.constants[id]);
    return id;
  }

  /// Scaled to length 1: every stage may rely on it.
  std::vector<ExpressionId> quaternion(const ValueSyntax& value) {
    std::vector<ExpressionId> components(quaternion_size, no_expression);
    if (value.kind != ValueKind::list || value.items.size() != quaternion_size) {
      refuse(value.span, in_backticks(value.span) + " is not a quaternion [w, x, y, z]");
      return components;
    }
    bool is_zero = true;
    for (std::size_t i = 0; i < quaternion_size; ++i) {
      const auto number = values_.constant(value.items[i]);
      if (!number) return components;
      is_zero = is_zero && cln::zerop(*number);
      components[i] = values_.root(value.items[i], {{"a quaternion", place::constants_only}});
    }
    if (is_zero) {
      refuse(value.span, "a quaternion of length 0 has no direction");
      return components;
    }
    NodeBuilder nodes(context_, value.span);
    std::vector<ExpressionId> squares;
    for (const ExpressionId component : components) {
      squares.push_back(nodes.power(component, 2));
    }
    const ExpressionId length = nodes.power(nodes.add(squares), cln::cl_RA(1) / 2);
    for (ExpressionId& component : components) component = nodes.divide(component, length);
    return components;
  }

  void refuse(const Span& span, const std::string& message) {
    context_.report.add(Code::E615, span, message);
  }

  Context& context_;
  ValueReader values_;
};

std::size_t locked_velocities(const Model& model) {
  std::size_t count = 0;
  for (const Lock& lock : model.locks) count += lock.velocity_count();
  return count;
}

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
    model_.equilibria.clear();
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
    model_.uses_time = model_.uses_time || holds_leaf(unlocked_, value, Opcode::time);
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

  void rewrite(Expression& node) const {
    if (is_leaf(node, Opcode::coordinate)) {
      if (const auto index = indices_.coordinates[node.index]) {
        node.index = *index;
      } else {
        node.kind = ExpressionKind::prescribed;
        node.index = replacements_[node.index].value;
      }
    } else if (is_leaf(node, Opcode::velocity) || is_leaf(node, Opcode::acceleration)) {
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
    for (Cyclic& cyclic : model_.cyclic) {
      cyclic.coordinate = *indices_.coordinates[cyclic.coordinate];
      cyclic.velocity = *indices_.velocities[cyclic.velocity];
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

void report_unknown_coordinate(Context& context, const KeySyntax& key) {
  const DeclaredNames& symbols = context.symbols;
  const DeclaredName* symbol = symbols.find(key.key);
  if (symbol != nullptr && symbol->kind == SymbolKind::coordinate && symbol->is_array) {
    context.report.add(Code::E208, key.key_span,
                       in_backticks(key.key) + " needs an index: " + elements_of(key.key, *symbol));
    return;
  }
  context.report.add(
      Code::E612, key.key_span, "unknown coordinate " + in_backticks(key.key),
      symbols.suggest(key.key, symbols.names({SymbolKind::coordinate, SymbolKind::rotation})));
}

void read_locks(Context& context, const FileSyntax* scene) {
  const EntrySyntax* entry = find_entry(scene, "lock");
  if (entry == nullptr) return;
  LockReader reader(context);
  for (const KeySyntax& key : entry->keys) reader.read(key);
  std::vector<Lock>& locks = context.model.locks;
  std::sort(locks.begin(), locks.end(),
            [](const Lock& a, const Lock& b) { return a.velocity < b.velocity; });
  if (!locks.empty() && locked_velocities(context.model) == context.model.velocities.size()) {
    context.report.add(Code::E615, entry->span, "every coordinate is locked, so nothing moves");
  }
}

Model locked(Model model) {
  if (model.locks.empty()) return model;
  const auto unlocked = std::make_shared<const Model>(std::move(model));
  Model result = Locking(*unlocked)();
  result.unlocked = unlocked;
  return result;
}

}  // namespace elgen
