// SimulatedSystem: calls functions on flat arrays of numbers, and computes the work.
#include "run/steps/system.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "check/expressions/traits.hpp"
#include "elgen/references.hpp"
#include "elgen/wording.hpp"
#include "program/evaluate/subject.hpp"

namespace elgen {
namespace {

/// The law and limits of each input. Limits are infinite if the model declares none, or if the law
/// is constant along a run.
std::vector<InputLaw> make_input_laws(const CheckedModel& checked, const Arguments<double>& at) {
  const Model& model = checked.model;
  std::vector<InputLaw> laws(model.inputs.size());
  for (std::size_t k = 0; k < laws.size(); ++k) {
    const Input& input = model.inputs[k];
    if (const ExpressionId* const law = find_law(checked.scene, input)) {
      laws[k].expression = *law;
      laws[k].function.emplace(model, *law, at);
    }
    if (!input.limits || (laws[k].expression && is_constant_along_run(model, *laws[k].expression)))
      continue;
    laws[k].low = to_double(input.limits->low);
    laws[k].high = to_double(input.limits->high);
  }
  return laws;
}

/// The number of entries of a result; 0 if the program lacks the function.
std::size_t result_size(const Function* function) {
  return function == nullptr ? 0 : entry_count(*function);
}

constexpr std::size_t max_shown_numbers = 8;

/// `angle` plus a multiple of 2 pi, in (-pi, pi].
double wrap_angle(double angle) {
  const double turn = 2 * std::numbers::pi;
  const double rest = std::remainder(angle, turn);
  return rest <= -std::numbers::pi ? rest + turn : rest;
}

}  // namespace

bool has_moving_constraints(const Model& model) {
  if (model.constraints.empty()) return false;
  const std::vector<ExpressionTraits> traits = find_traits(model);
  return std::ranges::any_of(model.constraints, [&traits](const Constraint& constraint) {
    const ExpressionTraits& of = traits[constraint.value];
    const bool is_left_at_rest = !constraint.is_position && of.lowest_rate_degree == 0;
    return is_left_at_rest || (of.ingredients & uses_time) != 0;
  });
}

SimulatedSystem::SimulatedSystem(const CheckedModel& checked, const Program& program,
                                 const CompiledModel* compiled, bool projects)
    : model_(checked.model),
      program_(program),
      sines_(checked.scene, SineArithmetic::numbers),
      arguments_(arguments_at<double>(nominal_state(checked.model, checked.scene))),
      laws_(make_input_laws(checked, arguments_)),
      callees_(callees(compiled)),
      projection_output_(projects && !model_.constraints.empty() ? OutputKind::projected
                                                                 : OutputKind::normalized),
      first_acceleration_(first_entry_of(*function(OutputKind::forward_dynamics), "acceleration")),
      first_pivot_(first_entry_of(*function(OutputKind::forward_dynamics), "relative_pivots")),
      first_multiplier_(first_entry_of(*function(OutputKind::forward_dynamics), "multipliers")),
      shown_(position_count()),
      solution_(result_size(function(OutputKind::forward_dynamics))),
      moved_(result_size(function(OutputKind::step))),
      residual_(result_size(function(OutputKind::constraint_residual))),
      jacobian_(result_size(function(OutputKind::constraint_jacobian))),
      force_(velocity_count()),
      more_force_(velocity_count()),
      matrix_(velocity_count() * model_.inputs.size()),
      mass_(velocity_count() * velocity_count()),
      scales_(velocity_count()) {
  is_driven_ = !checked.scene.laws.empty();
  conservation_ = find_conservation(model_, program_, is_driven_, false);
  has_moving_constraints_ = has_moving_constraints(model_);
  for (const Expectation& expectation : model_.expectations) add_conserved(expectation);
}

/// Adds the entries of a `conserved` expectation, unless an expansion makes the entries inexact.
void SimulatedSystem::add_conserved(const Expectation& expectation) {
  if (!expectation.claims_conservation() || model_.approximation) return;
  for (std::size_t i = 0; i < expectation.entries.size(); ++i) {
    const ExpressionId id = expectation.entries[i];
    const auto unit = i < expectation.units.size() ? expectation.units[i] : std::nullopt;
    const bool has_unit = unit && *unit != Unit{};
    conserved_.push_back({collapse_blanks(covered_text(model_.expressions[id].span)),
                          has_unit ? to_string(*unit) : "", 0, 0});
    conserved_functions_.emplace_back(model_, id, arguments_);
  }
  conserved_values_.resize(conserved_.size());
}

void SimulatedSystem::use_compiled(const CompiledModel& compiled) { callees_ = callees(&compiled); }

std::vector<SimulatedSystem::Callee> SimulatedSystem::callees(const CompiledModel* compiled) const {
  std::vector<Callee> all;
  for (const OutputRow& row : output_table()) {
    const auto found = std::ranges::find(program_.functions, row.kind, &Function::kind);
    Callee& callee = all.emplace_back();
    if (found == program_.functions.end()) continue;
    callee = {&*found, compiled == nullptr ? nullptr : compiled->find(found->name)};
  }
  return all;
}

std::string SimulatedSystem::state_text(const Numbers& state) const {
  std::vector<std::string> parts;
  const auto add = [&](Opcode kind, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      parts.push_back(fmt::format("{} = {:.6g}",
                                  leaf_text(leaves(), kind, static_cast<std::uint32_t>(i)),
                                  state[parts.size()]));
    }
  };
  add(Opcode::coordinate, position_count());
  add(Opcode::velocity, velocity_count());
  const bool is_long = parts.size() > max_shown_numbers;
  parts.resize(std::min(parts.size(), max_shown_numbers));
  return fmt::format("{}{}", fmt::join(parts, ", "), is_long ? ", …" : "");
}

