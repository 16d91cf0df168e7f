// The identities, each a balance of values and derivatives in 64 digits. q, v, a, u, t, M, C, g, B,
// T, V0, V1 and A, gamma, lambda, f, r of constraints as in the table of outputs; E = v.dL/dv - L,
// p = dL/dv.
#include "verify/structure/identities.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "elgen/outputs.hpp"

namespace elgen {

ResidualSums balance_of(const std::vector<BalanceTerms>& all) {
  ResidualSums balance(all.front().values.size() / all.front().terms_per_entry);
  for (const BalanceTerms& terms : all) {
    for (std::size_t i = 0; i < terms.values.size(); ++i) {
      balance.add(i / terms.terms_per_entry, terms.values[i] * terms.factor);
    }
  }
  return balance;
}

Arguments<Real> unit_displacement(const ExactValues& at, std::size_t i) {
  Arguments<Real> direction = at.zero_direction();
  std::vector<Real> velocity(at.size());
  velocity[i] = Real(1);
  direction.q = at.coordinate_rates(velocity);
  return direction;
}

namespace {

using K = OutputKind;
using Values = std::vector<Real>;

/// The terms of factor * sum_j matrix_ij x_j.
BalanceTerms matrix_vector_terms(const Values& matrix, const Values& x, int factor = 1) {
  BalanceTerms terms{matrix, factor, std::max<std::size_t>(x.size(), 1)};
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    terms.values[i] = matrix[i] * x[i % x.size()];
  }
  return terms;
}

Arguments<Real> unit_velocity_direction(const ExactValues& at, std::size_t i) {
  Arguments<Real> direction = at.zero_direction();
  direction.v[i] = Real(1);
  return direction;
}

/// The derivatives of `energy` along direction(at, i), for each velocity i.
Values energy_slopes(const ExactValues& at, K energy,
                     Arguments<Real> (*direction)(const ExactValues&, std::size_t)) {
  Values slopes;
  for (std::size_t i = 0; i < at.size(); ++i) {
    slopes.push_back(at.directional_derivatives(energy, direction(at, i))[0]);
  }
  return slopes;
}

Values acceleration(ExactValues& at) {
  const Values& both = at.entries(K::forward_dynamics);
  return {both.begin(), both.begin() + static_cast<std::ptrdiff_t>(at.size())};
}

/// B u; zero if the model has no inputs.
Values input_force(ExactValues& at) {
  Values force(at.size());
  const Values& u = at.arguments().u;
  if (u.empty()) return force;
  const Values& b = at.entries(K::input_matrix);
  for (std::size_t i = 0; i < at.size(); ++i) {
    for (std::size_t k = 0; k < u.size(); ++k) force[i] = force[i] + b[i * u.size() + k] * u[k];
  }
  return force;
}

/// A^T lambda, lambda from the program's forward dynamics; zero without constraints.
Values constraint_force(ExactValues& at) {
  Values force(at.size());
  const SystemUnderTest& subject = at.subject();
  if (subject.model.constraints.empty()) return force;
  const Function& function = *find_function(subject.program, K::forward_dynamics);
  const Values& solution = at.entries(K::forward_dynamics);
  const Values& jacobian = at.entries(K::constraint_jacobian);
  const std::size_t first = first_entry_of(function, "multipliers");
  for (std::size_t k = 0; k < jacobian.size(); ++k) {
    Real& sum = force[k % at.size()];
    sum = sum + jacobian[k] * solution[first + k / at.size()];
  }
  return force;
}

/// N + N^T = 0 with N = (sum_k dM/dq_k v_k) - 2 C.
ResidualSums skew_balance(ExactValues& at) {
  Arguments<Real> direction = at.zero_direction();
  direction.q = at.coordinate_rates(at.arguments().v);
  const Values rate = at.directional_derivatives(K::mass_matrix, direction);
  const Values& c = at.entries(K::coriolis_matrix);
  const std::size_t n = at.size();
  ResidualSums balance(n * n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      for (const std::size_t entry : {i * n + j, j * n + i}) {
        balance.add(i * n + j, rate[entry]);
        balance.add(i * n + j, c[entry] * -2);
      }
    }
  }
  return balance;
}

