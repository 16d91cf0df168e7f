// typeset: closed forms -> functions as books write them, for pages and `show`. Code, its comments
// and the sidecar use the forms of choose(), which do not depend on how an energy is typed.
//
//     V = 1/2*k*x1^2 + 1/2*kc*(x2 - x1)^2    each summand of an energy as typed
//     m*l^2*a + m*g*l*sin(x) = 0             accelerations first, one coefficient each; products of
//                                            rates, each once; dD/dv; then V, summand by summand
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

/// Rewrites the `readable` functions of the program as in books, except entries whose closed form
/// is missing or too long. Equations that a scene expands, and equations from Routh's function, are
/// unchanged.
[[nodiscard]] Program typeset(const CheckedModel& checked, const ClosedForms& forms,
                              Program program);

/// True if every entry has a closed form that is short enough.
[[nodiscard]] bool is_readable(const ClosedFunction& function);
/// True if some entry has a closed form that is short enough.
[[nodiscard]] bool has_short_entry(const ClosedFunction& function);

/// The program of elgen/steps.hpp with one entry for each sum of summands: `functions` over the
/// definitions of the derivation, `readable` as in books. The function of a velocity has the fields
/// of BookField. The last function has one field per acceleration. The field has no rows if
/// constraints act, if a closed form is missing, or if the equation contains two other
/// accelerations. It has none either if the other acceleration's equation contains a third.
[[nodiscard]] Program typeset_steps(const CheckedModel& checked, const ClosedForms& forms,
                                    Program derived);

/// The fields of the function of a velocity: the fields of elgen/steps.hpp, and left = d/dt dL/dv -
/// dL/dq + dD/dv.
enum class BookField : std::uint8_t { momentum, momentum_rate, partial, dissipation, force, left };

/// A function with one value as its only entry, written over the leaves as in books, or in its
/// shortest form if that is too long. Without fields if both are too long to read.
[[nodiscard]] Function typeset_value(const Model& model, const Algebra& algebra,
                                     const Fraction& form, Program& program);

}  // namespace elgen
