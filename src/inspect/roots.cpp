// Roots, and a depth-first search below them without recursion: a chain of points is as deep as it
// is long.
#include "roots.hpp"

namespace elgen::inspection {

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
  return roots;
}

std::vector<ExpressionId> output_roots(const UserOutput& output) {
  std::vector<ExpressionId> roots = output.values;
  roots.insert(roots.end(), output.twist.begin(), output.twist.end());
  return roots;
}

std::vector<ExpressionId> referred_to(const Model& model, ExpressionId expression) {
  const Expression& node = model.expressions[expression];
  switch (node.kind) {
    case ExpressionKind::definition:
      return {model.definitions[node.index].value};
    case ExpressionKind::prescribed:
      return {model.prescribed[node.index].value};
    case ExpressionKind::point_component:
      return {model.points[node.index / 3].at[node.index % 3]};
    case ExpressionKind::frame_component:
      return {component_of_frame(model, node.index)};
    default:
      return node.operands;
  }
}

std::vector<ExpressionId> below(const Model& model, const std::vector<ExpressionId>& roots) {
  std::vector<ExpressionId> order;
  std::vector<bool> visited(model.expressions.size());
  std::vector<ExpressionId> stack(roots.rbegin(), roots.rend());
  while (!stack.empty()) {
    const ExpressionId id = stack.back();
    const std::size_t before = stack.size();
    for (const ExpressionId needed : referred_to(model, id)) {
      if (!visited[needed]) stack.push_back(needed);
    }
    if (stack.size() > before) continue;
    stack.pop_back();
    if (visited[id]) continue;
    visited[id] = true;
    order.push_back(id);
  }
  return order;
}

}  // namespace elgen::inspection
