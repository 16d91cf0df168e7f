// The regressor: tau for a unit of each inertial parameter, and tau without inertial parameters.
// The columns of all bodies in frames share the motions of the transforms. The forces of a column
// start at the transform of its body.
#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <utility>

#include "derive/outputs/outputs.hpp"
#include "derive/tree/composite.hpp"

namespace elgen {

using GiNaC::ex;

namespace {

/// A Lagrangian with the variables, gravity and transforms of `all`, but without bodies, energies
/// and forces.
Lagrangian kinematics_of(const Lagrangian& all) {
  Lagrangian motion;
  motion.symbols = all.symbols;
  motion.leaves = all.leaves;
  motion.gravity = all.gravity;
  motion.tree.transforms = all.tree.transforms;
  motion.forces.assign(all.forces.size(), 0);
  motion.is_quadratic = all.is_quadratic;
  return motion;
}

/// Adds only the terms of `[energy]`, not the terms of bodies, points and armatures, which have a
/// different EnergyOrigin.
void add_stated_energies(const Lagrangian& all, Lagrangian& to) {
  const auto add = [](const EnergyTerms& terms, EnergyTerms& stated) {
    std::ranges::copy_if(
        terms, std::back_inserter(stated),
        [](EnergyOrigin origin) { return origin == EnergyOrigin::energy; }, &EnergyTerm::origin);
  };
  add(all.kinetic, to.kinetic);
  add(all.potential, to.potential);
  add(all.lagrangian, to.lagrangian);
}

/// Adds D and all declared forces.
void add_forces(const Lagrangian& all, Lagrangian& to) {
  to.dissipation = all.dissipation;
  to.forces = all.forces;
  to.point_forces = all.point_forces;
  to.tree.wrenches = all.tree.wrenches;
}

/// The inverse dynamics of `other`; new definitions are appended to the list of `derivation`.
RealVector inverse_dynamics_of(Derivation& derivation, Lagrangian other) {
  return derive_with_shared_definitions(derivation, std::move(other), [](Derivation& apart) {
    RealVector forces = inverse_dynamics(apart);
    for (ex& force : forces) force = define(apart.definitions, force);
    return forces;
  });
}

bool is_owner(const Entity& origin, const InertialParameter& parameter) {
  const bool is_body = parameter.owner == InertialOwner::body;
  return origin.index == parameter.index &&
         origin.kind == (is_body ? EntityKind::body : EntityKind::point);
}

/// The element of `list` whose origin is the owner of `parameter`; null if there is none.
template <class List>
auto* find_owner_entry(List& list, const InertialParameter& parameter) {
  const auto found = std::ranges::find_if(
      list, [&](const auto& entry) { return is_owner(entry.origin, parameter); });
  return found == list.end() ? nullptr : &*found;
}

/// A body with the transform of `body`, in which `parameter` is 1 and all other inertial parameters
/// are 0. Its centre of mass is the origin, or the point if `parameter` belongs to a point mass.
RigidBody unit_body(const RigidBody& body, const InertialParameter& parameter) {
  RigidBody unit;
  unit.transform = body.transform;
  unit.origin = body.origin;
  unit.com = {0, 0, 0};
  if (parameter.is_mass()) unit.mass = 1;
  if (parameter.owner == InertialOwner::point) {
    unit.com = body.com;
    return unit;
  }
  unit.is_about_origin = true;
  unit.moment = ExVector3{0, 0, 0};
  if (parameter.component >= first_inertia_component) {
    unit.inertia.assign(6, 0);
    unit.inertia[parameter.component - first_inertia_component] = 1;
  } else if (parameter.component >= first_moment_component) {
    (*unit.moment)[parameter.component - first_moment_component] = 1;
  }
  return unit;
}

/// 1/2 w.I w with one component of I equal to 1.
ex unit_energy(const RotatingBody& body, std::uint32_t component) {
  static constexpr std::array<std::array<std::size_t, 2>, 6> places{
      {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};
  if (body.spin.size() == 1) return body.spin[0] * body.spin[0] / 2;
  const auto& [i, j] = places[component - first_inertia_component];
  return body.spin[i] * body.spin[j] / (i == j ? 2 : 1);
}

/// The velocity index of a coordinate with an armature. A rotation has four coordinates, three
/// velocities and no armature.
std::uint32_t velocity_index(const Derivation& derivation, std::uint32_t coordinate) {
  std::uint32_t velocity = coordinate;
  for (const RotationPlace& rotation : derivation.symbols.rotations) {
    if (rotation.first_coordinate < coordinate) --velocity;
  }
  return velocity;
}

Seeds reference_seeds(const Symbols& symbols) {
  Seeds seeds;
  add_seeds(seeds, symbols.v, symbols.reference);
  return seeds;
}

/// Replaces one v by a reference velocity r in expressions x of degree 2: x0 + x1(v) + x2(v, v)
/// becomes x0 + x1(r) + x2(v, r). With T_v x the derivative along v -> r, the result is the sum of
///
///     x at v = 0,   1/2 T_v x   and   1/2 T_v x at v = 0
///
/// For rotations, a is replaced by a + 1/2 w x r, because C contains 1/2 M [w]x.
class Polarisation {
 public:
  explicit Polarisation(Derivation& derivation)
      : definitions_(derivation.definitions),
        along_(definitions_, reference_seeds(derivation.symbols)),
        at_rest_(definitions_, rest_seeds(derivation.symbols)),
        turned_accelerations_(definitions_, acceleration_seeds(derivation)) {}

  ex operator()(const ex& value) {
    const ex known = define(definitions_, value);
    const ex slope = define(definitions_, along_(known));
    // Separate statements fix the order of definitions; compilers evaluate operands in different
    // orders.
    const ex value_at_rest = at_rest_(known);
    const ex slope_at_rest = at_rest_(slope);
    const ex sum = value_at_rest + (slope + slope_at_rest) / 2;
    return turned_accelerations_(define(definitions_, sum));
  }
  template <class List>
  [[nodiscard]] List polarise_all(List values) {
    for (ex& value : values) value = (*this)(value);
    return values;
  }

 private:
  static Seeds rest_seeds(const Symbols& symbols) {
    Seeds seeds;
    add_seeds(seeds, symbols.v, RealVector(symbols.v.size(), 0));
    return seeds;
  }
  static Seeds acceleration_seeds(Derivation& derivation) {
    const Symbols& symbols = derivation.symbols;
    Seeds seeds;
    for (const RotationPlace& rotation : symbols.rotations) {
      const std::uint32_t first = rotation.first_velocity;
      for (const auto& [i, j, k] : cyclic_axes) {
        const ex across = symbols.v[first + j] * symbols.reference[first + k] -
                          symbols.v[first + k] * symbols.reference[first + j];
        const ex& a = symbols.a[first + i];
        seeds.emplace(a, define(derivation.definitions, a + across / 2));
      }
    }
    return seeds;
  }

  Definitions& definitions_;
  Tangent along_;
  Substitution at_rest_;
  Substitution turned_accelerations_;
};

class RegressorColumns {
 public:
  RegressorColumns(Derivation& derivation, bool has_reference)
      : derivation_(derivation),
        tree_(tree_of(derivation)),
        motions_(tree_motions(
            tree_, {derivation.rate_without_acceleration, derivation.motion_rate, true})) {
    if (has_reference) polarise_motions();
    rest_ = other_forces();
  }

  RealVector column(const InertialParameter& parameter) {
    switch (parameter.owner) {
      case InertialOwner::coordinate:
        return armature_column(parameter.index);
      case InertialOwner::parameter:
        return parameter_column(parameter.index);
      case InertialOwner::body:
      case InertialOwner::point:
        break;
    }
    const Lagrangian& all = derivation_.lagrangian;
    if (const auto* const body = find_owner_entry(all.tree.bodies, parameter)) {
      return body_column(unit_body(*body, parameter));
    }
    Lagrangian unit = kinematics_of(all);
    const auto* const turning = find_owner_entry(all.rotating_bodies, parameter);
    const auto* const mass = find_owner_entry(all.masses, parameter);
    if (!parameter.is_mass() && turning != nullptr) {
      unit.kinetic.push_back({unit_energy(*turning, parameter.component), EnergyOrigin::spin});
    } else if (mass != nullptr) {
      unit.masses = {{1, mass->position, mass->origin}};
    }
    return polarise_forces(inverse_dynamics_of(derivation_, std::move(unit)));
  }

  /// tau if every inertial parameter is 0.
  RealVector force_without_parameters() {
    Seeds values;
    for (const InertialParameter& parameter : derivation_.lagrangian.inertial) {
      if (parameter.owner == InertialOwner::parameter)
        values.emplace(parameter_symbol(parameter.index), 0);
    }
    Substitution without(derivation_.definitions, values);
    return define_and_substitute(without, derivation_.definitions, rest_);
  }

 private:
  void polarise_motions() {
    polarisation_.emplace(derivation_);
    for (TransformMotion& motion : motions_) {
      motion.spin_rate = polarisation_->polarise_all(motion.spin_rate);
      motion.acceleration = polarisation_->polarise_all(motion.acceleration);
      motion.acceleration_gradient = polarisation_->polarise_all(motion.acceleration_gradient);
      motion.spin_products = polarisation_->polarise_all(motion.spin_products);
    }
  }

  [[nodiscard]] RealVector polarise_forces(RealVector forces) {
    return polarisation_ ? polarisation_->polarise_all(std::move(forces)) : forces;
  }

  /// The generalised forces of [energy], D and the declared forces. With a reference velocity r,
  /// dD/dv is evaluated at v = r.
  RealVector other_forces() {
    const Lagrangian& all = derivation_.lagrangian;
    Lagrangian others = kinematics_of(all);
    add_stated_energies(all, others);
    if (!polarisation_) {
      add_forces(all, others);
      return inverse_dynamics_of(derivation_, std::move(others));
    }
    Substitution at_reference(derivation_.definitions, reference_seeds(derivation_.symbols));
    const RealVector friction =
        define_and_substitute(at_reference, derivation_.definitions, dissipation(derivation_));
    const RealVector applied = applied_force(derivation_);
    RealVector forces = polarise_forces(inverse_dynamics_of(derivation_, std::move(others)));
    forces = vector_sum(std::move(forces), friction);
    forces = vector_sum(std::move(forces), negate(applied));
    for (ex& force : forces) force = define(derivation_.definitions, force);
    return forces;
  }

  [[nodiscard]] const ex& parameter_symbol(std::uint32_t parameter) const {
    return derivation_.symbols.parameters[parameter];
  }

  RealVector body_column(const RigidBody& unit) {
    const std::vector<RigidBody> bodies = with_lifted_masses(tree_, {unit});
    return generalised_forces(derivation_, tree_.pull_back_wrenches(inertial_forces_on_transforms(
                                               tree_, bodies, motions_)));
  }

  RealVector armature_column(std::uint32_t coordinate) {
    RealVector column(derivation_.size(), 0);
    const std::uint32_t velocity = velocity_index(derivation_, coordinate);
    column[velocity] = derivation_.symbols.a[velocity];
    return column;
  }

  RealVector parameter_column(std::uint32_t parameter) {
    Tangent along(derivation_.definitions, Seeds{{parameter_symbol(parameter), 1}});
    RealVector column;
    for (const ex& force : rest_) column.push_back(along(force));
    return column;
  }

  Derivation& derivation_;
  KinematicTree& tree_;
  std::vector<TransformMotion> motions_;
  std::optional<Polarisation> polarisation_ = {};  ///< none without a reference velocity
  RealVector rest_ = {};
};

Regressor derive_regressor(Derivation& derivation, bool has_reference) {
  RegressorColumns columns(derivation, has_reference);
  const std::vector<InertialParameter> parameters = derivation.lagrangian.inertial;
  Regressor result{RealVector(derivation.size() * parameters.size()), {}};
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    const RealVector column = columns.column(parameters[k]);
    for (std::size_t i = 0; i < column.size(); ++i) {
      result.matrix[i * parameters.size() + k] = column[i];
    }
  }
  result.rest = columns.force_without_parameters();
  return result;
}

}  // namespace

Regressor regressor(Derivation& derivation) { return derive_regressor(derivation, false); }

Regressor regressor_reference(Derivation& derivation) { return derive_regressor(derivation, true); }

RealVector regressor_parameters(Derivation& derivation) {
  const Lagrangian& all = derivation.lagrangian;
  VectorAlgebra& algebra = tree_of(derivation).algebra;
  const auto value = [&](const InertialParameter& parameter) -> ex {
    if (parameter.owner == InertialOwner::parameter)
      return derivation.symbols.parameters[parameter.index];
    if (parameter.owner == InertialOwner::coordinate) {
      return all.armatures[velocity_index(derivation, parameter.index)];
    }
    if (const auto* const body = find_owner_entry(all.tree.bodies, parameter)) {
      const CompositeInertia inertia = inertia_about_origin(algebra, *body);
      if (parameter.is_mass()) return inertia.mass;
      return parameter.component < first_inertia_component
                 ? inertia.moment[parameter.component - first_moment_component]
                 : inertia.inertia[parameter.component - first_inertia_component];
    }
    if (parameter.is_mass()) return find_owner_entry(all.masses, parameter)->mass;
    const RotatingBody& body = *find_owner_entry(all.rotating_bodies, parameter);
    return body
        .inertia[body.inertia.size() == 1 ? 0 : parameter.component - first_inertia_component];
  };
  RealVector result;
  for (const InertialParameter& parameter : all.inertial) result.push_back(value(parameter));
  return result;
}

}  // namespace elgen
