// Combinations of stages: the choice of forms, with the integration steps that call the chosen
// functions; the claims of [[equilibrium]]; and the pages, with the steps of elgen/steps.hpp and
// the names of the masses.
#include "pipeline/combined_stages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <exception>
#include <functional>
#include <new>
#include <utility>

#include "elgen/cancel.hpp"
#include "elgen/certificate.hpp"
#include "elgen/choose.hpp"
#include "elgen/compose.hpp"
#include "elgen/integrate.hpp"
#include "elgen/lower.hpp"
#include "elgen/references.hpp"
#include "elgen/steps.hpp"
#include "elgen/typeset.hpp"
#include "model/requests.hpp"
#include "program/evaluate/subject.hpp"

namespace elgen {
namespace {

/// A Lagrangian, and the scene that requests the functions for which forms are chosen.
struct ChoiceInput {
  const Lagrangian& lagrangian;
  const Model& model;
  const Scene& scene;
  const Limits& limits;
};

bool is_energy(const OutputRequest& output) { return output_row(output.kind).is_energy; }

/// Chooses the forms of functions in which V is a leaf: only of the energies if dV/dq keeps its
/// form, otherwise of all functions.
Result<FormChoice> choose_open_forms(const ChoiceInput& input,
                                     const std::vector<GiNaC::ex>& variables,
                                     const RewrittenPotential& potential, const Domain& domain) {
  Scene scene = input.scene;
  if (!potential.has_derivatives) std::erase_if(scene.outputs, std::not_fn(is_energy));
  const Result<Program> open = derive_recursive_program(
      with_open_potential(input.lagrangian, variables), scene.outputs, input.limits);
  if (!open) return open.diagnostics;
  return choose(*open, present(*open), with_open_potential(domain, potential.program), scene);
}

/// V of [energy] and its derivatives by `variables`. No functions if V has no equations
/// (derive_potential()).
struct SeparatePotential {
  std::vector<GiNaC::ex> variables = {};
  Program program = {};
};

Result<SeparatePotential> derive_separate_potential(const ChoiceInput& input) {
  const bool has_second = std::ranges::any_of(
      input.scene.outputs,
      [](const OutputRequest& request) { return output_row(request.kind).differentiates; });
  const auto derived = derive_potential(input.lagrangian, has_second);
  if (!derived) return SeparatePotential{};
  Result<Program> lowered = lower(derived->equations, derived->requests, input.limits);
  if (!lowered) return lowered.diagnostics;
  return SeparatePotential{derived->variables, cancel(std::move(*lowered))};
}

/// If V gets another form, inserts this form into all functions.
Diagnostics add_potential(const ChoiceInput& input, const SeparatePotential& separate,
                          const Domain& domain, FormChoice& choice) {
  const auto potential = rewrite_potential(separate.program, domain, input.scene);
  if (!potential) return {};
  Result<FormChoice> open = choose_open_forms(input, separate.variables, *potential, domain);
  if (!open) return open.diagnostics;
  insert_potential(*potential, *open, domain, choice);
  return {};
}

/// Solves for accelerations by determinants of M if the chosen forms lose digits. M and the forces
/// are derived apart, because forward dynamics has no entries for them.
void add_solutions(const ChoiceInput& input, const Program& recursive, const Domain& domain,
                   FormChoice& choice) {
  for (std::size_t i = 0; i < recursive.functions.size(); ++i) {
    if (!may_solve_by_minors(input.scene, choice, i)) continue;
    const std::vector<OutputRequest> requests = available_requests(
        input.model, {OutputKind::mass_matrix, OutputKind::bias, OutputKind::input_matrix});
    const Result<Program> parts =
        derive_recursive_program(input.lagrangian, requests, input.limits);
    if (parts) solve_by_minors(*parts, recursive, domain, i, choice);
  }
}

/// Chooses the forms of a program's functions.
Result<FormChoice> choose_program_forms(const ChoiceInput& input, const Program& recursive,
                                        const ClosedForms& forms) {
  Domain domain = domain_of({input.model, input.scene, recursive.leaves});
  const Result<SeparatePotential> potential = derive_separate_potential(input);
  if (!potential) return potential.diagnostics;
  const bool has_potential = !potential->program.functions.empty();
  if (has_potential) domain.minima = find_potential_minima(potential->program, domain, input.scene);
  Result<FormChoice> choice = choose(recursive, forms, domain, input.scene);
  if (!choice) return choice;
  Diagnostics errors;
  if (has_potential) errors = add_potential(input, *potential, domain, *choice);
  if (!errors.empty()) return errors;
  add_solutions(input, recursive, domain, *choice);
  return choice;
}

/// The equations of `outputs` as a program without terms that cancel, before compose_outputs().
Result<Program> derive_parts(const Lagrangian& lagrangian,
                             const std::vector<OutputRequest>& outputs, const Limits& limits) {
  const Result<EquationsOfMotion> equations = derive(lagrangian, outputs, limits);
  if (!equations) return equations.diagnostics;
  Result<Program> lowered = lower(*equations, outputs, limits);
  if (!lowered) return lowered.diagnostics;
  return cancel(std::move(*lowered));
}

/// The functions that `step` calls; outputs in the forms that a scene with only these outputs would
/// have.
Result<StepCallees> derive_step_callees(const Lagrangian& lagrangian, const CheckedModel& checked,
                                        const OutputRequest& step, const Limits& limits) {
  StepCallees calls;
  Scene scene = checked.scene;
  scene.outputs = outputs_for_step(checked.model, step);
  if (!scene.outputs.empty()) {
    const Result<Program> recursive = derive_recursive_program(lagrangian, scene.outputs, limits);
    if (!recursive) return recursive.diagnostics;
    Result<FormChoice> choice = choose_program_forms({lagrangian, checked.model, scene, limits},
                                                     *recursive, present(*recursive));
    if (!choice) return choice.diagnostics;
    calls.outputs = std::move(choice->program);
  }
  const std::vector<OutputRequest> derivatives = parts_for_step(checked.model, step);
  if (derivatives.empty()) return calls;
  Result<Program> parts = derive_parts(lagrangian, derivatives, limits);
  if (!parts) return parts.diagnostics;
  calls.acceleration_parts = std::move(*parts);
  return calls;
}

/// Adds the costs of the step, which is the last function and has only one form.
void add_step_costs(FormChoice& choice) {
  const Function& step = choice.program.functions.back();
  choice.program.readable.emplace_back();
  choice.costs.push_back({step.name, count_operations(step)});
}

std::string name_of(const Model& model, const Entity& origin) {
  if (origin.kind == EntityKind::point) return model.points[origin.index].name;
  if (origin.kind == EntityKind::body) return model.bodies[origin.index].name;
  return {};
}

/// The model with the quotients of the file, not the Stumpff functions that replaced these
/// quotients. None if there are no quotients, or if the file itself contains Stumpff functions,
/// because pages then print the Stumpff functions.
std::optional<CheckedModel> with_quotients(const CheckedModel& checked) {
  if (checked.model.original_expressions.empty()) return std::nullopt;
  CheckedModel result = checked;
  Model& model = result.model;
  for (const auto& [id, quotient] : checked.model.original_expressions)
    model.expressions[id] = quotient;
  const bool has_series = std::ranges::any_of(
      reachable_expressions(model, equation_and_output_roots(model)), [&model](ExpressionId id) {
        const Expression& node = model.expressions[id];
        return node.kind == ExpressionKind::function && node.function == FunctionId::stumpff;
      });
  return has_series ? std::nullopt : std::optional(std::move(result));
}

/// The chosen program in the forms that pages print.
Program typeset_choice(const ClosedForms& forms, const FormChoice& choice,
                       const CheckedModel& checked) {
  const auto typed = with_quotients(checked);
  if (!typed) return typeset(checked, forms, choice.program);
  Program derived = choice.program;
  // Integration steps come last and have no forms.
  derived.functions.resize(forms.functions.size());
  return typeset(*typed, present_quotients(derived), choice.program);
}

/// True if some row of the equations of motion has a short closed form. Presents only the inverse
/// dynamics, row by row, at a tenth of the cost of the whole derivation.
bool has_short_row(const Lagrangian& lagrangian, const CheckedModel& checked,
                   const Limits& limits) {
  const std::vector<OutputRequest> requests =
      available_requests(checked.model, {OutputKind::inverse_dynamics});
  // Equations of constraints are rows, too.
  if (requests.empty() || !checked.model.constraints.empty()) return true;
  Result<Program> rows = derive_recursive_program(lagrangian, requests, limits);
  if (!rows) return true;
  const Function all = std::move(rows->functions.front());
  rows->functions.clear();
  for (const std::uint32_t entry : entries_of(all)) {
    rows->functions.push_back(with_entries(all, {entry}));
  }
  return std::ranges::any_of(present(*rows).functions, has_short_entry);
}

/// True if the mass matrix, the bias, gravity and the inverse dynamics, as far as the scene
/// requests them, are short enough to read.
bool has_readable_terms(const Program& program, const ClosedForms& forms) {
  const auto is_short = [&](OutputKind kind) {
    const auto term = std::ranges::find(program.functions, kind, &Function::kind);
    if (term == program.functions.end()) return true;
    return is_readable(forms.functions[static_cast<std::size_t>(term - program.functions.begin())]);
  };
  return std::ranges::all_of(std::array{OutputKind::mass_matrix, OutputKind::bias,
                                        OutputKind::gravity, OutputKind::inverse_dynamics},
                             is_short);
}

/// Lowers, presents and typesets steps like outputs.
template <class Steps, class Typeset>
Result<Program> read_steps(const Steps& steps, const Typeset& typeset_forms,
                           const CheckedModel& checked, const Limits& limits) {
  Result<Program> lowered = lower(steps.equations, steps.requests, limits);
  if (!lowered) return lowered.diagnostics;
  const Program recursive = cancel(std::move(*lowered));
  const auto typed = with_quotients(checked);
  const ClosedForms forms = typed ? present_quotients(recursive) : present(recursive);
  return typeset_forms(typed ? *typed : checked, forms, recursive);
}

/// The derivation without frames and without the solution for accelerations.
Result<ReadableDerivation> make_steps(const Lagrangian& lagrangian, const CheckedModel& checked,
                                      const Limits& limits) {
  const Result<DerivationSteps> derived = derive_textbook_steps(lagrangian);
  if (!derived) return derived.diagnostics;
  Result<Program> program = read_steps(*derived, typeset_derivation, checked, limits);
  if (!program) return program.diagnostics;
  ReadableDerivation result{.program = std::move(*program)};
  for (const Entity& mass : derived->masses) result.masses.push_back(name_of(checked.model, mass));
  return result;
}

/// Systems of more accelerations and multipliers are not solved on paper.
constexpr std::size_t largest_solved_system = 8;

/// The outputs of `solved`, which is forward dynamics, as pages print it (see
/// ReadableDerivation::solution).
Result<Program> solve_on_paper(const Lagrangian& lagrangian, const CheckedModel& solved,
                               const Limits& limits) {
  const Model& model = solved.model;
  if (model.velocities.size() + model.constraints.size() > largest_solved_system) return Program{};
  const Result<Program> recursive =
      derive_recursive_program(lagrangian, solved.scene.outputs, limits);
  if (!recursive) return recursive.diagnostics;
  const ClosedForms forms = present(*recursive);
  const Result<FormChoice> choice = choose_forms(lagrangian, *recursive, forms, solved, limits);
  if (!choice) return choice.diagnostics;
  return typeset_choice(forms, *choice, solved);
}

}  // namespace

Result<Program> derive_recursive_program(const Lagrangian& lagrangian,
                                         const std::vector<OutputRequest>& outputs,
                                         const Limits& limits) {
  Result<Program> parts = derive_parts(lagrangian, outputs, limits);
  if (!parts) return parts.diagnostics;
  return compose_outputs(std::move(*parts));
}

Result<FormChoice> choose_forms(const Lagrangian& lagrangian, const Program& recursive,
                                const ClosedForms& forms, const CheckedModel& checked,
                                const Limits& limits) {
  Result<FormChoice> choice =
      choose_program_forms({lagrangian, checked.model, checked.scene, limits}, recursive, forms);
  if (!choice) return choice;
  for (const OutputRequest& output : checked.scene.outputs) {
    if (!output_row(output.kind).is_step) continue;
    const Result<StepCallees> calls = derive_step_callees(lagrangian, checked, output, limits);
    if (!calls) return calls.diagnostics;
    Diagnostics errors = add_step(checked, output, *calls, choice->program);
    if (!errors.empty()) return errors;
    add_step_costs(*choice);
  }
  return choice;
}

Result<std::vector<EquilibriumVerdict>> check_claims(const Lagrangian& lagrangian,
                                                     const CheckedModel& checked,
                                                     const Limits& limits) {
  if (checked.model.equilibria.empty()) return std::vector<EquilibriumVerdict>{};
  const Result<Program> moving =
      derive_recursive_program(lagrangian, outputs_for_equilibria(checked.model), limits);
  if (!moving) return moving.diagnostics;
  return check_equilibria(checked, *moving);
}

Result<ReadableDerivation> make_readable_derivation(const Lagrangian& lagrangian,
                                                    const CheckedModel& checked,
                                                    const Limits& limits) {
  Result<ReadableDerivation> result = make_steps(lagrangian, checked, limits);
  if (!result) return result;
  const FrameSteps frames = derive_frame_steps(lagrangian, checked.model);
  Result<Program> motion = read_steps(frames, typeset, checked, limits);
  if (!motion) return motion.diagnostics;
  result->frames = std::move(*motion);
  result->frame_quantities = frames.quantities;
  CheckedModel solved = checked;
  solved.scene.outputs = available_requests(checked.model, {OutputKind::forward_dynamics});
  const bool is_solvable = !checked.model.approximation && !solved.scene.outputs.empty();
  const auto is_unsolved = [](const Field& row) { return row.entries.empty(); };
  if (!is_solvable || std::ranges::none_of(result->program.functions.back().fields, is_unsolved))
    return result;
  Result<Program> solution = solve_on_paper(lagrangian, solved, limits);
  if (!solution) return solution.diagnostics;
  result->solution = std::move(*solution);
  return result;
}

Result<PagePrograms> make_page_or_code(const Program& code,
                                       const std::function<PagePrograms()>& make) {
  try {
    return make();
  } catch (const std::bad_alloc&) {
    // E915 would change the forms on the page, so files would depend on the machine's memory.
    throw;
  } catch (const std::exception& mistake) {
    const std::string text = fmt::format("the page shows the forms of code: {}", mistake.what());
    return {PagePrograms{code, {}}, Diagnostics{Diagnostic{Code::E915, {}, text}}};
  }
}

Result<PagePrograms> make_page_programs(const Lagrangian& lagrangian, const ClosedForms& forms,
                                        const FormChoice& choice, const CheckedModel& checked,
                                        const Limits& limits) {
  if (!checked.scene.emission.has_page) return PagePrograms{};
  return make_page_or_code(choice.program, [&] {
    PagePrograms book{typeset_choice(forms, choice, checked), {}};
    const bool is_exact = !checked.model.approximation;
    if (!is_exact || !has_readable_terms(choice.program, forms)) return book;
    const bool has_rows = find_function(choice.program, OutputKind::bias) != nullptr ||
                          find_function(choice.program, OutputKind::inverse_dynamics) != nullptr;
    if (!has_rows && !has_short_row(lagrangian, checked, limits)) return book;
    book.steps = make_steps(lagrangian, checked, limits).value;
    return book;
  });
}

}  // namespace elgen
