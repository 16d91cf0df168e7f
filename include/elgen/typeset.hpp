// typeset: closed forms -> functions as books write them, for pages and `show`. Code, its comments
// and the sidecar use the forms of choose(), which do not depend on how an energy is typed.
//
//     V = 1/2*k*x1^2 + 1/2*kc*(x2 - x1)^2    each summand of an energy as typed
//     m*l^2*a + m*g*l*sin(x) = 0             order of terms: accelerations, products of rates (each
//                                            with one coefficient), dD/dv, then the terms of V in
//                                            the order of its summands
//
// Order of factors: number, parameters as typed, sums, coordinates, rates, accelerations,
// functions.
#pragma once

#include <cstdint>
#include <vector>

#include "elgen/closed_forms.hpp"
#include "elgen/model.hpp"
#include "elgen/program.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// Rewrites the `readable` functions of the program as in books. Entries whose closed form is
/// missing or too long, expanded equations, and equations from Routh's function do not change.
[[nodiscard]] Program typeset(const CheckedModel& checked, const ClosedForms& forms,
                              Program program);

/// True if every entry has a closed form that is short enough to be read.
[[nodiscard]] bool is_readable(const ClosedFunction& function);
/// True if some entry has a closed form that is short enough to be read.
[[nodiscard]] bool has_short_entry(const ClosedFunction& function);

/// Returns `derived`, the program of elgen/steps.hpp, in which one entry, the sum, replaces the
/// summands of each field. Program::functions keep the definitions of the derivation, and
/// Program::readable has the same functions as books write them. The function of a velocity has the
/// fields of LagrangeStepField; there, a field that is too long has no entries.
///
/// A last function is added, with one field per velocity: the equation of motion, solved for the
/// acceleration of the velocity. The field has no rows if the scene expands the equations,
/// if constraints act, if a closed form is missing or too long, if the equation contains two other
/// accelerations, or if the equation of the other acceleration contains a third acceleration.
[[nodiscard]] Program typeset_derivation(const CheckedModel& checked, const ClosedForms& forms,
                                         Program derived);

/// The fields of the function of a velocity: the fields of elgen/steps.hpp, and `left`, which is
/// d/dt dL/dv - dL/dq + dD/dv.
enum class LagrangeStepField : std::uint8_t {
  momentum,
  momentum_rate,
  partial,
  dissipation,
  force,
  left
};

/// A function of the leaves whose only entry is `form`, written as in books. If the book form is
/// too long, the entry has the shortest form. If both forms are too long to read, the function has
/// no fields. New constants are added to `program`.
[[nodiscard]] Function typeset_value(const Model& model, const Algebra& algebra,
                                     const Fraction& form, Program& program);

}  // namespace elgen
