// integrate: the models that a method accepts, the outputs that it calls, and the composed
// function.
#include "elgen/integrate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "elgen/compose.hpp"
#include "elgen/step_methods.hpp"
#include "model/requests.hpp"
#include "program/evaluate/subject.hpp"
#include "program/steps/methods.hpp"

namespace elgen {
namespace {

constexpr NextState (*step_composers[])(const StepContext&) = {
#define ELGEN_STEP_METHOD(name, domain, order, iterations, doc, equation) &compose_##name,
#include "elgen/step_methods.def"
#undef ELGEN_STEP_METHOD
};

/// The suffix of projected values is 5: rk4, the only method for models with constraints, has calls
/// 1 to 4.
constexpr std::uint32_t projected_suffix = 5;

StepDomain domain_of(const OutputRequest& step) {
  return step_method_row(step.step->method).domain;
}

void add_field(Function& function, std::string name, InstructionIndices entries) {
  if (entries.empty()) return;
  const auto rows = static_cast<std::uint32_t>(entries.size());
  function.fields.push_back({std::move(name), rows, 1, std::move(entries)});
}

/// The indices of all entries of `step`, if a called function has zeros found only by sampling;
/// otherwise none.
std::vector<std::uint32_t> sampled_zeros(const StepCallees& calls, const Function& step) {
  const auto has_sampled_zeros = [](const Program& program) {
    return std::ranges::any_of(program.functions,
                               [](const Function& f) { return !f.sampled_zeros.empty(); });
  };
  const bool is_sampled =
      has_sampled_zeros(calls.outputs) || has_sampled_zeros(calls.acceleration_parts);
  std::vector<std::uint32_t> entries(is_sampled ? entry_count(step) : 0);
  std::iota(entries.begin(), entries.end(), 0U);
  return entries;
}

/// True if an explicit method computes tangents from derivatives of accelerations. That needs fewer
/// instructions than differentiating the step, unless the model has rotations or the derivatives
/// are loops.
bool carries_tangents(const Model& model, const OutputRequest& step) {
  return output_row(step.kind).differentiates && domain_of(step) != StepDomain::quadratic &&
         model.rotations.empty() && model.velocities.size() < min_composed_velocities;
}

/// True if derivatives of the instructions of the step would be too long.
bool is_long_derivative(const Model& model, const OutputRequest& step) {
  return output_row(step.kind).differentiates && model.velocities.size() > max_unrolled_velocities;
}

/// True if an explicit method calls the parts of derivatives of accelerations at its stages.
bool calls_parts(const Model& model, const OutputRequest& step) {
  return is_long_derivative(model, step) && domain_of(step) != StepDomain::quadratic;
}

/// `function` with the fields A and B from the columns of `moved`, or if there are none, from the
/// derivatives of its open accelerations or of its instructions.
Function differentiate_step(const Model& model, const StepCallees& calls, Function function,
                            const NextState& moved, Program& program) {
  std::vector<InstructionIndices> columns = moved.columns;
  if (columns.empty()) {
    const bool is_open = !moved.stages.empty();
    const Function step = is_open ? function : eliminate_dead_code(function);
    function = is_open ? without_body(step) : step;
    Composition compose(program, function);
    columns = is_open ? stage_jacobian_columns(model, calls, step, moved.stages, compose)
                      : step_jacobian_columns(model, calls.outputs, step, compose);
  }
  function.fields.clear();
  std::size_t first = 0;
  for (const FieldRow& row : output_row(function.kind).fields) {
    Field field{std::string(row.name), extent_size(model, row.rows),
                extent_size(model, row.columns)};
    for (std::size_t i = 0; i < field.rows; ++i) {
      for (std::size_t j = 0; j < field.columns; ++j) {
        field.entries.push_back(columns[first + j][i]);
      }
    }
    first += field.columns;
    if (field.columns > 0) function.fields.push_back(std::move(field));
  }
  return eliminate_dead_code(function);
}

/// Outputs that are needed only to decide if the method applies.
std::vector<OutputKind> applicability_outputs(const OutputRequest& step) {
  if (domain_of(step) != StepDomain::separable) return {};
  return {OutputKind::mass_matrix, OutputKind::bias, OutputKind::momentum};
}

/// Outputs that the method calls if it applies. `dynamics` is one function, which computes all
/// outputs listed before `dynamics`.
std::vector<OutputKind> called_kinds(const OutputRequest& step) {
  switch (domain_of(step)) {
    case StepDomain::separable:
      return {OutputKind::forward_dynamics};
    case StepDomain::quadratic:
      return {OutputKind::mass_matrix, OutputKind::dissipation,       OutputKind::applied_force,
              OutputKind::momentum,    OutputKind::position_gradient, OutputKind::input_matrix,
              OutputKind::dynamics};
    case StepDomain::any:
      break;
  }
  return {OutputKind::forward_dynamics, OutputKind::coordinate_rates};
}

/// Projects `moved`, the state at the time t + h, onto the constraints.
void project_state(const StepContext& step, NextState& moved) {
  CallPoint at{
      .q = moved.q, .v = moved.v, .t = step.time_at_fraction(1), .number = projected_suffix};
  step.name_entries(at);
  const Function& projected = *find_function(step.callees, OutputKind::projected);
  moved.q = step.composition.inline_call(step.callees, projected, projected.fields[0], at);
  moved.v = step.composition.inline_call(step.callees, projected, projected.fields[1], at);
}

std::string inapplicable_reason(const CheckedModel& checked, const OutputRequest& step,
                                const Program& calls) {
  switch (domain_of(step)) {
    case StepDomain::separable:
      return nonseparable_reason(checked, calls);
    case StepDomain::quadratic:  // p is M v + b
      if (!checked.model.is_quadratic) return "L is not quadratic in the rates";
      if (is_long_derivative(checked.model, step)) {
        return fmt::format("derivatives of its steps support at most {} velocities, not {}",
                           max_unrolled_velocities, checked.model.velocities.size());
      }
      return {};
    case StepDomain::any:
      break;
  }
  return {};
}

/// "theta", "dot(x)" or "t": the first leaf of these kinds that the output contains; "" if it
/// contains no such leaf.
std::string first_leaf_read(const Program& program, OutputKind kind, LeafSet kinds) {
  const Function* const function = find_function(program, kind);
  if (function == nullptr) return {};
  for (const Instruction& instruction : function->instructions) {
    if (is_leaf(instruction.opcode) && kinds.has_any(instruction.opcode)) {
      return leaf_text(program.leaves, instruction.opcode, instruction.a);
    }
  }
  return {};
}

/// True if p contains more than M v; M must be constant.
bool has_linear_terms(const CheckedModel& checked, const Program& program) {
  constexpr OutputKind momentum = OutputKind::momentum;
  if (!first_leaf_read(program, momentum, Opcode::coordinate | Opcode::time).empty()) return true;
  const State resting = nominal_state(checked.model, checked.scene);
  const auto at_rest =
      evaluate(program, *find_function(program, momentum), arguments_at<double>(resting));
  return std::ranges::any_of(at_rest, [](double p) { return p != 0; });
}

}  // namespace

StepContext::StepContext(const CheckedModel& checked, const OutputRequest& request,
                         const StepCallees& the_calls, Composition& the_composition)
    : model(checked.model),
      callees(the_calls.outputs),
      composition(the_composition),
      has_float_accelerations(checked.scene.numerics.has_mixed_precision()),
      has_open_accelerations(calls_parts(model, request)),
      direction_count(
          carries_tangents(model, request) ? 2 * model.velocities.size() + model.inputs.size() : 0),
      iterations(request.step->iterations),
      parts(composition_coefficients(request.step->composed_order)),
      h(composition.add_leaf(Opcode::step)),
      start{composition.add_leaves(Opcode::coordinate, model.coordinates.size()),
            composition.add_leaves(Opcode::velocity, model.velocities.size()),
            model.uses_time ? composition.add_leaf(Opcode::time) : 0},
      half_step(composition.add(Opcode::multiply, composition.add_number(cln::cl_RA(1) / 2), h)) {}

std::uint32_t StepContext::time_after(std::uint32_t c) const {
  return model.uses_time ? composition.add(Opcode::add, start.t, c) : 0;
}

std::uint32_t StepContext::time_at_fraction(const cln::cl_RA& c) const {
  return model.uses_time ? time_after(step_multiple(c)) : 0;
}

std::uint32_t StepContext::step_multiple(const cln::cl_RA& c) const {
  if (c == 1) return h;
  return composition.add(Opcode::multiply, composition.add_number(c), h);
}

void StepContext::name_entries(const CallPoint& at) const {
  composition.set_name(at.q, Opcode::coordinate, at.number);
  composition.set_name(at.v, Opcode::velocity, at.number);
}

std::string nonseparable_reason(const CheckedModel& checked, const Program& program) {
  const std::string of_mass = first_leaf_read(program, OutputKind::mass_matrix,
                                              Opcode::coordinate | Opcode::time | Opcode::velocity);
  if (!of_mass.empty()) return fmt::format("M depends on `{}`", of_mass);
  if (has_linear_terms(checked, program)) return "L has terms linear in the rates";
  const std::string of_bias = first_leaf_read(program, OutputKind::bias, Opcode::velocity);
  return of_bias.empty() ? "" : fmt::format("a force depends on `{}`", of_bias);
}

std::vector<OutputRequest> outputs_for_step(const Model& model, const OutputRequest& step) {
  std::vector<OutputRequest> needed;
  const auto add = [&](OutputKind kind, const std::optional<Form>& form) {
    OutputRequest request = make_request(model, kind, 0);
    if (!is_available(model, request)) return;
    request.span = step.span;
    request.omits_pivots = output_row(kind).gives_pivots;
    request.form = form;
    needed.push_back(std::move(request));
  };
  for (const OutputKind kind : applicability_outputs(step)) add(kind, std::nullopt);
  for (const OutputKind kind : called_kinds(step)) {
    const bool is_part = output_row(kind).solves_mass_matrix && calls_parts(model, step);
    if (!is_part) add(kind, step.form);
  }
  if (carries_tangents(model, step)) add(OutputKind::forward_dynamics_derivatives, step.form);
  if (step.step->projects) add(OutputKind::projected, step.form);
  return needed;
}

std::vector<OutputRequest> parts_for_step(const Model& model, const OutputRequest& step) {
  if (!calls_parts(model, step)) return {};
  OutputRequest request = make_request(model, OutputKind::forward_dynamics_derivatives, 0);
  request.span = step.span;
  return {request};
}

Diagnostics add_step(const CheckedModel& checked, const OutputRequest& step,
                     const StepCallees& calls, Program& program) {
  const std::string reason = inapplicable_reason(checked, step, calls.outputs);
  if (!reason.empty()) {
    return {{Code::E622, step.span,
             fmt::format("`{}` does not apply to this system: {}",
                         step_method_row(step.step->method).name, reason),
             "`rk4` takes any model"}};
  }
  name_optional_leaves(Opcode::step, program.leaves);
  Function function{.kind = step.kind, .step = step.step, .name = step.name};
  Composition compose(program, function);
  const StepContext context(checked, step, calls, compose);
  NextState moved = step_composers[static_cast<std::size_t>(step.step->method)](context);
  if (step.step->projects) project_state(context, moved);
  add_field(function, "coordinates", std::move(moved.q));
  add_field(function, "rates", std::move(moved.v));
  if (output_row(step.kind).differentiates) {
    function = differentiate_step(checked.model, calls, std::move(function), moved, program);
  } else {
    add_field(function, "residual", std::move(moved.residual));
  }
  function.sampled_zeros = sampled_zeros(calls, function);
  program.functions.push_back(eliminate_dead_code(function));
  require_invariants(program);
  return {};
}

}  // namespace elgen