Numbers SimulatedSystem::start_state() {
  Numbers state = stated_start(model_);
  state.push_back(0);
  if (function(OutputKind::normalized) != nullptr) {
    call_output(OutputKind::normalized, state.data(), v_of(state), 0, state.data());
  }
  return state;
}

void SimulatedSystem::hold_inputs(const double* q, const double* v, double t) {
  holds_inputs_ = false;
  (void)update_inputs(q, v, t);
  holds_inputs_ = true;
}

const Numbers& SimulatedSystem::update_inputs(const double* q, const double* v, double t) {
  if (holds_inputs_ || !is_driven_) return arguments_.u;
  const Numbers& seen = displayed_position(q);
  for (std::size_t k = 0; k < laws_.size(); ++k) {
    auto& [law, function, low, high] = laws_[k];
    if (!function) continue;
    const double value = (*function)(seen.data(), v, t);
    // Both comparisons with a NaN are false, so a NaN remains a NaN.
    arguments_.u[k] = value < low ? low : value > high ? high : value;
  }
  return arguments_.u;
}

const Numbers& SimulatedSystem::displayed_position(const double* q) {
  for (std::size_t i = 0; i < shown_.size(); ++i) {
    shown_[i] = model_.coordinates[i].wraps ? wrap_angle(q[i]) : q[i];
  }
  return shown_;
}

void SimulatedSystem::call_output(OutputKind kind, const double* q, const double* v, double t,
                                  double* result) {
  const Callee& called = callees_[static_cast<std::size_t>(kind)];
  if (called.code != nullptr) {
    ArgumentPointers<double> arguments = argument_pointers(arguments_);
    arguments.q = q;
    arguments.v = v;
    arguments.t = t;
    call_compiled_function(called.code, arguments, result);
    return;
  }
  std::copy_n(q, position_count(), arguments_.q.begin());
  std::copy_n(v, velocity_count(), arguments_.v.begin());
  arguments_.t = t;
  interpreted_ += called.function->instructions.size();
  std::ranges::copy(evaluate_as_emitted(program_, *called.function, arguments_, sines_), result);
}

