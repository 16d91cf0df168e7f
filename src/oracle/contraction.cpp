// Contractions: the equations of the output table, each multiplied by w from the left.
#include "contraction.hpp"

namespace elgen::oracle {
namespace {

using cln::cl_R;

/// w.C v = d/dq (w.M v) v - 1/2 d/dq (v.M v) w + w.[v]x M v
cl_R velocity_force(Mechanics& at, const Direction& w) {
  const Direction& v = at.state().v;
  return at.mass_gradient(v, w, v) - at.mass_gradient(w, v, v) / 2 + at.turned_mass(w, v, v);
}

/// w.C y = 1/2 (d/dq (w.M y) v + d/dq (w.M v) y - d/dq (y.M v) w), and for angular velocities
/// + 1/2 w.([v]x M y + [y]x M v + M [v]x y): half the gradient of w.C v, and what makes dM/dt - 2 C
/// skew.
cl_R coriolis(Mechanics& at, const Direction& w, const Direction& y) {
  const Direction& v = at.state().v;
  const cl_R christoffel =
      at.mass_gradient(v, w, y) + at.mass_gradient(y, w, v) - at.mass_gradient(w, y, v);
  return (christoffel + turning(at, w, y)) / 2;
}

cl_R bias(Mechanics& at, const Direction& w) {
  return at.inverse_dynamics(w, Direction(at.size(), cl_R(0)));
}

/// What of the bias no other output holds.
cl_R drift(Mechanics& at, const Direction& w) {
  return bias(at, w) - velocity_force(at, w) - at.gravity(w) - at.dissipation_force(w) +
         at.applied_force(w);
}

}  // namespace

cl_R turning(Mechanics& at, const Direction& w, const Direction& y) {
  const Direction& v = at.state().v;
  return at.turned_mass(w, v, y) + at.turned_mass(w, y, v) - at.turned_mass(y, v, w);
}

bool is_contractible_column(OutputKind kind) {
  switch (kind) {
    case OutputKind::velocity_force:
    case OutputKind::gravity:
    case OutputKind::drift:
    case OutputKind::dissipation:
    case OutputKind::applied_force:
    case OutputKind::bias:
    case OutputKind::momentum:
    case OutputKind::inverse_dynamics:
      return true;
    default:
      return false;
  }
}

bool is_contractible_matrix(OutputKind kind) {
  return kind == OutputKind::mass_matrix || kind == OutputKind::coriolis_matrix ||
         kind == OutputKind::input_matrix;
}

cl_R contracted_column(OutputKind kind, Mechanics& at, const Direction& w) {
  switch (kind) {
    case OutputKind::velocity_force:
      return velocity_force(at, w);
    case OutputKind::gravity:
      return at.gravity(w);
    case OutputKind::drift:
      return drift(at, w);
    case OutputKind::dissipation:
      return at.dissipation_force(w);
    case OutputKind::applied_force:
      return at.applied_force(w);
    case OutputKind::bias:
      return bias(at, w);
    case OutputKind::momentum:
      return at.momentum(w);
    default:
      return at.inverse_dynamics(w, at.state().a);
  }
}

cl_R contracted_matrix(OutputKind kind, Mechanics& at, const Direction& w, const Direction& y) {
  switch (kind) {
    case OutputKind::mass_matrix:
      return at.mass(w, y);
    case OutputKind::coriolis_matrix:
      return coriolis(at, w, y);
    default:
      return at.input_force(w, y);
  }
}

}  // namespace elgen::oracle
