// References: one switch over the kinds of names, and one depth-first search.
#include "elgen/references.hpp"

#include <algorithm>
#include <numeric>

namespace elgen {
namespace {

enum class SearchState : std::uint8_t { unseen, open, done };

/// An expression on the current path of the search.
struct Entered {
  ExpressionId expression = 0;
  std::vector<ExpressionId> references = {};
  std::size_t next = 0;
};

struct Found {
  std::vector<ExpressionId> order = {};  ///< topological: references first
  std::vector<ExpressionId> cycle = {};  ///< the first one found, which ends the search
};

/// The part of the path from `first` on. Its last expression refers to `first` again.
std::vector<ExpressionId> cycle_of(const std::vector<Entered>& path, ExpressionId first) {
  std::vector<ExpressionId> cycle;
  auto entered = std::ranges::find(path, first, &Entered::expression);
  for (; entered != path.end(); ++entered) cycle.push_back(entered->expression);
  return cycle;
}

/// Searches without recursion, as chains of names may have thousands of links.
template <class References>
Found search(const Model& model, const std::vector<ExpressionId>& roots,
             const References& references) {
  Found found;
  std::vector<SearchState> states(model.expressions.size(), SearchState::unseen);
  std::vector<Entered> path;
  const auto enter = [&](ExpressionId id) {
    if (states[id] != SearchState::unseen) return;
    states[id] = SearchState::open;
    path.push_back({id, references(model, id)});
  };
  for (const ExpressionId root : roots) {
    enter(root);
    while (!path.empty()) {
      Entered& top = path.back();
      if (top.next == top.references.size()) {
        states[top.expression] = SearchState::done;
        found.order.push_back(top.expression);
        path.pop_back();
        continue;
      }
      const ExpressionId next = top.references[top.next++];
      if (states[next] == SearchState::open) {
        found.cycle = cycle_of(path, next);
        return found;
      }
      enter(next);
    }
  }
  return found;
}

ExpressionId component_of_frame(const Frame& frame, std::uint32_t component) {
  if (component < frame_origin) return frame.rotation[component];
  if (component < frame_angular_velocity) return frame.origin[component - frame_origin];
  if (component < frame_turning) return frame.angular_velocity[component - frame_angular_velocity];
  return frame.turning[component - frame_turning];
}

/// Like references(), but a component of a point or of the pose of a frame refers to all of it.
std::vector<ExpressionId> references_by_name(const Model& model, ExpressionId expression) {
  const Expression& e = model.expressions[expression];
  if (e.kind == ExpressionKind::point_component) {
    const Vector3& at = model.points[e.index / 3].at;
    return {at.begin(), at.end()};
  }
  const bool is_of_pose = e.kind == ExpressionKind::frame_component &&
                          e.index % components_per_frame < frame_angular_velocity;
  if (!is_of_pose) return references(model, expression);
  const Frame& frame = model.frames[e.index / components_per_frame];
  std::vector<ExpressionId> all(frame.rotation.begin(), frame.rotation.end());
  all.insert(all.end(), frame.origin.begin(), frame.origin.end());
  return all;
}

std::vector<ExpressionId> all_of(const Model& model) {
  std::vector<ExpressionId> all(model.expressions.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

}  // namespace

std::optional<ExpressionId> value_of_name(const Model& model, const Expression& expression) {
  const std::uint32_t index = expression.index;
  switch (expression.kind) {
    case ExpressionKind::prescribed:
      return model.prescribed[index].value;
    case ExpressionKind::definition:
      return model.definitions[index].value;
    case ExpressionKind::point_component:
      return model.points[index / 3].at[index % 3];
    case ExpressionKind::body_component:
      return model.bodies[index / 3].com[index % 3];
    case ExpressionKind::frame_component:
      return component_of_frame(model.frames[index / components_per_frame],
                                index % components_per_frame);
    default:
      return std::nullopt;
  }
}

std::vector<ExpressionId> references(const Model& model, ExpressionId expression) {
  const Expression& e = model.expressions[expression];
  const std::optional<ExpressionId> value = value_of_name(model, e);
  return value ? std::vector{*value} : e.operands;
}

std::vector<ExpressionId> equation_roots(const Model& model) {
  std::vector<ExpressionId> roots;
  const auto add = [&roots](const auto& ids) { roots.insert(roots.end(), ids.begin(), ids.end()); };
  const auto add_one = [&roots](const std::optional<ExpressionId>& id) {
    if (id) roots.push_back(*id);
  };
  for (const Coordinate& coordinate : model.coordinates) add_one(coordinate.armature);
  for (const Frame& frame : model.frames) {
    add(frame.rotation);
    add(frame.origin);
    add(frame.spin);
  }
  for (const Point& point : model.points) {
    add(point.at);
    add_one(point.mass);
  }
  for (const Body& body : model.bodies) {
    add(body.com);
    add(body.inertia);
    add(body.spin);
    add_one(body.mass);
  }
  if (model.gravity) add(*model.gravity);
  const Energies& e = model.energies;
  for (const auto& energy : {e.T, e.V, e.D, e.L}) add_one(energy);
  for (const Force& force : model.forces) {
    add(force.value);
    add(force.reaction);
  }
  for (const Constraint& constraint : model.constraints) {
    roots.push_back(constraint.value);
    add_one(constraint.omega);
    add_one(constraint.zeta);
  }
  return roots;
}

std::vector<ExpressionId> output_roots(const UserOutput& output) {
  std::vector<ExpressionId> roots = output.values;
  roots.insert(roots.end(), output.twist.begin(), output.twist.end());
  return roots;
}

std::vector<ExpressionId> all_roots(const Model& model) {
  std::vector<ExpressionId> roots = equation_roots(model);
  for (const UserOutput& output : model.outputs) {
    const std::vector<ExpressionId> own = output_roots(output);
    roots.insert(roots.end(), own.begin(), own.end());
  }
  return roots;
}

std::vector<ExpressionId> reached(const Model& model, const std::vector<ExpressionId>& roots) {
  return search(model, roots, references).order;
}

bool holds_leaf(const Model& model, ExpressionId expression, LeafSet kinds) {
  return std::ranges::any_of(reached(model, {expression}), [&](ExpressionId id) {
    const Expression& e = model.expressions[id];
    return e.kind == ExpressionKind::leaf && kinds.has_any(e.leaf);
  });
}

bool is_reached(const Model& model, const std::vector<ExpressionId>& roots, const Held& variable) {
  const std::vector<ExpressionId> all = reached(model, roots);
  return std::ranges::any_of(all, [&](ExpressionId id) {
    const Expression& node = model.expressions[id];
    const bool is_rate = is_leaf(node, Opcode::velocity) || is_leaf(node, Opcode::acceleration);
    return (is_leaf(node, Opcode::coordinate) && node.index == variable.coordinate) ||
           (is_rate && node.index == variable.velocity);
  });
}

std::vector<ExpressionId> in_order(const Model& model) { return reached(model, all_of(model)); }

std::vector<ExpressionId> find_cycle(const Model& model) {
  return search(model, all_of(model), references_by_name).cycle;
}

}  // namespace elgen
