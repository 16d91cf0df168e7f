// The identities, each a balance of 64-digit values and derivatives. Notation: q, v, a, u, t; M, C,
// g, B; E = v.dL/dv - L; p = dL/dv; T, V0, V1 as in the table of outputs.
#include "verify/structure/identities.hpp"

#include "elgen/outputs.hpp"

namespace elgen {
namespace {

using K = OutputKind;
using Values = std::vector<Real>;

/// balance_i += factor * terms_i
void add_all(Balance& balance, const Values& terms, int factor) {
  for (std::size_t i = 0; i < terms.size(); ++i) balance.add(i, terms[i] * factor);
}

/// balance_i += factor * sum_j matrix_ij x_j
void add_product(Balance& balance, const Values& matrix, const Values& x, int factor) {
  if (x.empty()) return;
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    balance.add(i / x.size(), matrix[i] * x[i % x.size()] * factor);
  }
}

/// A unit displacement along velocity i.
Arguments<Real> unit_position(const ExactValues& at, std::size_t i) {
  Arguments<Real> direction = at.at_rest();
  std::vector<Real> velocity(at.size());
  velocity[i] = Real(1);
  direction.q = at.coordinate_rates(velocity);
  return direction;
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

/// dE/dt - v.(B u + Q - dD/dv) + dL/dt
Balance power(ExactValues& at) {
  Arguments<Real> motion = at.at_rest();
  motion.q = at.coordinate_rates(at.arguments().v);
  motion.v = acceleration(at);
  motion.t = Real(1);
  Balance balance(1);
  balance.add(0, at.slopes(K::energy_function, motion)[0]);
  add_explicit_time(balance, at);
  const Values input = input_force(at);
  const Values applied = at.value(K::applied_force);
  const Values dissipation = at.value(K::dissipation);
  for (std::size_t i = 0; i < at.size(); ++i) {
    const Real& v = at.arguments().v[i];
    balance.add(0, -(v * input[i]));
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
       power},
      {"inverse of forward dynamics",
       "tau(q, v, a(q, v, u)) = B u",
       {K::forward_dynamics, K::inverse_dynamics},
       inverse_of_forward},
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
  };
  return table;
}

namespace {

// The pose [R p] of a frame's output gives its twist (angular velocity; velocity of the origin) as
// a form linear in the pose and in its rate, so that its rate is that form twice:
//
//     in the world's axes    S = dR/dt R^T    v = dp/dt
//     in the frame's         S = R^T dR/dt    v = R^T dp/dt        omega = (S_32, S_13, S_21)

/// Where the six components of a twist stand in a balance: at first, first + stride, …
struct TwistPlace {
  Balance& balance;
  std::size_t first = 0;
  std::size_t stride = 1;
  bool in_world = true;
};

/// A pose, 3 x 4 row by row, with its rate and its second rate.
struct PoseMotion {
  std::vector<Real> pose = {};
  std::vector<Real> rate = {};
  std::vector<Real> second_rate = {};
};

constexpr std::size_t axes = 3;
constexpr std::size_t columns = 4;  ///< of [R p]

const Real& entry(const Values& pose, std::size_t row, std::size_t column) {
  return pose[columns * row + column];
}

/// S_32, S_13, S_21
void subtract_spin(const TwistPlace& place, const Values& pose, const Values& rate) {
  for (std::size_t axis = 0; axis < axes; ++axis) {
    const std::size_t j = (axis + 1) % axes;
    const std::size_t i = (axis + 2) % axes;
    for (std::size_t k = 0; k < axes; ++k) {
      const Real term = place.in_world ? entry(rate, i, k) * entry(pose, j, k)
                                       : entry(pose, k, i) * entry(rate, k, j);
      place.balance.add(place.first + axis * place.stride, -term);
    }
  }
}

/// Components of dp/dt along the columns of `along`.
void subtract_velocity(const TwistPlace& place, const Values& along, const Values& rate) {
  for (std::size_t axis = 0; axis < axes; ++axis) {
    for (std::size_t k = 0; k < axes; ++k) {
      const Real term = entry(along, k, axis) * entry(rate, k, axes);
      place.balance.add(place.first + (axes + axis) * place.stride, -term);
    }
  }
}

/// The world's own axes.
Values identity() {
  Values pose(axes * columns);
  for (std::size_t i = 0; i < axes; ++i) pose[columns * i + i] = Real(1);
  return pose;
}

/// balance -= twist
void subtract_twist(const TwistPlace& place, const PoseMotion& motion) {
  subtract_spin(place, motion.pose, motion.rate);
  subtract_velocity(place, place.in_world ? identity() : motion.pose, motion.rate);
}

/// balance -= d twist/dt
void subtract_twist_rate(const TwistPlace& place, const PoseMotion& motion) {
  subtract_spin(place, motion.pose, motion.second_rate);
  subtract_spin(place, motion.rate, motion.rate);
  subtract_velocity(place, place.in_world ? identity() : motion.pose, motion.second_rate);
  if (!place.in_world) subtract_velocity(place, motion.rate, motion.rate);
}

/// d^2 y/dt^2 at a = 0 along a motion.
Values second_rate(ExactValues& at, const Arguments<Real>& motion, std::uint32_t user) {
  Values result = at.curvatures(K::user_value, motion, user);
  if (at.subject().model.rotations.empty()) return result;
  Arguments<Real> turning = at.at_rest();
  turning.q = at.coasting_accelerations();
  const Values of_turning = at.slopes(K::user_value, turning, user);
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = result[i] + of_turning[i];
  return result;
}

Balance jacobian_balance(ExactValues& at, std::uint32_t user) {
  const UserOutput& output = at.subject().model.outputs[user];
  const Values& jacobian = at.value(K::user_jacobian, user);
  const std::size_t n = at.size();
  Balance balance(jacobian.size());
  add_all(balance, jacobian, 1);
  for (std::size_t j = 0; j < n; ++j) {
    const Values column = at.slopes(K::user_value, unit_position(at, j), user);
    if (output.frame) {
      subtract_twist({balance, j, n, output.in_world}, {at.value(K::user_value, user), column});
      continue;
    }
    for (std::size_t i = 0; i < column.size(); ++i) balance.add(i * n + j, -column[i]);
  }
  return balance;
}

Balance output_bias_balance(ExactValues& at, std::uint32_t user) {
  const UserOutput& output = at.subject().model.outputs[user];
  Arguments<Real> motion = at.at_rest();
  motion.q = at.coordinate_rates(at.arguments().v);
  motion.t = Real(1);
  const Values& bias = at.value(K::user_bias, user);
  Balance balance(bias.size());
  add_all(balance, bias, 1);
  if (output.frame) {
    const PoseMotion pose{at.value(K::user_value, user), at.slopes(K::user_value, motion, user),
                          second_rate(at, motion, user)};
    subtract_twist_rate({balance, 0, 1, output.in_world}, pose);
  } else {
    add_all(balance, second_rate(at, motion, user), -1);
  }
  return balance;
}

}  // namespace

const std::vector<OutputIdentity>& output_identities() {
  static const std::vector<OutputIdentity> table{
      {K::user_jacobian, "Jacobian by dual numbers", "J = dy/dq",
       "J = d(omega; dp/dt)/dv, [omega]x = dR/dt R^T", jacobian_balance},
      {K::user_bias, "output bias by dual numbers", "bias = d^2 y/dt^2 at a = 0",
       "bias = d(omega; dp/dt)/dt at a = 0", output_bias_balance},
  };
  return table;
}

}  // namespace elgen
