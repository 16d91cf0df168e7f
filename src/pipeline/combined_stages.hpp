// By-ways of the pipeline: functions that combine several stages, or need additional equations.
#pragma once

#include <functional>

#include "elgen/analyse.hpp"
#include "elgen/choose.hpp"
#include "elgen/closed_forms.hpp"
#include "elgen/equations_of_motion.hpp"
#include "elgen/lagrangian.hpp"
#include "elgen/limits.hpp"
#include "elgen/page.hpp"
#include "elgen/program.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// The program of some outputs of the Lagrangian, before forms are chosen: derive, lower, cancel
/// and compose in one call. Errors of derive() and lower().
[[nodiscard]] Result<Program> recursive_program(const Lagrangian& lagrangian,
                                                const std::vector<OutputRequest>& outputs,
                                                const Limits& limits);

/// The functions of a scene in the forms that are emitted, and the integration steps that call such
/// functions. Errors of choose() and add_step(). Cost: the functions that `step` calls are derived
/// again.
[[nodiscard]] Result<Choice> choose_forms(const Lagrangian& lagrangian, const Program& recursive,
                                          const ClosedForms& forms, const CheckedModel& checked,
                                          const Limits& limits);

/// The verdict on every [[equilibrium]].
[[nodiscard]] Result<std::vector<EquilibriumVerdict>> claims(const Lagrangian& lagrangian,
                                                             const CheckedModel& checked,
                                                             const Limits& limits);

/// The content of pages. If the scene has no page, it has no functions. E915.
[[nodiscard]] Result<Book> book_of(const Lagrangian& lagrangian, const ClosedForms& forms,
                                   const Choice& choice, const CheckedModel& checked,
                                   const Limits& limits);

/// The book that `make` returns. If `make` throws, the forms of code and the note E915, because a
/// page must not prevent code.
[[nodiscard]] Result<Book> book_or_code(const Program& code, const std::function<Book()>& make);

/// The derivation step by step, for readers. Steps are lowered, presented and typeset in their
/// closed forms, as every output is.
[[nodiscard]] Result<ReadableSteps> readable_steps(const Lagrangian& lagrangian,
                                                   const CheckedModel& checked,
                                                   const Limits& limits);

}  // namespace elgen
