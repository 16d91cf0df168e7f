// Contractions: the equations of the output table, each multiplied by w from the left.
#include "oracle/contraction.hpp"

namespace elgen::oracle {

using cln::cl_R;

cl_R turning(Mechanics& at, const Direction& w, const Direction& y) {
  const Direction& v = at.state().v;
  return at.turned_mass(w, v, y) + at.turned_mass(w, y, v) - at.turned_mass(y, v, w);
}

cl_R velocity_force(Mechanics& at, const Direction& w) {
  const Direction& v = at.state().v;
  return at.mass_gradient(v, w, v) - at.mass_gradient(w, v, v) / 2 + at.turned_mass(w, v, v);
}

cl_R coriolis(Mechanics& at, const Direction& w, const Direction& y) {
  const Direction& v = at.state().v;
  const cl_R christoffel =
      at.mass_gradient(v, w, y) + at.mass_gradient(y, w, v) - at.mass_gradient(w, y, v);
  return (christoffel + turning(at, w, y)) / 2;
}

cl_R bias(Mechanics& at, const Direction& w) {
  return at.inverse_dynamics(w, Direction(at.size(), cl_R(0)));
}

cl_R inverse_dynamics(Mechanics& at, const Direction& w) {
  return at.inverse_dynamics(w, at.state().a);
}

cl_R drift(Mechanics& at, const Direction& w) {
  return bias(at, w) - velocity_force(at, w) - at.gravity(w) - at.dissipation_force(w) +
         at.applied_force(w);
}

}  // namespace elgen::oracle
