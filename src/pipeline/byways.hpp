// By-ways of the pipeline: what it makes of several stages at once, and what needs equations of its
// own.
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
/// and compose in one go. Errors of derive() and lower().
[[nodiscard]] Result<Program> recursive_program(const Lagrangian& lagrangian,
                                                const std::vector<OutputRequest>& outputs,
                                                const Limits& limits);

/// The functions of a scene in the forms in which they are emitted, and the step that is made of
/// some. Errors of choose() and add_step(). Cost: what `step` calls is derived once more, in its
/// own name.
[[nodiscard]] Result<Choice> chosen(const Lagrangian& lagrangian, const Program& recursive,
                                    const ClosedForms& forms, const CheckedModel& checked,
                                    const Limits& limits);

/// The verdicts about every [[equilibrium]].
[[nodiscard]] Result<std::vector<JudgedEquilibrium>> claims(const Lagrangian& lagrangian,
                                                            const CheckedModel& checked,
                                                            const Limits& limits);

/// The content of pages; that of a scene without a page has no functions. E915.
[[nodiscard]] Result<Book> book_of(const Lagrangian& lagrangian, const ClosedForms& forms,
                                   const Choice& choice, const CheckedModel& checked,
                                   const Limits& limits);

/// The book that is made; where that throws, the forms of code and a note, E915: no page stops
/// code.
[[nodiscard]] Result<Book> book_or_code(const Program& code, const std::function<Book()>& make);

/// A derivation step by step, as it is read. The steps are treated like every output: lowered,
/// presented, and read in their closed forms.
[[nodiscard]] Result<ReadableSteps> readable_steps(const Lagrangian& lagrangian,
                                                   const CheckedModel& checked,
                                                   const Limits& limits);

}  // namespace elgen
