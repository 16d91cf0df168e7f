// Contractions: one number w.x of a column x, or w.X y of a matrix X, from a few directional
// derivatives: those of outputs that are no single derivative of an energy.
#pragma once

#include "oracle/mechanics.hpp"

namespace elgen::oracle {

/// w.([v]x M y + [y]x M v + M [v]x y) on the velocities of rotations, v the state's.
[[nodiscard]] cln::cl_R turning(Mechanics& at, const Direction& w, const Direction& y);

/// w.C v = d/dq (w.M v) v - 1/2 d/dq (v.M v) w + w.[v]x M v
[[nodiscard]] cln::cl_R velocity_force(Mechanics& at, const Direction& w);

/// w.C y = 1/2 (d/dq (w.M y) v + d/dq (w.M v) y - d/dq (y.M v) w), and for angular velocities
/// + 1/2 w.([v]x M y + [y]x M v + M [v]x y): half the gradient of w.C v, and what makes dM/dt - 2 C
/// skew.
[[nodiscard]] cln::cl_R coriolis(Mechanics& at, const Direction& w, const Direction& y);

/// w.(tau at a = 0)
[[nodiscard]] cln::cl_R bias(Mechanics& at, const Direction& w);

/// w.tau at the state's a
[[nodiscard]] cln::cl_R inverse_dynamics(Mechanics& at, const Direction& w);

/// The part of the bias that no other output holds.
[[nodiscard]] cln::cl_R drift(Mechanics& at, const Direction& w);

}  // namespace elgen::oracle