/// dE/dt - v.(B u + Q - dD/dv + A^T lambda) + dL/dt, with the partial derivative
/// dL/dt = v.dp/dt - dE/dt, because L = v.p - E.
ResidualSums power_balance(ExactValues& at) {
  Arguments<Real> motion = at.zero_direction();
  motion.q = at.coordinate_rates(at.arguments().v);
  motion.v = acceleration(at);
  motion.t = Real(1);
  const Values& v = at.arguments().v;
  std::vector<BalanceTerms> terms{{at.directional_derivatives(K::energy_function, motion)},
                                  matrix_vector_terms(input_force(at), v, -1),
                                  matrix_vector_terms(constraint_force(at), v, -1),
                                  matrix_vector_terms(at.entries(K::applied_force), v, -1),
                                  matrix_vector_terms(at.entries(K::dissipation), v)};
  if (!at.subject().model.uses_time) return balance_of(terms);
  Arguments<Real> direction = at.zero_direction();
  direction.t = Real(1);
  terms.push_back({at.directional_derivatives(K::energy_function, direction), -1});
  terms.push_back(matrix_vector_terms(at.directional_derivatives(K::momentum, direction), v));
  return balance_of(terms);
}

ResidualSums inverse_dynamics_balance(ExactValues& at) {
  Arguments<Real> arguments = at.arguments();
  arguments.a = acceleration(at);
  return balance_of({{at.entries_at(K::inverse_dynamics, arguments)},
                     {input_force(at), -1},
                     {constraint_force(at), -1}});
}

ResidualSums constraint_balance(ExactValues& at) {
  const Values& residual = at.entries(K::constraint_residual);
  return balance_of({{at.entries(K::constraint_bias)},
                     matrix_vector_terms(at.entries(K::constraint_jacobian), acceleration(at)),
                     {stabilising_terms(at.subject().model, at.state(), residual)}});
}

ResidualSums momentum_gradient_balance(ExactValues& at) {
  const std::size_t n = at.size();
  Values slopes(n * n);
  for (std::size_t j = 0; j < n; ++j) {
    const Values column = at.directional_derivatives(K::momentum, unit_velocity_direction(at, j));
    for (std::size_t i = 0; i < n; ++i) slopes[i * n + j] = column[i];
  }
  return balance_of({{at.entries(K::mass_matrix)}, {slopes, -1}});
}

ResidualSums energy_gradient_balance(ExactValues& at) {
  return balance_of({matrix_vector_terms(at.entries(K::mass_matrix), at.arguments().v),
                     {energy_slopes(at, K::energy_function, unit_velocity_direction), -1}});
}

ResidualSums energy_momentum_balance(ExactValues& at) {
  return balance_of({{at.entries(K::momentum)},
                     {energy_slopes(at, K::kinetic_energy, unit_velocity_direction), -2},
                     {energy_slopes(at, K::total_energy, unit_velocity_direction)}});
}

ResidualSums gravity_balance(ExactValues& at) {
  return balance_of(
      {{at.entries(K::gravity)}, {energy_slopes(at, K::potential_energy, unit_displacement), -1}});
}

ResidualSums coriolis_balance(ExactValues& at) {
  return balance_of({{at.entries(K::velocity_force)},
                     matrix_vector_terms(at.entries(K::coriolis_matrix), at.arguments().v, -1)});
}

ResidualSums bias_balance(ExactValues& at) {
  return balance_of({{at.entries(K::bias)},
                     {at.entries(K::velocity_force), -1},
                     {at.entries(K::drift), -1},
                     {at.entries(K::gravity), -1},
                     {at.entries(K::dissipation), -1},
                     {at.entries(K::applied_force)}});
}

ResidualSums dynamics_parts_balance(ExactValues& at) {
  return balance_of({{at.entries(K::inverse_dynamics)},
                     matrix_vector_terms(at.entries(K::mass_matrix), at.arguments().a, -1),
                     {at.entries(K::bias), -1}});
}

ResidualSums regressor_balance(ExactValues& at) {
  const Values& both = at.entries(K::regressor);
  const Values& parameters = at.entries(K::regressor_parameters);
  const auto rest = both.end() - static_cast<std::ptrdiff_t>(at.size());
  return balance_of({{at.entries(K::inverse_dynamics)},
                     matrix_vector_terms({both.begin(), rest}, parameters, -1),
                     {{rest, both.end()}, -1}});
}

ResidualSums reference_regressor_balance(ExactValues& at) {
  Arguments<Real> arguments = at.arguments();
  arguments.reference = arguments.v;
  return balance_of(
      {{at.entries_at(K::regressor_reference, arguments)}, {at.entries(K::regressor), -1}});
}

/// The state whose velocities belong to the momenta of `at`; none if M is singular.
std::optional<ExactValues> solve_momentum_velocities(ExactValues& at) {
  const OracleValues v = to_oracle_values(at.entries(K::velocities_of_momenta));
  if (!v) return std::nullopt;
  State state = at.state();
  state.v = *v;
  return ExactValues(at.subject(), std::move(state));
}

/// A balance of one undefined entry.
ResidualSums undefined_balance() { return balance_of({BalanceTerms{{Real::undefined()}}}); }

