// Depth-first order of definitions, prescribed motions, points and the frames they need, without
// recursion: chains are long.
#include "formulate/entities.hpp"

#include <optional>
#include <unordered_set>
#include <utility>

namespace elgen {

namespace {

struct Numbering {
  std::size_t prescribed;  ///< node of the first prescribed motion; definitions start at 0
  std::size_t points;
  std::size_t frames;
  std::size_t count;
};

Numbering number(const Model& model) {
  const std::size_t prescribed = model.definitions.size();
  const std::size_t points = prescribed + model.prescribed.size();
  const std::size_t frames = points + model.points.size();
  return {prescribed, points, frames, frames + model.frames.size()};
}

Entity entity(const Numbering& numbering, std::size_t node) {
  const auto at = [&](EntityKind kind, std::size_t first) {
    return Entity{kind, static_cast<std::uint32_t>(node - first)};
  };
  if (node >= numbering.frames) return at(EntityKind::frame, numbering.frames);
  if (node >= numbering.points) return at(EntityKind::point, numbering.points);
  if (node >= numbering.prescribed) return at(EntityKind::prescribed, numbering.prescribed);
  return at(EntityKind::definition, 0);
}

std::optional<std::size_t> referred(const Numbering& numbering, const Expression& expression) {
  switch (expression.kind) {
    case ExpressionKind::definition:
      return expression.index;
    case ExpressionKind::prescribed:
      return numbering.prescribed + expression.index;
    case ExpressionKind::point_component:
      return numbering.points + expression.index / 3;
    case ExpressionKind::frame_component:
      return numbering.frames + expression.index / components_per_frame;
    default:
      return std::nullopt;
  }
}

/// The nodes that expressions mention, in the order of mention; `stack` holds them, first on top.
/// Each expression is read once: as a tree, shared parts can have exponentially many nodes.
std::vector<std::size_t> mentioned(const Model& model, const Numbering& numbering,
                                   std::vector<ExpressionId> stack) {
  std::vector<std::size_t> result;
  std::unordered_set<ExpressionId> seen;
  while (!stack.empty()) {
    const ExpressionId id = stack.back();
    stack.pop_back();
    if (!seen.insert(id).second) continue;
    const Expression& expression = model.expressions[id];
    if (const auto other = referred(numbering, expression)) result.push_back(*other);
    stack.insert(stack.end(), expression.operands.rbegin(), expression.operands.rend());
  }
  return result;
}

/// What the expressions of `node` mention.
std::vector<std::size_t> needs(const Model& model, const Numbering& numbering, std::size_t node) {
  const Entity named = entity(numbering, node);
  std::vector<ExpressionId> stack;
  if (named.kind == EntityKind::point) {
    const auto& at = model.points[named.index].at;
    stack.assign(at.rbegin(), at.rend());
  } else if (named.kind == EntityKind::frame) {
    const Frame& frame = model.frames[named.index];
    stack.assign(frame.origin.rbegin(), frame.origin.rend());
    stack.insert(stack.end(), frame.rotation.rbegin(), frame.rotation.rend());
  } else if (named.kind == EntityKind::prescribed) {
    stack.push_back(model.prescribed[named.index].value);
  } else {
    stack.push_back(model.definitions[named.index].value);
  }
  return mentioned(model, numbering, std::move(stack));
}

/// A list of expressions to look into.
class Roots {
 public:
  template <class List>
  void add(const List& list) {
    ids_.insert(ids_.end(), list.begin(), list.end());
  }
  void add(const std::optional<ExpressionId>& id) {
    if (id) ids_.push_back(*id);
  }
  /// The first one on top.
  [[nodiscard]] std::vector<ExpressionId> as_stack() const { return {ids_.rbegin(), ids_.rend()}; }

 private:
  std::vector<ExpressionId> ids_;
};

/// The steps of frames, and what is given in their axes.
void add_frames(const Model& model, Roots& roots) {
  for (const Frame& frame : model.frames) {
    for (const FrameStep& step : frame.steps) {
      roots.add(step.vector);
      if (step.kind == FrameStepKind::turn) roots.add(std::optional(step.angle));
      if (step.kind == FrameStepKind::quaternion) roots.add(step.quaternion);
    }
  }
  for (const Point& point : model.points) {
    if (point.local) roots.add(point.local->at);
  }
}

/// A body in a frame by what is given there: its com and spin in the world are not asked for.
void add_bodies(const Model& model, Roots& roots) {
  for (const Body& body : model.bodies) {
    roots.add(body.mass);
    roots.add(body.local ? body.local->com.at : body.com);
    roots.add(body.local ? body.local->inertia : body.inertia);
    if (!body.local) roots.add(body.spin);
  }
}

/// What energies, forces, outputs, bodies and the steps of frames mention.
std::vector<std::size_t> needed_by_energies(const Model& model, const Numbering& numbering) {
  Roots roots;
  const Energies& e = model.energies;
  for (const auto& energy : {e.T, e.V, e.D, e.L}) roots.add(energy);
  for (const Force& force : model.forces) roots.add(force.value);
  for (const UserOutput& output : model.outputs) roots.add(output.values);
  add_bodies(model, roots);
  add_frames(model, roots);
  return mentioned(model, numbering, roots.as_stack());
}

/// Every definition, prescribed motion and point of the world, and of frames and their points those
/// that something mentions: masses move by the twists of their frames, except in an expansion.
std::vector<std::size_t> wanted(const Model& model, const Numbering& numbering) {
  std::vector<std::size_t> result;
  const bool in_world = model.approximation.has_value();
  for (std::size_t node = 0; node < (in_world ? numbering.count : numbering.frames); ++node) {
    const bool is_point = node >= numbering.points && node < numbering.frames;
    if (!in_world && is_point && model.points[node - numbering.points].local) continue;
    result.push_back(node);
  }
  const std::vector<std::size_t> others = needed_by_energies(model, numbering);
  result.insert(result.end(), others.begin(), others.end());
  return result;
}

}  // namespace

std::vector<Entity> entities_in_order(const Model& model) {
  const Numbering numbering = number(model);
  std::vector<Entity> order;
  std::vector<bool> done(numbering.count, false);
  std::vector<std::pair<std::size_t, bool>> stack;  // node, whether its needs are on the stack
  for (const std::size_t first : wanted(model, numbering)) {
    stack.emplace_back(first, false);
    while (!stack.empty()) {
      const auto [node, expanded] = stack.back();
      stack.pop_back();
      if (done[node]) continue;
      if (expanded) {
        done[node] = true;
        order.push_back(entity(numbering, node));
        continue;
      }
      stack.emplace_back(node, true);
      const std::vector<std::size_t> needed = needs(model, numbering, node);
      for (auto other = needed.rbegin(); other != needed.rend(); ++other) {
        if (!done[*other]) stack.emplace_back(*other, false);
      }
    }
  }
  return order;
}

}  // namespace elgen
