// Roots, and a depth-first search below them without recursion: a chain of points is as deep as it
// is long.
#include "inspect/roots.hpp"

namespace elgen {

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

}  // namespace elgen
