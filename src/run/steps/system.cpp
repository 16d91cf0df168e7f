// System: calls functions on flat arrays of numbers, and computes the work.
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
std::vector<InputLaw> laws_of(const CheckedModel& checked, const Arguments<double>& at) {
  const Model& model = checked.model;
  std::vector<InputLaw> laws(model.inputs.size());
  for (std::size_t k = 0; k < laws.size(); ++k) {
    const Input& input = model.inputs[k];
    if (const ExpressionId* const law = find_law(checked.scene, input)) {
      laws[k].value = *law;
      laws[k].function.emplace(model, *law, at);
    }
    if (!input.limits || (laws[k].value && is_one_number(model, *laws[k].value))) continue;
    laws[k].low = to_double(input.limits->low);
    laws[k].high = to_double(input.limits->high);
  }
  return laws;
}

/// The number of entries of a result; 0 if the program lacks the function.
std::size_t result_size(const Function* function) {
  return function == nullptr ? 0 : entry_count(*function);
}

constexpr std::size_t most_shown = 8;

/// The angle in (-pi, pi].
double wrapped(double angle) {
  const double turn = 2 * std::numbers::pi;
  const double rest = std::remainder(angle, turn);
  return rest <= -std::numbers::pi ? rest + turn : rest;
}

}  // namespace

bool is_one_number(const Model& model, ExpressionId law) {
  return !contains_leaf(model, law, Opcode::coordinate | Opcode::velocity | Opcode::time);
}

bool has_moving_constraints(const Model& model) {
  if (model.constraints.empty()) return false;
  const std::vector<Traits> traits = find_traits(model);
  return std::ranges::any_of(model.constraints, [&traits](const Constraint& constraint) {
    const Traits& of = traits[constraint.value];
    const bool is_left_at_rest = !constraint.is_position && of.lowest_rate_degree == 0;
    return is_left_at_rest || (of.ingredients & uses_time) != 0;
  });
}

System::System(const CheckedModel& checked, const Program& program, const CompiledModel* compiled,
               bool projects)
    : model_(checked.model),
      program_(program),
      compiled_(compiled),
      sines_(checked.scene, SineArithmetic::numbers),
      at_(arguments_at<double>(nominal_state(checked.model, checked.scene))),
      laws_(laws_of(checked, at_)),
      callees_(callees()),
      restoring_output_(projects && !model_.constraints.empty() ? OutputKind::projected
                                                                : OutputKind::normalized),
      first_acceleration_(first_entry_of(*function(OutputKind::forward_dynamics), "acceleration")),
      first_pivot_(first_entry_of(*function(OutputKind::forward_dynamics), "relative_pivots")),
      first_multiplier_(first_entry_of(*function(OutputKind::forward_dynamics), "multipliers")),
      shown_(positions()),
      solution_(result_size(function(OutputKind::forward_dynamics))),
      moved_(result_size(function(OutputKind::step))),
      residual_(result_size(function(OutputKind::constraint_residual))),
      jacobian_(result_size(function(OutputKind::constraint_jacobian))),
      force_(velocities()),
      more_force_(velocities()),
      matrix_(velocities() * model_.inputs.size()),
      mass_(velocities() * velocities()),
      scales_(velocities()) {
  is_driven_ = !checked.scene.laws.empty();
  conservation_ = find_conservation(model_, program_, is_driven_, false);
  has_moving_constraints_ = has_moving_constraints(model_);
  for (const Expectation& expectation : model_.expectations) add_conserved(expectation);
}

/// Adds `conserved` entries; none for an expansion, because they hold for the exact model only.
void System::add_conserved(const Expectation& expectation) {
  if (!expectation.is_conserved() || model_.approximation) return;
  for (std::size_t i = 0; i < expectation.entries.size(); ++i) {
    const ExpressionId id = expectation.entries[i];
    const auto unit = i < expectation.units.size() ? expectation.units[i] : std::nullopt;
    const bool has_unit = unit && *unit != Unit{};
    conserved_.push_back({one_line(covered_text(model_.expressions[id].span)),
                          has_unit ? to_string(*unit) : "", 0, 0});
    conserved_functions_.emplace_back(model_, id, at_);
  }
  conserved_values_.resize(conserved_.size());
}

std::vector<System::Callee> System::callees() const {
  std::vector<Callee> all;
  for (const OutputRow& row : output_table()) {
    const auto found = std::ranges::find(program_.functions, row.kind, &Function::kind);
    Callee& callee = all.emplace_back();
    if (found == program_.functions.end()) continue;
    callee = {&*found, compiled_ == nullptr ? nullptr : compiled_->find(found->name)};
  }
  return all;
}

