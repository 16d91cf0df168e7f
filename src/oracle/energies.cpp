// Energies: one term per entry of the model, in the order of the file.
#include "oracle/energies.hpp"

namespace elgen::oracle {
namespace {

using Components = std::array<ExpressionId, 3>;

const Jet& half() {
  static const Jet value = Jet(cln::cl_RA(1) / 2);
  return value;
}

Jet square(const Jet& x) { return x * x; }

void append(std::vector<Root>& roots, const Components& at, unsigned dimension, unsigned order) {
  for (unsigned c = 0; c < dimension; ++c) roots.push_back({at[c], order});
}

void append(std::vector<Root>& roots, const std::vector<ExpressionId>& expressions) {
  for (const ExpressionId id : expressions) roots.push_back({id, 0});
}

void append(std::vector<Root>& roots, const std::optional<ExpressionId>& expression) {
  if (expression) roots.push_back({*expression, 0});
}

/// |dp/dt|^2
Jet squared_speed(const Evaluation& at, const Components& position, unsigned dimension) {
  Jet sum;
  for (unsigned c = 0; c < dimension; ++c) sum = sum + square(at.rate(position[c]));
  return sum;
}

/// What gravity does to every mass, axis by axis: the summands of m gravity.p.
std::vector<Jet> weight_terms(const Model& model, const Evaluation& at) {
  std::vector<Jet> terms;
  const auto append_weight = [&](const std::optional<ExpressionId>& mass, const Components& place) {
    if (!mass) return;
    for (unsigned c = 0; c < 3; ++c) {
      terms.push_back(at.value(*mass) * at.value((*model.gravity)[c]) * at.value(place[c]));
    }
  };
  if (!model.gravity) return terms;
  for (const Point& point : model.points) append_weight(point.mass, point.at);
  for (const Body& body : model.bodies) append_weight(body.mass, body.com);
  return terms;
}

/// w.I w; I is {Izz} or {xx yy zz xy xz yz}.
Jet spin_energy_twice(const Body& body, const Evaluation& at) {
  if (body.inertia.empty() || body.spin.empty()) return {};
  if (body.inertia.size() == 1) {
    return at.value(body.inertia[0]) * square(at.value(body.spin.back()));
  }
  const Jet x = at.value(body.spin[0]);
  const Jet y = at.value(body.spin[1]);
  const Jet z = at.value(body.spin[2]);
  const auto inertia = [&](std::size_t i) { return at.value(body.inertia[i]); };
  return inertia(0) * x * x + inertia(1) * y * y + inertia(2) * z * z +
         Jet(2) * (inertia(3) * x * y + inertia(4) * x * z + inertia(5) * y * z);
}

Jet armature_energy(const Model& model, const Evaluation& at, const Motion& motion) {
  Jet sum;
  for (const Coordinate& coordinate : model.coordinates) {
    if (!coordinate.armature) continue;
    sum = sum + half() * at.value(*coordinate.armature) * square(motion.v[coordinate.velocity]);
  }
  return sum;
}

std::vector<Root> armature_roots(const Model& model) {
  std::vector<Root> roots;
  for (const Coordinate& coordinate : model.coordinates) append(roots, coordinate.armature);
  return roots;
}

}  // namespace

std::vector<Root> kinetic_roots(const Model& model) {
  std::vector<Root> roots = armature_roots(model);
  append(roots, model.energies.T);
  for (const Point& point : model.points) {
    if (!point.mass) continue;
    append(roots, point.mass);
    append(roots, point.at, point.dimension, 1);
  }
  for (const Body& body : model.bodies) {
    append(roots, body.inertia);
    append(roots, body.spin);
    if (!body.mass) continue;
    append(roots, body.mass);
    append(roots, body.com, body.dimension, 1);
  }
  return roots;
}

std::vector<Root> potential_roots(const Model& model) {
  std::vector<Root> roots;
  append(roots, model.energies.V);
  if (!model.gravity) return roots;
  append(roots, *model.gravity, 3, 0);
  for (const Point& point : model.points) {
    if (!point.mass) continue;
    append(roots, point.mass);
    append(roots, point.at, 3, 0);
  }
  for (const Body& body : model.bodies) {
    if (!body.mass) continue;
    append(roots, body.mass);
    append(roots, body.com, 3, 0);
  }
  return roots;
}

std::vector<Root> lagrangian_roots(const Model& model) {
  std::vector<Root> roots = kinetic_roots(model);
  const std::vector<Root> potential = potential_roots(model);
  roots.insert(roots.end(), potential.begin(), potential.end());
  append(roots, model.energies.L);
  return roots;
}

std::vector<Root> dissipation_roots(const Model& model) {
  std::vector<Root> roots;
  append(roots, model.energies.D);
  return roots;
}

Jet kinetic_energy(const Model& model, const Evaluation& at, const Motion& motion) {
  Jet sum = armature_energy(model, at, motion);
  if (model.energies.T) sum = sum + at.value(*model.energies.T);
  for (const Point& point : model.points) {
    if (!point.mass) continue;
    sum = sum + half() * at.value(*point.mass) * squared_speed(at, point.at, point.dimension);
  }
  for (const Body& body : model.bodies) {
    sum = sum + half() * spin_energy_twice(body, at);
    if (!body.mass) continue;
    sum = sum + half() * at.value(*body.mass) * squared_speed(at, body.com, body.dimension);
  }
  return sum;
}

Jet potential_energy(const Model& model, const Evaluation& at) {
  Jet sum = model.energies.V ? at.value(*model.energies.V) : Jet();
  for (const Jet& term : weight_terms(model, at)) sum = sum - term;
  return sum;
}

Jet potential_magnitude(const Model& model, const Evaluation& at) {
  Jet sum;
  for (const Jet& term : weight_terms(model, at)) sum = sum + term.magnitudes();
  if (!model.energies.V) return sum;
  const Expression& V = model.expressions[*model.energies.V];
  if (V.kind != ExpressionKind::add) return sum + at.value(*model.energies.V).magnitudes();
  for (const ExpressionId term : V.operands) sum = sum + at.value(term).magnitudes();
  return sum;
}

Jet lagrangian(const Model& model, const Evaluation& at, const Motion& motion) {
  const Jet whole = model.energies.L ? at.value(*model.energies.L) : Jet();
  return whole + kinetic_energy(model, at, motion) - potential_energy(model, at);
}

Jet dissipation(const Model& model, const Evaluation& at) {
  return model.energies.D ? at.value(*model.energies.D) : Jet();
}

}  // namespace elgen::oracle
