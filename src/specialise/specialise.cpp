// specialise: fixed parameters become numbers throughout a Lagrangian.
//
//     before    p = l*sin(q), T = 1/2*m*p_dot^2      l = 1/2 fixed
//     after     p = 1/2*sin(q), T = 1/2*m*p_dot^2
//
// What vanishes is no longer reached from any energy, force or output, so later stages never see
// it. Then what a scene expands is expanded (expand.hpp).
#include "elgen/specialise.hpp"

#include <utility>

#include "formulate/chain_rule.hpp"
#include "specialise/expand.hpp"

namespace elgen {

namespace {

using GiNaC::ex;

class Specialiser {
 public:
  Specialiser(Lagrangian& lagrangian, const Specialisation& specialisation)
      : substitution_(lagrangian.definitions, values(lagrangian, specialisation)) {}

  void operator()(ex& value) { value = substitution_(value); }
  void operator()(std::vector<ex>& list) {
    for (ex& value : list) (*this)(value);
  }
  void operator()(std::array<ex, 3>& vector) {
    for (ex& value : vector) (*this)(value);
  }

 private:
  static Seeds values(const Lagrangian& lagrangian, const Specialisation& specialisation) {
    Seeds seeds;
    for (const auto& [parameter, number] : specialisation.fixed) {
      seeds.emplace(lagrangian.symbols.parameters[parameter], GiNaC::numeric(number));
    }
    return seeds;
  }

  Substitution substitution_;
};

Lagrangian with_fixed(Lagrangian lagrangian, const Specialisation& specialisation) {
  Specialiser specialised(lagrangian, specialisation);
  for (PointMass& mass : lagrangian.masses) {
    specialised(mass.mass);
    specialised(mass.position);
  }
  if (lagrangian.gravity) specialised(*lagrangian.gravity);
  specialised(lagrangian.kinetic);
  specialised(lagrangian.potential);
  specialised(lagrangian.dissipation);
  specialised(lagrangian.lagrangian);
  specialised(lagrangian.forces);
  for (PointForce& force : lagrangian.point_forces) {
    specialised(force.position);
    specialised(force.force);
  }
  for (TreeStep& step : lagrangian.tree.steps) {
    specialised(step.vector);
    specialised(step.angle);
    for (ex& component : step.quaternion) specialised(component);
  }
  for (RigidBody& body : lagrangian.tree.bodies) {
    specialised(body.mass);
    specialised(body.com);
    specialised(body.inertia);
  }
  for (Wrench& wrench : lagrangian.tree.wrenches) {
    specialised(wrench.at);
    specialised(wrench.force);
    specialised(wrench.moment);
  }
  for (NamedOutput& output : lagrangian.outputs) specialised(output.values);
  if (lagrangian.expansion) {
    for (SmallLeaf& leaf : lagrangian.expansion->small) specialised(leaf.value);
  }
  return lagrangian;
}

}  // namespace

Lagrangian specialise(Lagrangian lagrangian, const Specialisation& specialisation) {
  if (!specialisation.fixed.empty()) {
    lagrangian = with_fixed(std::move(lagrangian), specialisation);
  }
  return lagrangian.expansion ? expanded(std::move(lagrangian)) : lagrangian;
}

}  // namespace elgen