std::string System::state_text(const Numbers& state) const {
  std::vector<std::string> parts;
  const auto add = [&](Opcode kind, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      parts.push_back(fmt::format("{} = {:.6g}",
                                  leaf_text(leaves(), kind, static_cast<std::uint32_t>(i)),
                                  state[parts.size()]));
    }
  };
  add(Opcode::coordinate, positions());
  add(Opcode::velocity, velocities());
  const bool is_long = parts.size() > most_shown;
  parts.resize(std::min(parts.size(), most_shown));
  return fmt::format("{}{}", fmt::join(parts, ", "), is_long ? ", …" : "");
}

Numbers System::start() {
  Numbers state = stated_start(model_);
  state.push_back(0);
  if (function(OutputKind::normalized) != nullptr) {
    call(OutputKind::normalized, state.data(), v_of(state), 0, state.data());
  }
  return state;
}

void System::hold(const double* q, const double* v, double t) {
  is_held_ = false;
  (void)inputs(q, v, t);
  is_held_ = true;
}

const Numbers& System::inputs(const double* q, const double* v, double t) {
  if (is_held_ || !is_driven_) return at_.u;
  const Numbers& seen = displayed_position(q);
  for (std::size_t k = 0; k < laws_.size(); ++k) {
    auto& [law, function, low, high] = laws_[k];
    if (!function) continue;
    const double value = (*function)(seen.data(), v, t);
    // Both comparisons with a NaN are false, so a NaN remains a NaN.
    at_.u[k] = value < low ? low : value > high ? high : value;
  }
  return at_.u;
}

const Numbers& System::displayed_position(const double* q) {
  for (std::size_t i = 0; i < shown_.size(); ++i) {
    shown_[i] = model_.coordinates[i].wrap ? wrapped(q[i]) : q[i];
  }
  return shown_;
}

void System::call(OutputKind kind, const double* q, const double* v, double t, double* result) {
  const Callee& called = callees_[static_cast<std::size_t>(kind)];
  if (called.code != nullptr) {
    ArgumentPointers<double> arguments = argument_pointers(at_);
    arguments.q = q;
    arguments.v = v;
    arguments.t = t;
    call_code(called.code, arguments, result);
    return;
  }
  std::copy_n(q, positions(), at_.q.begin());
  std::copy_n(v, velocities(), at_.v.begin());
  at_.t = t;
  std::ranges::copy(evaluate_code(program_, *called.function, at_, sines_), result);
}

const Numbers& System::step_result(const Numbers& state, double t, double h) {
  (void)inputs(state.data(), v_of(state), t);
  at_.h = h;
  call(OutputKind::step, state.data(), v_of(state), t, moved_.data());
  return moved_;
}

void System::acceleration(const double* q, const double* v, double t, double* a) {
  (void)inputs(q, v, t);
  call(OutputKind::forward_dynamics, q, v, t, solution_.data());
  std::copy_n(solution_.data() + first_acceleration_, velocities(), a);
}

std::span<const double> System::multipliers(const double* q, const double* v, double t,
                                            const Numbers& inputs) {
  if (model_.constraints.empty()) return {};
  at_.u = inputs;
  call(OutputKind::forward_dynamics, q, v, t, solution_.data());
  return {solution_.data() + first_multiplier_, model_.constraints.size()};
}

void System::coordinate_rates(const double* q, const double* v, double* rates) {
  if (function(OutputKind::coordinate_rates) == nullptr) {
    std::copy_n(v, velocities(), rates);
  } else {
    call(OutputKind::coordinate_rates, q, v, 0, rates);
  }
}

void System::find_passive_force(const double* q, const double* v, double t) {
  call(OutputKind::applied_force, q, v, t, force_.data());
  call(OutputKind::dissipation, q, v, t, more_force_.data());
  for (std::size_t i = 0; i < velocities(); ++i) force_[i] -= more_force_[i];
}

void System::add_input_force(const double* q, const double* v, double t) {
  if (function(OutputKind::input_matrix) == nullptr) return;
  call(OutputKind::input_matrix, q, v, t, matrix_.data());
  const Numbers& u = at_.u;
  for (std::size_t i = 0; i < velocities(); ++i) {
    for (std::size_t k = 0; k < u.size(); ++k) force_[i] += matrix_[i * u.size() + k] * u[k];
  }
}

/// Adds A^T lambda to `force_`, with the inputs of the last inputs().
void System::add_constraint_force(const double* q, const double* v, double t) {
  const std::size_t n = velocities();
  call(OutputKind::forward_dynamics, q, v, t, solution_.data());
  (void)constraint_jacobian(q, v, t);
  for (std::size_t k = 0; k < jacobian_.size(); ++k) {
    force_[k % n] += jacobian_[k] * solution_[first_multiplier_ + k / n];
  }
}