const Numbers& SimulatedSystem::step_result(const Numbers& state, double t, double h) {
  (void)update_inputs(state.data(), v_of(state), t);
  arguments_.h = h;
  call_output(OutputKind::step, state.data(), v_of(state), t, moved_.data());
  return moved_;
}

void SimulatedSystem::find_acceleration(const double* q, const double* v, double t, double* a) {
  (void)update_inputs(q, v, t);
  call_output(OutputKind::forward_dynamics, q, v, t, solution_.data());
  std::copy_n(solution_.data() + first_acceleration_, velocity_count(), a);
}

std::span<const double> SimulatedSystem::multipliers(const double* q, const double* v, double t,
                                                     const Numbers& inputs) {
  if (model_.constraints.empty()) return {};
  arguments_.u = inputs;
  call_output(OutputKind::forward_dynamics, q, v, t, solution_.data());
  return {solution_.data() + first_multiplier_, model_.constraints.size()};
}

void SimulatedSystem::find_coordinate_rates(const double* q, const double* v, double* rates) {
  if (function(OutputKind::coordinate_rates) == nullptr) {
    std::copy_n(v, velocity_count(), rates);
  } else {
    call_output(OutputKind::coordinate_rates, q, v, 0, rates);
  }
}

void SimulatedSystem::find_passive_force(const double* q, const double* v, double t) {
  call_output(OutputKind::applied_force, q, v, t, force_.data());
  call_output(OutputKind::dissipation, q, v, t, more_force_.data());
  for (std::size_t i = 0; i < velocity_count(); ++i) force_[i] -= more_force_[i];
}

void SimulatedSystem::add_input_force(const double* q, const double* v, double t) {
  if (function(OutputKind::input_matrix) == nullptr) return;
  call_output(OutputKind::input_matrix, q, v, t, matrix_.data());
  const Numbers& u = arguments_.u;
  for (std::size_t i = 0; i < velocity_count(); ++i) {
    for (std::size_t k = 0; k < u.size(); ++k) force_[i] += matrix_[i * u.size() + k] * u[k];
  }
}

/// Adds A^T lambda to `force_`, with the inputs of the last update_inputs().
void SimulatedSystem::add_constraint_force(const double* q, const double* v, double t) {
  const std::size_t n = velocity_count();
  call_output(OutputKind::forward_dynamics, q, v, t, solution_.data());
  (void)constraint_jacobian(q, v, t);
  for (std::size_t k = 0; k < jacobian_.size(); ++k) {
    force_[k % n] += jacobian_[k] * solution_[first_multiplier_ + k / n];
  }
}

void SimulatedSystem::find_rates(const Numbers& state, Numbers& rates, double t) {
  const double* const q = state.data();
  const double* const v = v_of(state);
  find_coordinate_rates(q, v, rates.data());
  find_acceleration(q, v, t, v_of(rates));
  work_of(rates) = power(q, v, t);
}

const Numbers& SimulatedSystem::generalized_force(const double* q, const double* v, double t) {
  (void)update_inputs(q, v, t);
  find_passive_force(q, v, t);
  add_input_force(q, v, t);
  return force_;
}

double SimulatedSystem::power(const double* q, const double* v, double t) {
  if (does_work()) (void)update_inputs(q, v, t);
  return power_at_last_inputs(q, v, t);
}

double SimulatedSystem::power_at_last_inputs(const double* q, const double* v, double t) {
  double sum = conservation_.has_time ? explicit_power(q, v, t) : 0;
  if (!conservation_.is_forced && !has_moving_constraints_) return sum;
  find_passive_force(q, v, t);
  if (has_moving_constraints_) add_constraint_force(q, v, t);
  add_input_force(q, v, t);
  for (std::size_t i = 0; i < velocity_count(); ++i) sum += v[i] * force_[i];
  return sum;
}

