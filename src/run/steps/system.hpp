// System: what steps in time ask of a model, by its functions, on flat numbers.
//
// A state lies in one list: q, then v, then the work that forces and time have done, with
//
//     dq/dt = N v,   M dv/dt = B u - bias + A^T lambda,   dW/dt = v.F - dL/dt,
//     F = B u + Q - dD/dv + A^T lambda
//
// so that E - W is constant along the motion. W stays 0 where nothing does work; constraints do
// some where they move by themselves.
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

/// q and v of a model's own start.
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

/// Whether a law is one number along a run, and so is not cut off at limits.
[[nodiscard]] bool is_one_number(const Model& model, ExpressionId law);

/// Whether a constraint does work, by f_t or by what of phi is left at rest.
[[nodiscard]] bool has_moving_constraints(const Model& model);

/// T and V; v.p and -L if only L is known.
struct EnergyParts {
  double kinetic = 0;
  double potential = 0;

  [[nodiscard]] double magnitude() const { return std::abs(kinetic) + std::abs(potential); }
};

/// The law of an input, and the limits at which it is cut off.
struct InputLaw {
  std::optional<ExpressionId> value = {};      ///< none: the input is constant
  std::optional<StateFunction> function = {};  ///< computes `value`, if there is one
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
};

class System {
 public:
  /// Functions run as they were compiled; where `compiled` is null, in the evaluator. `projects`:
  /// states are put back onto constraints.
  System(const CheckedModel& checked, const Program& program, const CompiledModel* compiled,
         bool projects = true);
  System(const System&) = delete;
  System& operator=(const System&) = delete;

  [[nodiscard]] const Model& model() const { return model_; }
  /// By input, also of inputs without a law.
  [[nodiscard]] const std::vector<InputLaw>& laws() const { return laws_; }
  [[nodiscard]] const LeafNames& leaves() const { return program_.leaves; }
  [[nodiscard]] std::size_t positions() const { return model_.coordinates.size(); }
  [[nodiscard]] std::size_t velocities() const { return model_.velocities.size(); }

  /// Where the parts of a list begin.
  [[nodiscard]] double* v_of(Numbers& state) const { return state.data() + positions(); }
  [[nodiscard]] const double* v_of(const Numbers& state) const {
    return state.data() + positions();
  }
  [[nodiscard]] static double& work_of(Numbers& state) { return state.back(); }
  /// "theta = 1, dot(theta) = 2", of the first few q and v.
  [[nodiscard]] std::string text_of(const Numbers& state) const;

  /// The model's own start, quaternions scaled to length 1.
  [[nodiscard]] Numbers start();

  /// Inputs keep what their laws are here, until held again.
  void hold(const double* q, const double* v, double t);
  [[nodiscard]] bool holds_inputs() const { return is_held_; }
  /// By the laws, which see the angles that are shown, inside `limits`; 0 where there is no law.
  [[nodiscard]] const Numbers& inputs(const double* q, const double* v, double t);
  /// q as rows show it: an angle with `wrap` in (-pi, pi].
  [[nodiscard]] const Numbers& shown(const double* q);

  /// The value of an expression of the model in q, v and t.
  [[nodiscard]] double value(ExpressionId expression, const double* q, const double* v,
                             double t) const {
    return state_function(expression)(q, v, t);
  }
  [[nodiscard]] StateFunction state_function(ExpressionId expression) const {
    return {model_, expression, at_};
  }

  /// The result of the program's `step` of length h from a state, with its inputs there: q, v, and
  /// the residual of an implicit method.
  [[nodiscard]] const Numbers& stepped(const Numbers& state, double t, double h);

