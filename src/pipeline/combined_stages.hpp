// Functions that combine several stages of the pipeline, or that need additional equations.
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

/// The program of `outputs`, made by the stages derive, lower and cancel and by compose_outputs(),
/// before forms are chosen. Errors of derive() and lower().
[[nodiscard]] Result<Program> derive_recursive_program(const Lagrangian& lagrangian,
                                                       const std::vector<OutputRequest>& outputs,
                                                       const Limits& limits);

/// Chooses the emitted forms of a scene's functions, and adds the integration steps, which call
/// functions in these forms. Errors of choose() and add_step(). Cost: the functions that a step
/// calls are derived separately.
[[nodiscard]] Result<FormChoice> choose_forms(const Lagrangian& lagrangian,
                                              const Program& recursive, const ClosedForms& forms,
                                              const CheckedModel& checked, const Limits& limits);

/// The verdict on each [[equilibrium]] of the model.
[[nodiscard]] Result<std::vector<EquilibriumVerdict>> check_claims(const Lagrangian& lagrangian,
                                                                   const CheckedModel& checked,
                                                                   const Limits& limits);

/// The programs of the scene's page; empty programs if the scene has no page. If the page cannot be
/// made, the page shows the forms of code, with the note E915.
[[nodiscard]] Result<PagePrograms> make_page_programs(const Lagrangian& lagrangian,
                                                      const ClosedForms& forms,
                                                      const FormChoice& choice,
                                                      const CheckedModel& checked,
                                                      const Limits& limits);

/// The programs that `make` returns. If `make` throws, the page shows the forms of `code`, with the
/// note E915, because a failing page must not prevent code. std::bad_alloc is not caught.
[[nodiscard]] Result<PagePrograms> make_page_or_code(const Program& code,
                                                     const std::function<PagePrograms()>& make);

/// The derivation step by step, for readers. Its equations are lowered, presented and typeset like
/// outputs. Includes the solution for the accelerations and multipliers.
[[nodiscard]] Result<ReadableDerivation> make_readable_derivation(const Lagrangian& lagrangian,
                                                                  const CheckedModel& checked,
                                                                  const Limits& limits);

}  // namespace elgen
