// Replaces leaves by values in every expression of a Lagrangian, one member after the other.
// Removes variables from every list that has an entry per variable.
#include <utility>

#include "derive/specialise/passes.hpp"

namespace elgen {

namespace {

using GiNaC::ex;

class MemberSubstitution {
 public:
  MemberSubstitution(Definitions& definitions, const Seeds& values)
      : substitution_(definitions, values) {}

  void operator()(ex& value) { value = substitution_(value); }
  template <class List>
  void operator()(List& list) {
    for (auto& entry : list) (*this)(entry);
  }
  void operator()(PointMass& mass) {
    (*this)(mass.mass);
    (*this)(mass.position);
  }
  void operator()(EnergyTerm& term) { (*this)(term.value); }
  void operator()(RotatingBody& body) {
    (*this)(body.spin);
    (*this)(body.inertia);
  }
  void operator()(PointForce& force) {
    (*this)(force.position);
    (*this)(force.force);
  }
  void operator()(TreeTransform& step) {
    (*this)(step.vector);
    (*this)(step.angle);
    (*this)(step.quaternion);
  }
  void operator()(RigidBody& body) {
    (*this)(body.mass);
    (*this)(body.com);
    (*this)(body.inertia);
  }
  void operator()(Wrench& wrench) {
    (*this)(wrench.at);
    (*this)(wrench.force);
    (*this)(wrench.moment);
  }
  void operator()(ConstraintEquation& constraint) {
    (*this)(constraint.value);
    (*this)(constraint.damping);
    (*this)(constraint.stiffness);
  }
  void operator()(NamedOutput& output) { (*this)(output.values); }
  void operator()(HeldCoordinateMotion& held) { (*this)(held.values); }
  void operator()(SmallLeaf& small) { (*this)(small.value); }

 private:
  Substitution substitution_;
};

}  // namespace

void substitute_leaves(UnreducedLagrangian& lagrangian, const Seeds& values) {
  MemberSubstitution substitute(lagrangian.definitions, values);
  substitute(lagrangian.masses);
  if (lagrangian.gravity) substitute(*lagrangian.gravity);
  substitute(lagrangian.kinetic);
  substitute(lagrangian.potential);
  substitute(lagrangian.dissipation);
  substitute(lagrangian.lagrangian);
  substitute(lagrangian.forces);
  substitute(lagrangian.point_forces);
  substitute(lagrangian.rotating_bodies);
  substitute(lagrangian.armatures);
  substitute(lagrangian.tree.transforms);
  substitute(lagrangian.tree.bodies);
  substitute(lagrangian.tree.wrenches);
  substitute(lagrangian.constraints);
  substitute(lagrangian.outputs);
  substitute(lagrangian.locked);
  substitute(lagrangian.cyclic);
  substitute(lagrangian.cyclic_rates);
  if (lagrangian.expansion) substitute(lagrangian.expansion->small);
}

void remove_variables(UnreducedLagrangian& lagrangian, std::vector<HeldCoordinateMotion>& variables,
                      const Seeds& values) {
  substitute_leaves(lagrangian, values);
  Symbols& symbols = lagrangian.symbols;
  RemainingVariables left{RemainingIndices(symbols.q.size()), RemainingIndices(symbols.v.size()),
                          RemainingIndices(symbols.u.size())};
  for (const HeldCoordinate& variable : std::exchange(variables, {})) left.remove(variable);
  for (const std::uint32_t input : std::exchange(lagrangian.held_inputs, {})) {
    left.inputs.remove(input, 1);
  }
  const auto remove = [&](const LeafRow& row, auto& list) {
    if (row.owner == LeafOwner::coordinates) left.coordinates.erase_removed(list);
    if (row.owner == LeafOwner::velocities) left.velocities.erase_removed(list);
    if (row.owner == LeafOwner::inputs) left.inputs.erase_removed(list);
  };
  for_each_list(remove, symbols);
  for_each_list(remove, lagrangian.leaves);
  left.coordinates.erase_removed(symbols.q_rates);
  left.velocities.erase_removed(lagrangian.forces);
  left.velocities.erase_removed(lagrangian.armatures);
  std::erase_if(symbols.rotations, [&](const RotationPlace& place) {
    return !left.coordinates[place.first_coordinate];
  });
  for (RotationPlace& place : symbols.rotations) {
    place = {*left.coordinates[place.first_coordinate], *left.velocities[place.first_velocity]};
  }
  for (TreeTransform& step : lagrangian.tree.transforms) {
    if (step.rotation) step.rotation = left.velocities[*step.rotation];
  }
  for (HeldCoordinate& cyclic : lagrangian.cyclic) {
    cyclic.coordinate = *left.coordinates[cyclic.coordinate];
    cyclic.velocity = *left.velocities[cyclic.velocity];
  }
}

}  // namespace elgen