  void acceleration(const double* q, const double* v, double t, double* a);
  /// D_i / M_ii of M = L D L^T, then those of A M^-1 A^T, as the acceleration was last made.
  [[nodiscard]] std::span<const double> relative_pivots() const {
    return {solution_.data() + first_pivot_, velocities() + model_.constraints.size()};
  }
  /// lambda of every constraint at these inputs.
  [[nodiscard]] std::span<const double> multipliers(const double* q, const double* v, double t,
                                                    const Numbers& inputs);
  void coordinate_rates(const double* q, const double* v, double* rates);
  /// d(q, v, W)/dt
  void find_rates(const Numbers& state, Numbers& rates, double t);
  /// B u + Q - dD/dv
  [[nodiscard]] const Numbers& applied_force(const double* q, const double* v, double t);
  /// v.F - dL/dt; 0 where no work is done.
  [[nodiscard]] double power(const double* q, const double* v, double t);
  /// The same with the inputs that were last asked for.
  [[nodiscard]] double held_power(const double* q, const double* v, double t);
  /// n x n, row-major.
  [[nodiscard]] const Numbers& mass_matrix(const double* q, const double* v, double t);
  /// A, m x n, row-major.
  [[nodiscard]] const Numbers& constraint_jacobian(const double* q, const double* v, double t);
  void momentum(const double* q, const double* v, double t, double* result);
  /// sum_j |M_ij v_j| of every i: what p_i is the sum of, but for what is linear in v.
  [[nodiscard]] const Numbers& momentum_scales(const double* q, const double* v, double t);
  [[nodiscard]] double energy(const double* q, const double* v, double t);
  /// The entries of the model's `conserved`, and their values at a state.
  [[nodiscard]] const std::vector<ConservedDrift>& conserved() const { return conserved_; }
  [[nodiscard]] const Numbers& conserved_values(const double* q, const double* v, double t);
  /// Whether T and V are known apart.
  [[nodiscard]] bool has_energies() const {
    return function(OutputKind::kinetic_energy) != nullptr;
  }
  [[nodiscard]] EnergyParts energy_parts(const double* q, const double* v, double t);
  /// How far a state is off the constraints.
  [[nodiscard]] ConstraintOffset offset(const double* q, const double* v, double t);
  /// Whether a step may change lengths of quaternions, or leave the constraints.
  [[nodiscard]] bool is_restored() const { return function(restored_) != nullptr; }
  /// Quaternions to length 1, and by one step of Newton back onto the constraints.
  void restore(Numbers& state, double t);

  /// Whether forces, time or constraints do work.
  [[nodiscard]] bool does_work() const {
    return conservation_.is_forced || conservation_.has_time || has_moving_constraints_;
  }
  /// The coordinates' velocities whose momentum nothing changes.
  [[nodiscard]] const std::vector<std::uint32_t>& cyclic() const { return conservation_.momenta; }

 private:
  /// Null where the program has none; without code where it was not compiled.
  struct Callee {
    const Function* function = nullptr;
    DriverFunction<double> code = nullptr;
  };

  void add_conserved(const Expectation& expectation);
  [[nodiscard]] std::vector<Callee> callees() const;
  [[nodiscard]] const Function* function(OutputKind kind) const {
    return callees_[static_cast<std::size_t>(kind)].function;
  }
  void call(OutputKind kind, const double* q, const double* v, double t, double* result);
  /// F to `force_`, without inputs.
  void find_passive_force(const double* q, const double* v, double t);
  void add_input_force(const double* q, const double* v, double t);
  void add_constraint_force(const double* q, const double* v, double t);
  [[nodiscard]] double explicit_power(const double* q, const double* v, double t) const;

  const Model& model_;
  const Program& program_;
  const CompiledModel* compiled_;
  const Sines<double> sines_;
  /// Arguments of a call; inputs are the last ones, and a, p, E belong to conserved quantities.
  Arguments<double> at_;
  std::vector<InputLaw> laws_;
  std::vector<Callee> callees_;  ///< by kind
  OutputKind restored_;          ///< puts a state back
  bool is_held_ = false;
  bool is_driven_ = false;
  bool has_moving_constraints_ = false;
  Conservation conservation_ = {};
  std::vector<ConservedDrift> conserved_ = {};
  std::vector<StateFunction> conserved_functions_ = {};
  Numbers conserved_values_ = {};
  std::size_t first_acceleration_ = 0;  ///< in `solution_`
  std::size_t first_pivot_ = 0;
  std::size_t first_multiplier_ = 0;
  Numbers shown_, solution_, moved_, residual_, jacobian_, force_, more_force_, matrix_, mass_,
      scales_;
};

}  // namespace elgen
