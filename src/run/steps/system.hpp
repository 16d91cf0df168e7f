// SimulatedSystem: the functions of a model that integration needs, on flat arrays of numbers.
//
// A state is one list: q, then v, then the work W of inputs, forces, constraints and explicit time
// dependence:
//
//     dq/dt = N v,   M dv/dt = B u - bias + A^T lambda,   dW/dt = v.F - dL/dt,
//     F = B u + Q - dD/dv + A^T lambda,   dL/dt at constant q and v
//
// E - W is constant along the motion. W remains 0 if nothing does work; constraints do work only if
// they depend on time (moving constraints).
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "elgen/program.hpp"
#include "elgen/real.hpp"
#include "elgen/scene.hpp"
#include "elgen/simulate.hpp"
#include "elgen/toolchain.hpp"
#include "program/evaluate/conservation.hpp"
#include "program/evaluate/sines.hpp"
#include "run/steps/state_function.hpp"

namespace elgen {

using Numbers = std::vector<double>;

/// q, then v, of the model's start.
template <class Scalar = double>
[[nodiscard]] std::vector<Scalar> stated_start(const Model& model) {
  std::vector<Scalar> start;
  for (const Coordinate& coordinate : model.coordinates) {
    start.push_back(ScalarTraits<Scalar>::from_real(coordinate.start_value));
  }
  for (const Velocity& velocity : model.velocities) {
    start.push_back(ScalarTraits<Scalar>::from_real(velocity.start_rate));
  }
  return start;
}

/// True if constraints may do work: some f depends on t, or some phi does not vanish at v = 0.
[[nodiscard]] bool has_moving_constraints(const Model& model);

/// T and V; if only L is known, v.p and -L.
struct EnergyParts {
  double kinetic = 0;
  double potential = 0;

  [[nodiscard]] double magnitude() const { return std::abs(kinetic) + std::abs(potential); }
};

/// The law of an input, and the limits to which its values are clamped.
struct InputLaw {
  std::optional<ExpressionId> expression = {};  ///< none: the input is 0
  std::optional<StateFunction> function = {};   ///< evaluates `expression`
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
};

class SimulatedSystem {
 public:
  /// Calls the functions of `compiled`; evaluates the program if `compiled` is null or lacks a
  /// function. If `projects`, project_state() also projects states onto the constraints.
  SimulatedSystem(const CheckedModel& checked, const Program& program,
                  const CompiledModel* compiled, bool projects = true);
  SimulatedSystem(const SimulatedSystem&) = delete;
  SimulatedSystem& operator=(const SimulatedSystem&) = delete;

  /// Calls the functions of `compiled` from now on.
  void use_compiled(const CompiledModel& compiled);
  /// The number of instructions that the interpreter has computed.
  [[nodiscard]] std::size_t interpreted_instructions() const { return interpreted_; }

  [[nodiscard]] const Model& model() const { return model_; }
  /// One element per input, including inputs without a law.
  [[nodiscard]] const std::vector<InputLaw>& laws() const { return laws_; }
  [[nodiscard]] const LeafNames& leaves() const { return program_.leaves; }
  [[nodiscard]] std::size_t position_count() const { return model_.coordinates.size(); }
  [[nodiscard]] std::size_t velocity_count() const { return model_.velocities.size(); }

  /// The first element of v in a state.
  [[nodiscard]] double* v_of(Numbers& state) const { return state.data() + position_count(); }
  [[nodiscard]] const double* v_of(const Numbers& state) const {
    return state.data() + position_count();
  }
  [[nodiscard]] static double& work_of(Numbers& state) { return state.back(); }
  /// The first 8 numbers of q and v: "theta = 1, dot(theta) = 2".
  [[nodiscard]] std::string state_text(const Numbers& state) const;

  /// The start of the model with normalised quaternions, and work 0.
  [[nodiscard]] Numbers start_state();

  /// Sets the inputs to the laws at this state, and keeps these values until the next call.
  void hold_inputs(const double* q, const double* v, double t);
  [[nodiscard]] bool holds_inputs() const { return holds_inputs_; }
  /// The held inputs; if none are held, the laws at wrapped angles, clamped to the limits of the
  /// input; 0 for an input without a law.
  [[nodiscard]] const Numbers& update_inputs(const double* q, const double* v, double t);
  /// q as rows show it: angles with `wraps` in (-pi, pi].
  [[nodiscard]] const Numbers& displayed_position(const double* q);

  /// The value of an expression of the model in q, v and t.
  [[nodiscard]] double value(ExpressionId expression, const double* q, const double* v,
                             double t) const {
    return state_function(expression)(q, v, t);
  }
  [[nodiscard]] StateFunction state_function(ExpressionId expression) const {
    return {model_, expression, arguments_};
  }

  /// The result of the program's `step` of length h: q, v, and the residual of an implicit method.
  /// The inputs are constant during the step: the held inputs, or the laws at `state`.
  [[nodiscard]] const Numbers& step_result(const Numbers& state, double t, double h);