ResidualSums momenta_balance(ExactValues& at) {
  std::optional<ExactValues> moving = solve_momentum_velocities(at);
  if (!moving) return undefined_balance();
  return balance_of({{moving->entries(K::momentum)}, {at.arguments().momenta, -1}});
}

ResidualSums hamiltonian_balance(ExactValues& at) {
  std::optional<ExactValues> moving = solve_momentum_velocities(at);
  if (!moving) return undefined_balance();
  return balance_of({{at.entries(K::hamiltonian)}, {moving->entries(K::energy_function), -1}});
}

/// d/dt (q, dL/dv) along the motion, minus (dq/dt, dp/dt).
ResidualSums canonical_motion_balance(ExactValues& at) {
  std::optional<ExactValues> moving = solve_momentum_velocities(at);
  if (!moving) return undefined_balance();
  Arguments<Real> motion = moving->zero_direction();
  motion.q = moving->coordinate_rates(moving->arguments().v);
  motion.v = acceleration(*moving);
  motion.t = Real(1);
  Values rates = motion.q;
  const Values of_momenta = moving->directional_derivatives(K::momentum, motion);
  rates.insert(rates.end(), of_momenta.begin(), of_momenta.end());
  return balance_of({{at.entries(K::hamilton_equations)}, {rates, -1}});
}

std::vector<Identity> identities_of_equations() {
  return {
      {"rate of M less 2 C skew",
       "N = (sum_k dM/dq_k v_k) - 2 C, N + N^T = 0",
       {K::coriolis_matrix, K::mass_matrix},
       skew_balance},
      {"power balance",
       "dE/dt = v.(B u + Q - dD/dv) - dL/dt",
       {K::energy_function, K::forward_dynamics, K::momentum},
       power_balance,
       "dE/dt = v.(B u + Q - dD/dv + A^T lambda) - dL/dt"},
      {"inverse of forward dynamics",
       "tau(q, v, a(q, v, u)) = B u",
       {K::forward_dynamics, K::inverse_dynamics},
       inverse_dynamics_balance,
       "tau(q, v, a(q, v, u)) = B u + A^T lambda"},
      {"constraints along the motion",
       "A a + gamma = -2 zeta omega r - omega^2 f",
       {K::forward_dynamics, K::constraint_residual, K::constraint_jacobian, K::constraint_bias},
       constraint_balance},
      {"momentum gradient", "dp/dv = M", {K::momentum, K::mass_matrix}, momentum_gradient_balance},
      {"energy gradient",
       "dE/dv = M v",
       {K::energy_function, K::mass_matrix},
       energy_gradient_balance},
      {"momentum from energies",
       "p = 2 dT/dv - d(T + V)/dv",
       {K::momentum, K::kinetic_energy, K::total_energy},
       energy_momentum_balance},
      {"gravity from potential", "g = dV0/dq", {K::gravity, K::potential_energy}, gravity_balance},
      {"velocity force from C",
       "velocity_force = C v",
       {K::velocity_force, K::coriolis_matrix},
       coriolis_balance},
      {"bias from parts",
       "bias = C v + drift + g + dD/dv - Q",
       {K::bias, K::velocity_force, K::drift, K::gravity},
       bias_balance},
      {"inverse dynamics from parts",
       "tau = M a + bias",
       {K::inverse_dynamics, K::mass_matrix, K::bias},
       dynamics_parts_balance},
  };
}

std::vector<Identity> identities_of_momenta_and_regressors() {
  return {
      {"inverse dynamics from the regressor",
       "tau = Y pi + rest",
       {K::regressor},
       regressor_balance},
      {"regressor of the velocity itself",
       "Y_r(q, v, v, a) = Y(q, v, a)",
       {K::regressor_reference},
       reference_regressor_balance},
      {"momenta of velocities",
       "dL/dv = p at v = M^-1 (p - b)",
       {K::velocities_of_momenta},
       momenta_balance},
      {"Hamiltonian is the energy",
       "H = v.dL/dv - L at v = M^-1 (p - b)",
       {K::hamiltonian},
       hamiltonian_balance},
      {"Hamilton's equations along the motion",
       "(dq/dt, dp/dt) = d/dt (q, dL/dv)",
       {K::hamilton_equations, K::momentum},
       canonical_motion_balance},
  };
}

}  // namespace

const std::vector<Identity>& identities() {
  static const std::vector<Identity> table = [] {
    std::vector<Identity> all = identities_of_equations();
    const std::vector<Identity> others = identities_of_momenta_and_regressors();
    all.insert(all.end(), others.begin(), others.end());
    return all;
  }();
  return table;
}

}  // namespace elgen
