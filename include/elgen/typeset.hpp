// typeset: closed forms -> functions written as books write them, for people: pages and `show`.
// Code, its comments and the sidecar have the forms of choose, which do not depend on how an energy
// is typed.
//
//     V = 1/2*k*x1^2 + 1/2*kc*(x2 - x1)^2    each summand of an energy as typed
//     m*l^2*a + m*g*l*sin(x) = 0             accelerations first, one coefficient each; products of
//                                            rates, each once; dD/dv; then V, summand by summand
//
// Factors: a number, parameters as typed, sums, coordinates, rates, accelerations, functions.
#pragma once

#include <cstdint>
#include <vector>

#include "elgen/closed_forms.hpp"
#include "elgen/model.hpp"
#include "elgen/program.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// The program with its `readable` functions written as in books, but for entries of which the
/// closed form is missing or too long. Equations that a scene expands, and those of Routh's
/// function, stay as they are.
[[nodiscard]] Program typeset(const CheckedModel& checked, const ClosedForms& forms,
                              Program program);

/// Whether every entry has a closed form that is short enough.
[[nodiscard]] bool is_readable(const ClosedFunction& function);
/// Whether some entry has.
[[nodiscard]] bool has_short_entry(const ClosedFunction& function);

/// The program of elgen/steps.hpp with one entry for every sum of summands: `functions` over the
/// definitions of the derivation, `readable` as books write them. Of a velocity there are the
/// fields of BookLine. One more function, the last, has a field for each acceleration: without rows
/// where its equation holds two others, or one whose equation holds a third, or has no closed form,
/// and where constraints act.
[[nodiscard]] Program typeset_steps(const CheckedModel& checked, const ClosedForms& forms,
                                    Program derived);

/// The fields of the function of a velocity: those of elgen/steps.hpp, and d/dt dL/dv - dL/dq
/// + dD/dv.
enum class BookLine : std::uint8_t { momentum, momentum_rate, partial, dissipation, force, left };

/// One value, as the only entry of a function, over the leaves: definitions are filled in. In its
/// shortest form where it is too long for a book, without fields where nobody reads that.
[[nodiscard]] Function typeset_value(const Model& model, const Algebra& algebra,
                                     const Fraction& form, Program& program);

}  // namespace elgen