void System::find_rates(const Numbers& state, Numbers& rates, double t) {
  const double* const q = state.data();
  const double* const v = v_of(state);
  coordinate_rates(q, v, rates.data());
  acceleration(q, v, t, v_of(rates));
  work_of(rates) = power(q, v, t);
}

const Numbers& System::applied_force(const double* q, const double* v, double t) {
  (void)inputs(q, v, t);
  find_passive_force(q, v, t);
  add_input_force(q, v, t);
  return force_;
}

double System::power(const double* q, const double* v, double t) {
  if (does_work()) (void)inputs(q, v, t);
  return power_at_last_inputs(q, v, t);
}

double System::power_at_last_inputs(const double* q, const double* v, double t) {
  double sum = conservation_.has_time ? explicit_power(q, v, t) : 0;
  if (!conservation_.is_forced && !has_moving_constraints_) return sum;
  find_passive_force(q, v, t);
  if (has_moving_constraints_) add_constraint_force(q, v, t);
  add_input_force(q, v, t);
  for (std::size_t i = 0; i < velocities(); ++i) sum += v[i] * force_[i];
  return sum;
}

/// -dL/dt = dE/dt - v.dp/dt at constant q and v, because L = v.p - E. No output has this value, so
/// the program is evaluated with dual numbers in t.
double System::explicit_power(const double* q, const double* v, double t) const {
  Arguments<Dual<double>> at = map_leaves([](double x) { return Dual<double>{x, 0}; }, at_);
  for (std::size_t i = 0; i < positions(); ++i) at.q[i].value = q[i];
  for (std::size_t i = 0; i < velocities(); ++i) at.v[i].value = v[i];
  at.t = {t, 1};
  const auto slopes = [&](OutputKind kind) {
    return evaluate(program_, *find_function(program_, kind), at);
  };
  double result = slopes(OutputKind::energy_function).front().slope;
  const std::vector<Dual<double>> momentum = slopes(OutputKind::momentum);
  for (std::size_t i = 0; i < velocities(); ++i) result -= v[i] * momentum[i].slope;
  return result;
}

const Numbers& System::mass_matrix(const double* q, const double* v, double t) {
  call(OutputKind::mass_matrix, q, v, t, mass_.data());
  return mass_;
}

const Numbers& System::constraint_jacobian(const double* q, const double* v, double t) {
  if (!jacobian_.empty()) call(OutputKind::constraint_jacobian, q, v, t, jacobian_.data());
  return jacobian_;
}

void System::momentum(const double* q, const double* v, double t, double* result) {
  call(OutputKind::momentum, q, v, t, result);
}

const Numbers& System::momentum_scales(const double* q, const double* v, double t) {
  const std::size_t n = velocities();
  (void)mass_matrix(q, v, t);
  for (std::size_t i = 0; i < n; ++i) {
    scales_[i] = 0;
    for (std::size_t j = 0; j < n; ++j) scales_[i] += std::abs(mass_[i * n + j] * v[j]);
  }
  return scales_;
}

const Numbers& System::conserved_values(const double* q, const double* v, double t) {
  if (conserved_.empty()) return conserved_values_;
  acceleration(q, v, t, at_.a.data());
  momentum(q, v, t, at_.momenta.data());
  at_.E = energy(q, v, t);
  for (std::size_t i = 0; i < conserved_.size(); ++i) {
    conserved_values_[i] = conserved_functions_[i](q, v, t);
  }
  return conserved_values_;
}

double System::energy(const double* q, const double* v, double t) {
  double result = 0;
  call(OutputKind::energy_function, q, v, t, &result);
  return result;
}

EnergyParts System::energy_parts(const double* q, const double* v, double t) {
  double whole = 0;
  double part = 0;
  if (has_energies()) {
    call(OutputKind::total_energy, q, v, t, &whole);
    call(OutputKind::kinetic_energy, q, v, t, &part);
  } else {
    whole = energy(q, v, t);
    momentum(q, v, t, force_.data());
    for (std::size_t i = 0; i < velocities(); ++i) part += v[i] * force_[i];
  }
  return {part, whole - part};
}

ConstraintOffset System::offset(const double* q, const double* v, double t) {
  ConstraintOffset result;
  if (residual_.empty()) return result;
  call(OutputKind::constraint_residual, q, v, t, residual_.data());
  const std::size_t first_rate = first_entry_of(*function(OutputKind::constraint_residual), "rate");
  for (std::size_t i = 0; i < residual_.size(); ++i) {
    double& largest = i < first_rate ? result.position : result.rate;
    largest = std::max(largest, std::abs(residual_[i]));
  }
  return result;
}

void System::restore(Numbers& state, double t) {
  call(restoring_output_, state.data(), v_of(state), t, state.data());
}

}  // namespace elgen
