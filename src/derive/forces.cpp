// Generalized forces: one reverse pass over positions and energies each, plus the rates of momenta.
#include "derive/forces.hpp"

namespace elgen {

using GiNaC::ex;

namespace {

/// Where both sides are derived, the left one is a variable: the order in which definitions are
/// made must not be the compiler's choice.
Vector plus(Vector left, const Vector& right) {
  for (std::size_t i = 0; i < left.size(); ++i) left[i] += right[i];
  return left;
}

/// Rate of each entry along a direction.
Vector rates(const Vector& values, Tangent& along) {
  Vector result;
  for (const ex& value : values) result.push_back(along(value));
  return result;
}

std::array<ex, 3> gravity_vector(const Derivation& derivation) {
  return derivation.lagrangian.gravity.value_or(std::array<ex, 3>{0, 0, 0});
}

std::string force_name(const PointMass& mass, const Derivation& derivation, std::size_t axis) {
  const SymbolPlace* place = nullptr;
  const auto found = derivation.definitions.places.find(mass.position[axis]);
  if (found != derivation.definitions.places.end()) place = &found->second;
  if (place == nullptr || !place->is_definition) return {};
  const std::string& name = derivation.definitions.list[place->index].name;
  return name.empty() ? std::string() : "force_" + name;
}

/// m (p'' - gravity) on each mass, p'' by a second pass in `second` over the velocity.
std::vector<Weighted> inertial_forces(Derivation& derivation, Tangent& second) {
  const std::array<ex, 3> g = gravity_vector(derivation);
  return derivation.on_masses([&](const PointMass& mass, std::size_t axis) {
    const ex acceleration =
        mass.kinetic
            ? second(define(derivation.definitions, derivation.coasting(mass.position[axis])))
            : ex(0);
    const ex force = mass.mass * (acceleration - g[axis]);
    return define(derivation.definitions, force, {force_name(mass, derivation, axis), mass.origin});
  });
}

/// -F on each point force, so that it joins the forces of the left side.
std::vector<Weighted> negative_point_forces(Derivation& derivation, Inputs inputs) {
  std::vector<Weighted> result;
  Seeds none;
  for (const ex& input : derivation.symbols.u) none.emplace(input, 0);
  Substitution without_inputs(derivation.definitions, none);
  for (const PointForce& applied : derivation.lagrangian.point_forces) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const ex& force = applied.force[axis];
      const ex acting = inputs == Inputs::acting ? force : without_inputs(force);
      result.push_back({applied.position[axis], -acting});
    }
  }
  return result;
}

Vector direct_forces(Derivation& derivation, Inputs inputs) {
  if (inputs == Inputs::acting) return derivation.lagrangian.forces;
  Seeds none;
  for (const ex& input : derivation.symbols.u) none.emplace(input, 0);
  Substitution without_inputs(derivation.definitions, none);
  Vector result;
  for (const ex& force : derivation.lagrangian.forces) result.push_back(without_inputs(force));
  return result;
}

/// Everything of tau that `second` gives: inertia, gravity, dissipation, forces.
Vector left_side(Derivation& derivation, Tangent& second, Inputs inputs) {
  std::vector<Weighted> pulled_back = inertial_forces(derivation, second);
  append(pulled_back, negative_point_forces(derivation, inputs));
  for (const Weighted& term : derivation.other_lagrangian()) {
    pulled_back.push_back({term.value, -term.weight});
  }
  Vector result = derivation.by_position(pulled_back);
  result = plus(result, rates(derivation.by_velocity(derivation.other_lagrangian()), second));
  result = plus(result, dissipation(derivation));
  const Vector direct = direct_forces(derivation, inputs);
  for (std::size_t i = 0; i < result.size(); ++i) result[i] -= direct[i];
  return result;
}

}  // namespace

Vector inverse_dynamics(Derivation& derivation) {
  return left_side(derivation, derivation.motion, Inputs::absent);
}

Vector bias(Derivation& derivation, Inputs inputs) {
  return left_side(derivation, derivation.coasting, inputs);
}

Vector velocity_force(Derivation& derivation) {
  Definitions& definitions = derivation.definitions;
  std::vector<Weighted> pulled_back =
      derivation.on_masses([&](const PointMass& mass, std::size_t axis) {
        if (!mass.kinetic) return ex(0);
        const ex velocity = define(definitions, derivation.frozen(mass.position[axis]));
        return define(definitions, mass.mass * derivation.frozen(velocity));
      });
  const Terms& kinetic = derivation.graded().kinetic2;
  append(pulled_back, weighted(kinetic, -1));
  const Vector momentum = derivation.by_velocity(weighted(kinetic, 1));
  const Vector result = derivation.by_position(pulled_back);
  return plus(result, rates(momentum, derivation.frozen));
}

Vector drift(Derivation& derivation) {
  Definitions& definitions = derivation.definitions;
  // p'' less its part quadratic in v: 2 d/dt(dp/dq v) at fixed q + d2p/dt2 at fixed q.
  std::vector<Weighted> pulled_back =
      derivation.on_masses([&](const PointMass& mass, std::size_t axis) {
        if (!mass.kinetic) return ex(0);
        const ex passing = define(definitions, derivation.passing(mass.position[axis]));
        const ex at_rest = derivation.passing(passing);
        const ex acceleration = at_rest + 2 * derivation.frozen(passing);
        return define(definitions, mass.mass * acceleration);
      });
  const GradedEnergies& energies = derivation.graded();
  std::vector<Weighted> linear = weighted(energies.kinetic1, 1);
  append(linear, weighted(energies.potential1, -1));
  for (const Weighted& term : linear) pulled_back.push_back({term.value, -term.weight});
  append(pulled_back, weighted(energies.kinetic0, -1));

  Vector result = derivation.by_position(pulled_back);
  result = plus(result, rates(derivation.by_velocity(linear), derivation.coasting));
  const Vector quadratic = derivation.by_velocity(weighted(energies.kinetic2, 1));
  return plus(result, rates(quadratic, derivation.passing));
}

Vector gravity(Derivation& derivation) {
  const std::array<ex, 3> g = gravity_vector(derivation);
  std::vector<Weighted> pulled_back =
      derivation.on_masses([&](const PointMass& mass, std::size_t axis) {
        return define(derivation.definitions, -mass.mass * g[axis]);
      });
  append(pulled_back, weighted(derivation.graded().potential0, 1));
  return derivation.by_position(pulled_back);
}

Vector dissipation(Derivation& derivation) {
  return gradient(derivation.definitions, weighted(derivation.lagrangian.dissipation, 1),
                  derivation.symbols.v);
}

Vector applied_force(Derivation& derivation, Inputs inputs) {
  Vector result = derivation.by_position(negative_point_forces(derivation, inputs));
  const Vector direct = direct_forces(derivation, inputs);
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = direct[i] - result[i];
  return result;
}

Vector momentum(Derivation& derivation) {
  const std::vector<Weighted> of_masses =
      derivation.on_masses([&](const PointMass& mass, std::size_t axis) {
        if (!mass.kinetic) return ex(0);
        const ex velocity =
            define(derivation.definitions, derivation.coasting(mass.position[axis]));
        return define(derivation.definitions, mass.mass * velocity);
      });
  const Vector result = derivation.by_position(of_masses);
  return plus(result, derivation.by_velocity(derivation.other_lagrangian()));
}

}  // namespace elgen