  void find_acceleration(const double* q, const double* v, double t, double* a);
  /// D_i / M_ii of M = L D L^T, then the relative pivots of A M^-1 A^T, all from the last
  /// evaluation of forward dynamics.
  [[nodiscard]] std::span<const double> relative_pivots() const {
    return {solution_.data() + first_pivot_, velocity_count() + model_.constraints.size()};
  }
  /// lambda, by constraint, for `inputs`.
  [[nodiscard]] std::span<const double> multipliers(const double* q, const double* v, double t,
                                                    const Numbers& inputs);
  void find_coordinate_rates(const double* q, const double* v, double* rates);
  /// d(q, v, W)/dt.
  void find_rates(const Numbers& state, Numbers& rates, double t);
  /// B u + Q - dD/dv.
  [[nodiscard]] const Numbers& generalized_force(const double* q, const double* v, double t);
  /// dW/dt = v.F - dL/dt.
  [[nodiscard]] double power(const double* q, const double* v, double t);
  /// power(), but with the inputs of the last update_inputs().
  [[nodiscard]] double power_at_last_inputs(const double* q, const double* v, double t);
  /// M, n x n, row-major.
  [[nodiscard]] const Numbers& mass_matrix(const double* q, const double* v, double t);
  /// A, m x n, row-major.
  [[nodiscard]] const Numbers& constraint_jacobian(const double* q, const double* v, double t);
  void find_momentum(const double* q, const double* v, double t, double* result);
  /// sum_j |M_ij v_j| by i: the scale of p_i, without terms of L linear in v.
  [[nodiscard]] const Numbers& momentum_scales(const double* q, const double* v, double t);
  [[nodiscard]] double energy(const double* q, const double* v, double t);
  /// The entries of the `conserved` expectations of the model; none for an expansion.
  [[nodiscard]] const std::vector<ConservedDrift>& conserved_quantities() const {
    return conserved_;
  }
  [[nodiscard]] const Numbers& conserved_values(const double* q, const double* v, double t);
  /// True if T and V are known separately.
  [[nodiscard]] bool has_separate_energies() const {
    return function(OutputKind::kinetic_energy) != nullptr;
  }
  [[nodiscard]] EnergyParts energy_parts(const double* q, const double* v, double t);
  /// The largest violations of the constraints and of their rates.
  [[nodiscard]] ConstraintViolation constraint_offset(const double* q, const double* v, double t);
  /// True if steps may violate constraints, or change the norm of quaternions.
  [[nodiscard]] bool needs_projection() const { return function(projection_output_) != nullptr; }
  /// Normalises quaternions; if the constructor's `projects` is set, also projects onto the
  /// constraints by one Newton step.
  void project_state(Numbers& state, double t);

  /// True if E may change: forces, constraints or explicit time dependence do work.
  [[nodiscard]] bool does_work() const {
    return conservation_.is_forced || conservation_.has_time || has_moving_constraints_;
  }
  /// The velocities with conserved momentum.
  [[nodiscard]] const std::vector<std::uint32_t>& cyclic_velocities() const {
    return conservation_.momenta;
  }

 private:
  /// `function` is null if the program lacks the output; `code` is null if no code is compiled.
  struct Callee {
    const Function* function = nullptr;
    DriverFunction<double> code = nullptr;
  };

  void add_conserved(const Expectation& expectation);
  [[nodiscard]] std::vector<Callee> callees(const CompiledModel* compiled) const;
  [[nodiscard]] const Function* function(OutputKind kind) const {
    return callees_[static_cast<std::size_t>(kind)].function;
  }
  void call_output(OutputKind kind, const double* q, const double* v, double t, double* result);
  /// Sets `force_` to Q - dD/dv.
  void find_passive_force(const double* q, const double* v, double t);
  void add_input_force(const double* q, const double* v, double t);
  void add_constraint_force(const double* q, const double* v, double t);
  [[nodiscard]] double explicit_power(const double* q, const double* v, double t) const;

  const Model& model_;
  const Program& program_;
  const SineEvaluator<double> sines_;
  /// The arguments of all calls. u has the last inputs; a, p and E are set only by
  /// conserved_values().
  Arguments<double> arguments_;
  std::vector<InputLaw> laws_;
  std::vector<Callee> callees_;  ///< indexed by OutputKind
  std::size_t interpreted_ = 0;
  OutputKind projection_output_;  ///< `projected` or `normalized`, which project_state() calls
  bool holds_inputs_ = false;
  bool is_driven_ = false;
  bool has_moving_constraints_ = false;
  Conservation conservation_ = {};
  std::vector<ConservedDrift> conserved_ = {};
  std::vector<StateFunction> conserved_functions_ = {};
  Numbers conserved_values_ = {};
  std::size_t first_acceleration_ = 0;  ///< index of the first acceleration in `solution_`
  std::size_t first_pivot_ = 0;
  std::size_t first_multiplier_ = 0;
  Numbers shown_, solution_, moved_, residual_, jacobian_, force_, more_force_, matrix_, mass_,
      scales_;
};

}  // namespace elgen
