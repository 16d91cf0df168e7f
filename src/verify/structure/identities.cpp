// The identities, each a balance of 64-digit values and derivatives. Notation: q, v, a, u, t; M, C,
// g, B; E = v.dL/dv - L; p = dL/dv; T, V0, V1, and A, gamma, lambda, f, r of constraints as in the
// table of outputs.
#include "verify/structure/identities.hpp"

#include <optional>
#include <utility>

#include "elgen/outputs.hpp"

namespace elgen {

void add_all(Balance& balance, const std::vector<Real>& terms, int factor) {
  for (std::size_t i = 0; i < terms.size(); ++i) balance.add(i, terms[i] * factor);
}

Arguments<Real> unit_position(const ExactValues& at, std::size_t i) {
  Arguments<Real> direction = at.at_rest();
  std::vector<Real> velocity(at.size());
  velocity[i] = Real(1);
  direction.q = at.coordinate_rates(velocity);
  return direction;
}

namespace {

using K = OutputKind;
using Values = std::vector<Real>;

/// balance_i += factor * sum_j matrix_ij x_j
void add_product(Balance& balance, const Values& matrix, const Values& x, int factor) {
  if (x.empty()) return;
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    balance.add(i / x.size(), matrix[i] * x[i % x.size()] * factor);
  }
}

Arguments<Real> unit_rate(const ExactValues& at, std::size_t i) {
  Arguments<Real> direction = at.at_rest();
  direction.v[i] = Real(1);
  return direction;
}

/// balance_i += factor * the derivative of an energy along each direction
void add_gradient(Balance& balance, const ExactValues& at, K energy,
                  Arguments<Real> (*direction)(const ExactValues&, std::size_t), int factor) {
  for (std::size_t i = 0; i < at.size(); ++i) {
    balance.add(i, at.slopes(energy, direction(at, i))[0] * factor);
  }
}

Values acceleration(ExactValues& at) {
  const Values& both = at.value(K::forward_dynamics);
  return {both.begin(), both.begin() + static_cast<std::ptrdiff_t>(at.size())};
}

/// B u, zero without inputs.
Values input_force(ExactValues& at) {
  Values force(at.size());
  const Values& u = at.arguments().u;
  if (u.empty()) return force;
  const Values& b = at.value(K::input_matrix);
  for (std::size_t i = 0; i < at.size(); ++i) {
    for (std::size_t k = 0; k < u.size(); ++k) force[i] = force[i] + b[i * u.size() + k] * u[k];
  }
  return force;
}

/// A^T lambda of forward dynamics, which the program has; zero without constraints.
Values held_force(ExactValues& at) {
  Values force(at.size());
  const Subject& subject = at.subject();
  if (subject.model.constraints.empty()) return force;
  const Function& function = *find_function(subject.program, K::forward_dynamics);
  const Values& solution = at.value(K::forward_dynamics);
  const Values& jacobian = at.value(K::constraint_jacobian);
  const std::size_t first = first_entry_of(function, "multipliers");
  for (std::size_t k = 0; k < jacobian.size(); ++k) {
    Real& sum = force[k % at.size()];
    sum = sum + jacobian[k] * solution[first + k / at.size()];
  }
  return force;
}

/// N = (sum_k dM/dq_k v_k) - 2 C, N + N^T = 0
Balance skew(ExactValues& at) {
  Arguments<Real> direction = at.at_rest();
  direction.q = at.coordinate_rates(at.arguments().v);
  const Values rate = at.slopes(K::mass_matrix, direction);
  const Values& c = at.value(K::coriolis_matrix);
  const std::size_t n = at.size();
  Balance balance(n * n);
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

/// -dL/dt = dE/dt - v.dp/dt, both at rest, since L = v.p - E
void add_explicit_time(Balance& balance, ExactValues& at) {
  if (!at.subject().model.uses_time) return;
  Arguments<Real> direction = at.at_rest();
  direction.t = Real(1);
  balance.add(0, -at.slopes(K::energy_function, direction)[0]);
  const Values p_rate = at.slopes(K::momentum, direction);
  for (std::size_t i = 0; i < at.size(); ++i) balance.add(0, at.arguments().v[i] * p_rate[i]);
}

/// dE/dt - v.(B u + Q - dD/dv + A^T lambda) + dL/dt
Balance power(ExactValues& at) {
  Arguments<Real> motion = at.at_rest();
  motion.q = at.coordinate_rates(at.arguments().v);
  motion.v = acceleration(at);
  motion.t = Real(1);
  Balance balance(1);
  balance.add(0, at.slopes(K::energy_function, motion)[0]);
  add_explicit_time(balance, at);
  const Values input = input_force(at);
  const Values held = held_force(at);
  const Values applied = at.value(K::applied_force);
  const Values dissipation = at.value(K::dissipation);
  for (std::size_t i = 0; i < at.size(); ++i) {
    const Real& v = at.arguments().v[i];
    balance.add(0, -(v * input[i]));
    balance.add(0, -(v * held[i]));
    balance.add(0, -(v * applied[i]));
    balance.add(0, v * dissipation[i]);
  }
  return balance;
}

Balance inverse_of_forward(ExactValues& at) {
  Arguments<Real> arguments = at.arguments();
  arguments.a = acceleration(at);
  Balance balance(at.size());
  add_all(balance, at.value_at(K::inverse_dynamics, arguments), 1);
  add_all(balance, input_force(at), -1);
  add_all(balance, held_force(at), -1);
  return balance;
}

Balance constrained_motion(ExactValues& at) {
  const Values& bias = at.value(K::constraint_bias);
  Balance balance(bias.size());
  add_product(balance, at.value(K::constraint_jacobian), acceleration(at), 1);
  add_all(balance, bias, 1);
  const Values& residual = at.value(K::constraint_residual);
  add_all(balance, stabilising_terms(at.subject().model, at.state(), residual), 1);
  return balance;
}

Balance momentum_gradient(ExactValues& at) {
  const std::size_t n = at.size();
  Balance balance(n * n);
  add_all(balance, at.value(K::mass_matrix), 1);
  for (std::size_t j = 0; j < n; ++j) {
    const Values column = at.slopes(K::momentum, unit_rate(at, j));
    for (std::size_t i = 0; i < n; ++i) balance.add(i * n + j, -column[i]);
  }
  return balance;
}

Balance energy_gradient(ExactValues& at) {
  Balance balance(at.size());
  add_product(balance, at.value(K::mass_matrix), at.arguments().v, 1);
  add_gradient(balance, at, K::energy_function, unit_rate, -1);
  return balance;
}

Balance momentum_from_energies(ExactValues& at) {
  Balance balance(at.size());
  add_all(balance, at.value(K::momentum), 1);
  add_gradient(balance, at, K::kinetic_energy, unit_rate, -2);
  add_gradient(balance, at, K::total_energy, unit_rate, 1);
  return balance;
}

Balance gravity_gradient(ExactValues& at) {
  Balance balance(at.size());
  add_all(balance, at.value(K::gravity), 1);
  add_gradient(balance, at, K::potential_energy, unit_position, -1);
  return balance;
}

Balance coriolis_product(ExactValues& at) {
  Balance balance(at.size());
  add_all(balance, at.value(K::velocity_force), 1);
  add_product(balance, at.value(K::coriolis_matrix), at.arguments().v, -1);
  return balance;
}

Balance bias_parts(ExactValues& at) {
  Balance balance(at.size());
  add_all(balance, at.value(K::bias), 1);
  for (const K part : {K::velocity_force, K::drift, K::gravity, K::dissipation}) {
    add_all(balance, at.value(part), -1);
  }
  add_all(balance, at.value(K::applied_force), 1);
  return balance;
}

Balance inverse_parts(ExactValues& at) {
  Balance balance(at.size());
  add_all(balance, at.value(K::inverse_dynamics), 1);
  add_product(balance, at.value(K::mass_matrix), at.arguments().a, -1);
  add_all(balance, at.value(K::bias), -1);
  return balance;
}

/// The state with the velocities that its momenta give; none where M is singular.
std::optional<ExactValues> at_momenta(ExactValues& at) {
  const OracleValues v = defined_values(at.value(K::velocities_of_momenta));
  if (!v) return std::nullopt;
  State state = at.state();
  state.v = *v;
  return ExactValues(at.subject(), std::move(state));
}

/// Of an entry without a value.
Balance undefined() {
  Balance balance(1);
  balance.add(0, Real::undefined());
  return balance;
}

Balance momenta_of_velocities(ExactValues& at) {
  std::optional<ExactValues> moving = at_momenta(at);
  if (!moving) return undefined();
  Balance balance(at.size());
  add_all(balance, moving->value(K::momentum), 1);
  add_all(balance, at.arguments().momenta, -1);
  return balance;
}

Balance hamiltonian_energy(ExactValues& at) {
  std::optional<ExactValues> moving = at_momenta(at);
  if (!moving) return undefined();
  Balance balance(1);
  add_all(balance, at.value(K::hamiltonian), 1);
  add_all(balance, moving->value(K::energy_function), -1);
  return balance;
}

/// d/dt (q, dL/dv) along the motion, less (dq/dt, dp/dt)
Balance canonical_motion(ExactValues& at) {
  std::optional<ExactValues> moving = at_momenta(at);
  if (!moving) return undefined();
  Arguments<Real> motion = moving->at_rest();
  motion.q = moving->coordinate_rates(moving->arguments().v);
  motion.v = acceleration(*moving);
  motion.t = Real(1);
  Values rates = motion.q;
  const Values of_momenta = moving->slopes(K::momentum, motion);
  rates.insert(rates.end(), of_momenta.begin(), of_momenta.end());
  Balance balance(rates.size());
  add_all(balance, at.value(K::hamilton_equations), 1);
  add_all(balance, rates, -1);
  return balance;
}

}  // namespace

const std::vector<Identity>& identities() {
  static const std::vector<Identity> table{
      {"rate of M less 2 C skew",
       "N = (sum_k dM/dq_k v_k) - 2 C, N + N^T = 0",
       {K::coriolis_matrix, K::mass_matrix},
       skew},
      {"power balance",
       "dE/dt = v.(B u + Q - dD/dv) - dL/dt",
       {K::energy_function, K::forward_dynamics, K::momentum},
       power,
       "dE/dt = v.(B u + Q - dD/dv + A^T lambda) - dL/dt"},
      {"inverse of forward dynamics",
       "tau(q, v, a(q, v, u)) = B u",
       {K::forward_dynamics, K::inverse_dynamics},
       inverse_of_forward,
       "tau(q, v, a(q, v, u)) = B u + A^T lambda"},
      {"constraints along the motion",
       "A a + gamma = -2 zeta omega r - omega^2 f",
       {K::forward_dynamics, K::constraint_residual, K::constraint_jacobian, K::constraint_bias},
       constrained_motion},
      {"momentum gradient", "dp/dv = M", {K::momentum, K::mass_matrix}, momentum_gradient},
      {"energy gradient", "dE/dv = M v", {K::energy_function, K::mass_matrix}, energy_gradient},
      {"momentum from energies",
       "p = 2 dT/dv - d(T + V)/dv",
       {K::momentum, K::kinetic_energy, K::total_energy},
       momentum_from_energies},
      {"gravity from potential", "g = dV0/dq", {K::gravity, K::potential_energy}, gravity_gradient},
      {"velocity force from C",
       "velocity_force = C v",
       {K::velocity_force, K::coriolis_matrix},
       coriolis_product},
      {"bias from parts",
       "bias = C v + drift + g + dD/dv - Q",
       {K::bias, K::velocity_force, K::drift, K::gravity},
       bias_parts},
      {"inverse dynamics from parts",
       "tau = M a + bias",
       {K::inverse_dynamics, K::mass_matrix, K::bias},
       inverse_parts},
      {"momenta of velocities",
       "dL/dv = p at v = M^-1 (p - b)",
       {K::velocities_of_momenta},
       momenta_of_velocities},
      {"Hamiltonian is the energy",
       "H = v.dL/dv - L at v = M^-1 (p - b)",
       {K::hamiltonian},
       hamiltonian_energy},
      {"Hamilton's equations along the motion",
       "(dq/dt, dp/dt) = d/dt (q, dL/dv)",
       {K::hamilton_equations, K::momentum},
       canonical_motion},
  };
  return table;
}

}  // namespace elgen