/// -dL/dt = dE/dt - v.dp/dt at constant q and v, because L = v.p - E. No output has this value, so
/// the program is evaluated with dual numbers in t.
double SimulatedSystem::explicit_power(const double* q, const double* v, double t) const {
  Arguments<Dual<double>> at = map_leaves([](double x) { return Dual<double>{x, 0}; }, arguments_);
  for (std::size_t i = 0; i < position_count(); ++i) at.q[i].value = q[i];
  for (std::size_t i = 0; i < velocity_count(); ++i) at.v[i].value = v[i];
  at.t = {t, 1};
  const auto slopes = [&](OutputKind kind) {
    return evaluate(program_, *find_function(program_, kind), at);
  };
  double result = slopes(OutputKind::energy_function).front().slope;
  const std::vector<Dual<double>> momentum = slopes(OutputKind::momentum);
  for (std::size_t i = 0; i < velocity_count(); ++i) result -= v[i] * momentum[i].slope;
  return result;
}

const Numbers& SimulatedSystem::mass_matrix(const double* q, const double* v, double t) {
  call_output(OutputKind::mass_matrix, q, v, t, mass_.data());
  return mass_;
}

const Numbers& SimulatedSystem::constraint_jacobian(const double* q, const double* v, double t) {
  if (!jacobian_.empty()) call_output(OutputKind::constraint_jacobian, q, v, t, jacobian_.data());
  return jacobian_;
}

void SimulatedSystem::find_momentum(const double* q, const double* v, double t, double* result) {
  call_output(OutputKind::momentum, q, v, t, result);
}

const Numbers& SimulatedSystem::momentum_scales(const double* q, const double* v, double t) {
  const std::size_t n = velocity_count();
  (void)mass_matrix(q, v, t);
  for (std::size_t i = 0; i < n; ++i) {
    scales_[i] = 0;
    for (std::size_t j = 0; j < n; ++j) scales_[i] += std::abs(mass_[i * n + j] * v[j]);
  }
  return scales_;
}

const Numbers& SimulatedSystem::conserved_values(const double* q, const double* v, double t) {
  if (conserved_.empty()) return conserved_values_;
  find_acceleration(q, v, t, arguments_.a.data());
  find_momentum(q, v, t, arguments_.momenta.data());
  arguments_.E = energy(q, v, t);
  for (std::size_t i = 0; i < conserved_.size(); ++i) {
    conserved_values_[i] = conserved_functions_[i](q, v, t);
  }
  return conserved_values_;
}

double SimulatedSystem::energy(const double* q, const double* v, double t) {
  double result = 0;
  call_output(OutputKind::energy_function, q, v, t, &result);
  return result;
}

EnergyParts SimulatedSystem::energy_parts(const double* q, const double* v, double t) {
  double whole = 0;
  double part = 0;
  if (has_separate_energies()) {
    call_output(OutputKind::total_energy, q, v, t, &whole);
    call_output(OutputKind::kinetic_energy, q, v, t, &part);
  } else {
    whole = energy(q, v, t);
    find_momentum(q, v, t, force_.data());
    for (std::size_t i = 0; i < velocity_count(); ++i) part += v[i] * force_[i];
  }
  return {part, whole - part};
}

ConstraintViolation SimulatedSystem::constraint_offset(const double* q, const double* v, double t) {
  ConstraintViolation result;
  if (residual_.empty()) return result;
  call_output(OutputKind::constraint_residual, q, v, t, residual_.data());
  const std::size_t first_rate = first_entry_of(*function(OutputKind::constraint_residual), "rate");
  for (std::size_t i = 0; i < residual_.size(); ++i) {
    double& largest = i < first_rate ? result.position : result.rate;
    largest = std::max(largest, std::abs(residual_[i]));
  }
  return result;
}

void SimulatedSystem::project_state(Numbers& state, double t) {
  call_output(projection_output_, state.data(), v_of(state), t, state.data());
}

}  // namespace elgen
