// References: the expression that a name stands for, the roots of all entries, and a depth-first
// search through references.
#include "elgen/references.hpp"

#include <algorithm>
#include <numeric>

namespace elgen {
namespace {

enum class SearchState : std::uint8_t { unseen, open, done };

/// An expression on the current path of the search, and the index of the reference to follow next.
struct PathNode {
  ExpressionId expression = 0;
  std::vector<ExpressionId> references = {};
  std::size_t next = 0;
};

struct SearchResult {
  std::vector<ExpressionId> order = {};  ///< each expression after its references
  std::vector<ExpressionId> cycle = {};  ///< the first cycle, which ends the search; empty: none
};

/// The expressions of `path` from `first` on. The last expression of `path` refers to `first`.
std::vector<ExpressionId> extract_cycle(const std::vector<PathNode>& path, ExpressionId first) {
  std::vector<ExpressionId> cycle;
  auto entered = std::ranges::find(path, first, &PathNode::expression);
  for (; entered != path.end(); ++entered) cycle.push_back(entered->expression);
  return cycle;
}

/// Depth-first search from the roots. It does not recurse, because chains of names may have
/// thousands of links.
template <class References>
SearchResult search_depth_first(const Model& model, const std::vector<ExpressionId>& roots,
                                const References& references) {
  SearchResult found;
  std::vector<SearchState> states(model.expressions.size(), SearchState::unseen);
  std::vector<PathNode> path;
  const auto enter = [&](ExpressionId id) {
    if (states[id] != SearchState::unseen) return;
    states[id] = SearchState::open;
    path.push_back({id, references(model, id)});
  };
  for (const ExpressionId root : roots) {
    enter(root);
    while (!path.empty()) {
      PathNode& top = path.back();
      if (top.next == top.references.size()) {
        states[top.expression] = SearchState::done;
        found.order.push_back(top.expression);
        path.pop_back();
        continue;
      }
      const ExpressionId next = top.references[top.next++];
      if (states[next] == SearchState::open) {
        found.cycle = extract_cycle(path, next);
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
  if (component < frame_recursive_spin)
    return frame.angular_velocity[component - frame_angular_velocity];
  return frame.recursive_spin[component - frame_recursive_spin];
}

/// Like references(), but a component of a point refers to all components of the point, and a
/// component of the pose of a frame refers to all components of the pose.
std::vector<ExpressionId> references_by_entry(const Model& model, ExpressionId expression) {
  const Expression& e = model.expressions[expression];
  if (refers_to_entry(e, NamedKind::point)) {
    const Vector3& at = model.points[e.index].position;
    return {at.begin(), at.end()};
  }
  const bool is_of_pose =
      refers_to_entry(e, NamedKind::frame) && e.component < frame_angular_velocity;
  if (!is_of_pose) return references(model, expression);
  const Frame& frame = model.frames[e.index];
  std::vector<ExpressionId> all(frame.rotation.begin(), frame.rotation.end());
  all.insert(all.end(), frame.origin.begin(), frame.origin.end());
  return all;
}

std::vector<ExpressionId> all_expressions(const Model& model) {
  std::vector<ExpressionId> all(model.expressions.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

bool is_named_root(const Root& root) {
  return root.entity.kind == EntityKind::definition || root.entity.kind == EntityKind::prescribed;
}

bool is_output_root(const Root& root) { return root.entity.kind == EntityKind::output; }

/// Lists the expressions of every entry. A new key with an expression needs a line here.
class RootCollector {
 public:
  explicit RootCollector(const Model& model) : model_(model) {}

  std::vector<Root> build() && {
    using R = RootRole;
    for_each(EntityKind::coordinate, model_.coordinates,
             [this](const Coordinate& coordinate) { add(R::armature, coordinate.armature); });
    for_each(EntityKind::frame, model_.frames, [this](const Frame& frame) {
      add(R::rotation, frame.rotation);
      add(R::place, frame.origin);
      add(R::spin, frame.spin);
    });
    for_each(EntityKind::point, model_.points, [this](const Point& point) {
      add(R::place, point.position);
      add(R::mass, point.mass);
    });
    for_each(EntityKind::body, model_.bodies, [this](const Body& body) {
      add(R::place, body.com);
      add(R::inertia, body.inertia);
      add(R::spin, body.spin);
      add(R::mass, body.mass);
    });
    entity_ = {EntityKind::gravity};
    if (model_.gravity) add(R::value, *model_.gravity);
    entity_ = {EntityKind::energy};
    add(R::kinetic, model_.energies.T);
    add(R::potential, model_.energies.V);
    add(R::dissipation, model_.energies.D);
    add(R::lagrangian, model_.energies.L);
    for_each(EntityKind::force, model_.forces, [this](const Force& force) {
      add(R::value, force.value);
      add(R::reaction, force.reaction);
    });
    for_each(EntityKind::constraint, model_.constraints, [this](const Constraint& constraint) {
      add(R::value, std::optional(constraint.value));
      add(R::omega, constraint.omega);
      add(R::zeta, constraint.zeta);
    });
    for_each(EntityKind::output, model_.outputs, [this](const UserOutput& output) {
      add(R::value, output.values);
      add(R::twist, output.twist);
    });
    const auto add_name = [this](const NamedExpression& name) {
      add(R::value, std::optional(name.value));
    };
    for_each(EntityKind::definition, model_.definitions, add_name);
    for_each(EntityKind::prescribed, model_.prescribed, add_name);
    return std::move(roots_);
  }

 private:
  template <class Entry, class AddRoots>
  void for_each(EntityKind kind, const std::vector<Entry>& entries, const AddRoots& add_roots) {
    for (std::uint32_t i = 0; i < entries.size(); ++i) {
      entity_ = {kind, i};
      add_roots(entries[i]);
    }
  }

  template <class List>
  void add(RootRole role, const List& ids) {
    for (const ExpressionId id : ids) roots_.push_back({id, entity_, role});
  }
  void add(RootRole role, const std::optional<ExpressionId>& id) {
    if (id) roots_.push_back({*id, entity_, role});
  }

  const Model& model_;
  Entity entity_ = {};  ///< the entry whose expressions are being added
  std::vector<Root> roots_ = {};
};

}  // namespace

std::optional<ExpressionId> value_of_name(const Model& model, const Expression& expression) {
  if (expression.kind != ExpressionKind::named) return std::nullopt;
  const std::uint32_t index = expression.index;
  switch (expression.named) {
    case NamedKind::prescribed:
      return model.prescribed[index].value;
    case NamedKind::definition:
      return model.definitions[index].value;
    case NamedKind::point:
      return model.points[index].position[expression.component];
    case NamedKind::body:
      return model.bodies[index].com[expression.component];
    case NamedKind::frame:
      return component_of_frame(model.frames[index], expression.component);
  }
  return std::nullopt;
}

std::vector<ExpressionId> references(const Model& model, ExpressionId expression) {
  const Expression& e = model.expressions[expression];
  const std::optional<ExpressionId> value = value_of_name(model, e);
  return value ? std::vector{*value} : e.operands;
}

std::vector<Root> roots_of(const Model& model) { return RootCollector(model).build(); }

std::vector<ExpressionId> equation_roots(const Model& model) {
  return filter_roots(
      model, [](const Root& root) { return !is_named_root(root) && !is_output_root(root); });
}

std::vector<ExpressionId> output_roots(const Model& model, std::uint32_t output) {
  return filter_roots(model, [output](const Root& root) {
    return is_output_root(root) && root.entity.index == output;
  });
}

std::vector<ExpressionId> equation_and_output_roots(const Model& model) {
  return filter_roots(model, [](const Root& root) { return !is_named_root(root); });
}

std::vector<ExpressionId> work_expressions(const Model& model, const Force& force) {
  std::vector<ExpressionId> moved;
  const auto add = [&moved](const Vector3& components) {
    moved.insert(moved.end(), components.begin(), components.end());
  };
  for (const auto& point : {force.point, force.reaction_point}) {
    if (point) add(model.points[*point].position);
  }
  for (const auto& frame : {force.frame, force.reaction_frame}) {
    if (frame) add(model.frames[*frame].spin);
  }
  return moved;
}

std::vector<ExpressionId> reachable_expressions(const Model& model,
                                                const std::vector<ExpressionId>& roots) {
  return search_depth_first(model, roots, references).order;
}

bool is_constant_along_run(const Model& model, ExpressionId expression) {
  return !contains_leaf(model, expression, Opcode::coordinate | Opcode::velocity | Opcode::time);
}

bool contains_leaf(const Model& model, ExpressionId expression, LeafSet kinds) {
  return std::ranges::any_of(reachable_expressions(model, {expression}), [&](ExpressionId id) {
    const Expression& e = model.expressions[id];
    return e.kind == ExpressionKind::leaf && kinds.has_any(e.leaf);
  });
}

bool contains_variable(const Model& model, const std::vector<ExpressionId>& roots,
                       const HeldCoordinate& variable) {
  const std::vector<ExpressionId> all = reachable_expressions(model, roots);
  return std::ranges::any_of(all, [&](ExpressionId id) {
    const Expression& node = model.expressions[id];
    const bool is_rate = is_leaf(node, Opcode::velocity) || is_leaf(node, Opcode::acceleration);
    return (is_leaf(node, Opcode::coordinate) && node.index == variable.coordinate) ||
           (is_rate && node.index == variable.velocity);
  });
}

std::vector<ExpressionId> topological_order(const Model& model) {
  return reachable_expressions(model, all_expressions(model));
}

std::vector<ExpressionId> find_cycle(const Model& model) {
  return search_depth_first(model, all_expressions(model), references_by_entry).cycle;
}

}  // namespace elgen
