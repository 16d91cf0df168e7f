// Output values: one row per output, with functions for its entries and its contraction. Reactions
// are computed in the model without locks; the locked model only supplies the locks.
#include "oracle/output_values.hpp"

#include <functional>

#include "elgen/oracle.hpp"
#include "model/requests.hpp"
#include "oracle/constraints.hpp"
#include "oracle/mechanics.hpp"
#include "oracle/regressor.hpp"
#include "oracle/rotations.hpp"
#include "oracle/solved_dynamics.hpp"
#include "oracle/user_outputs.hpp"

namespace elgen::oracle {
namespace {

using cln::cl_R;

/// w.(M a + bias - B u) of the whole model, for the unit vector w of each velocity in
/// reaction_row_velocities().
std::vector<cl_R> reaction_forces(const Model& model, const State& state) {
  const std::vector<std::uint32_t> held = reaction_row_velocities(model);
  if (held.empty()) return {};
  const State whole = map_leaves([](const Jet& value) { return value.real(); },
                                 whole_motion(model, make_motion(state)));
  Mechanics at(unreduced_model(model), whole);
  std::vector<cl_R> values;
  for (const std::uint32_t velocity : held) {
    const Direction w = at.unit(velocity);
    values.push_back(at.inverse_dynamics(w, whole.a) -
                     (whole.u.empty() ? cl_R(0) : at.input_force(w, whole.u)));
  }
  return values;
}

struct OracleRow {
  Values (*values)(const OutputQuery&);
  /// w.x of a column or w.X y of a matrix. Null: needs_entries().
  cl_R (*contraction)(const OutputQuery&, const Contraction&) = nullptr;
};

/// C_ij = 1/2 (dM_ij/dt + R_ij - R_ji + rotation_terms), with dM/dt along v and R_ij = d/dq_j (M
/// v)_i. A contraction for each entry would cost twice as much.
Values coriolis_entries(Mechanics& at) {
  const std::size_t n = at.size();
  const Direction& v = at.state().v;
  Values c(n * n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      c[i * n + j] = c[j * n + i] = at.mass_gradient(v, at.unit(i), at.unit(j));
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      const cl_R r = at.mass_gradient(at.unit(j), at.unit(i), v);
      c[i * n + j] = c[i * n + j] + r + rotation_terms(at, at.unit(i), at.unit(j));
      c[j * n + i] = c[j * n + i] - r;
    }
  }
  for (cl_R& entry : c) entry = entry / 2;
  return c;
}

cl_R total_energy_of(Mechanics& at) { return at.kinetic_energy() + at.potential_energy(); }

/// a, the relative pivots of M and of S = A M^-1 A^T, and the multipliers.
Values forward_dynamics_entries(Mechanics& at) {
  const ConstrainedSystem system = constrained_system(at);
  const ConstrainedMotion motion = constrained_motion(at, system);
  Values values = motion.x;
  for (const Values& more : {solve_mass(at.model(), system.mass, Values(at.size())).relative_pivots,
                             constraint_pivots(at.model(), system), motion.y}) {
    values.insert(values.end(), more.begin(), more.end());
  }
  return values;
}

bool has_reference(const OutputQuery& query) {
  return output_row(query.output.kind).argument_kinds.has_any(Opcode::reference);
}

/// Y, then rest. `rest` is the force if all parameters are 0. Column k of Y is the force if
/// parameter k is 1 and all others are 0, minus rest.
Values regressor_entries(const OutputQuery& query) {
  const std::size_t n = query.state.v.size();
  const std::size_t count = extent_size(query.model, Extent::inertial);
  std::vector<Direction> units;
  for (std::size_t i = 0; i < n; ++i) units.push_back(unit_direction(n, i));
  std::vector<Values> choices{Values(count, 0)};
  for (std::size_t k = 0; k < count; ++k) choices.push_back(unit_direction(count, k));
  const std::vector<Values> forces =
      forces_of_parameters(query.model, query.state, choices, units, has_reference(query));
  const Values& rest = forces.front();
  Values all(n * count);
  for (std::size_t k = 0; k < n * count; ++k) {
    all[k] = forces[1 + k % count][k / count] - rest[k / count];
  }
  all.insert(all.end(), rest.begin(), rest.end());
  return all;
}

/// w.Y y, or w.rest.
cl_R contract_regressor(const OutputQuery& query, const Contraction& by) {
  std::vector<Values> choices{Values(extent_size(query.model, Extent::inertial), 0)};
  if (by.field == 0) choices.push_back(by.y);
  const std::vector<Values> forces =
      forces_of_parameters(query.model, query.state, choices, {by.w}, has_reference(query));
  const cl_R& rest = forces.front().front();
  return by.field == 1 ? rest : forces.back().front() - rest;
}

Values rates_of_coordinates(const OutputQuery& query) {
  const Motion motion = make_motion(query.state);
  Values values;
  for (const Jet& rate : coordinate_rates(query.model, motion.q, motion.v)) {
    values.push_back(rate.real());
  }
  return values;
}

/// The state with v computed from its momenta.
State state_from_momenta(const OutputQuery& query) {
  State state = query.state;
  state.v = velocities_of_momenta(query.model, query.state, query.state.momenta);
  return state;
}

/// M^-1, n x n row-major, by one solve per column.
Values inverse_mass_entries(Mechanics& at) {
  const std::size_t n = at.size();
  const Values mass = at.mass_matrix();
  Values entries(n * n);
  for (std::size_t j = 0; j < n; ++j) {
    const Values column = solve_mass(at.model(), mass, at.unit(j)).x;
    for (std::size_t i = 0; i < n; ++i) entries[i * n + j] = column[i];
  }
  return entries;
}

/// w.d(B u)/dq y: the slope of w.(M a + bias - B u) at u = 0 minus its slope at u.
cl_R input_force_slope(Mechanics& at, const Direction& w, const Direction& y) {
  const Displacement along{y, Direction(at.size(), cl_R(0))};
  const Direction& none = along.velocity;
  const Direction no_input(at.state().u.size(), cl_R(0));
  return at.residual_slope(w, along, none, no_input) -
         at.residual_slope(w, along, none, at.state().u);
}

/// d(B u)/dq along all coordinates, n x n row-major.
Values input_force_slopes(Mechanics& at) {
  const std::size_t n = at.size();
  Values entries;
  for (std::size_t k = 0; k < n * n; ++k) {
    entries.push_back(input_force_slope(at, at.unit(k / n), at.unit(k % n)));
  }
  return entries;
}

/// v.dL/dv - L at the velocities computed from the momenta.
Values hamiltonian_of(const OutputQuery& query) {
  const State state = state_from_momenta(query);
  return {Mechanics(query.model, state).energy_function()};
}

/// dq/dt, then dp/dt.
Values canonical_rates(const OutputQuery& query) {
  const State state = state_from_momenta(query);
  Values values = rates_of_coordinates({query.model, query.output, state});
  const Values of_momenta = momentum_rates(query.model, state);
  values.insert(values.end(), of_momenta.begin(), of_momenta.end());
  return values;
}

Values step_entries(const OutputQuery& query) {
  return oracle::take_step(query.model, query.output, query.state);
}

Values completed_values(const OutputQuery& query) {
  return oracle::complete_motion(query.model, query.output.independent, query.state);
}

Values cyclic_rate_entries(const OutputQuery& query) {
  if (!has_routhian(query.model)) return {};
  const Motion motion = make_motion(query.state);
  Values values;
  for (const Jet& rate : cyclic_rates(Evaluation(query.model, motion)))
    values.push_back(rate.real());
  return values;
}

/// Adapts a scalar or vector function of Mechanics to OracleRow::values.
template <auto whole>
Values all_entries(const OutputQuery& query) {
  Mechanics at(query.model, query.state);
  return {std::invoke(whole, at)};
}

/// x_i = e_i.x for each unit vector e_i.
template <auto product>
Values column_entries(const OutputQuery& query) {
  Mechanics at(query.model, query.state);
  Values values;
  for (std::size_t i = 0; i < at.size(); ++i) {
    values.push_back(std::invoke(product, at, at.unit(i)));
  }
  return values;
}

/// Adapts a function of w, of (w, y) or of a Contraction to OracleRow::contraction.
template <auto product>
cl_R contract(const OutputQuery& query, const Contraction& by) {
  Mechanics at(query.model, query.state);
  if constexpr (std::is_invocable_v<decltype(product), Mechanics&, const Direction&>) {
    return std::invoke(product, at, by.w);
  } else if constexpr (std::is_invocable_v<decltype(product), Mechanics&, const Contraction&>) {
    return std::invoke(product, at, by);
  } else {
    return std::invoke(product, at, by.w, by.y);
  }
}

template <auto product>
constexpr OracleRow column{column_entries<product>, contract<product>};

namespace rows {

constexpr OracleRow mass_matrix{all_entries<&Mechanics::mass_matrix>,
                                contract<&Mechanics::mass_product>};
constexpr OracleRow coriolis_matrix{all_entries<coriolis_entries>,
                                    contract<coriolis_matrix_product>};
constexpr OracleRow input_matrix{all_entries<input_matrix_entries>,
                                 contract<&Mechanics::input_force>};

constexpr OracleRow velocity_force = column<oracle::velocity_force>;
constexpr OracleRow gravity = column<&Mechanics::gravity>;
constexpr OracleRow drift = column<oracle::drift>;
constexpr OracleRow dissipation = column<&Mechanics::dissipation_force>;
constexpr OracleRow applied_force = column<&Mechanics::applied_force>;
constexpr OracleRow bias = column<oracle::bias>;
constexpr OracleRow inverse_dynamics = column<oracle::inverse_dynamics>;
constexpr OracleRow momentum = column<&Mechanics::momentum>;
constexpr OracleRow position_gradient = column<&Mechanics::position_gradient>;
constexpr OracleRow reaction{
    [](const OutputQuery& of) { return oracle::reaction_forces(of.model, of.state); }};

constexpr OracleRow potential_energy{all_entries<&Mechanics::potential_energy_at_rest>};
constexpr OracleRow kinetic_energy{all_entries<&Mechanics::kinetic_energy>};
constexpr OracleRow total_energy{all_entries<total_energy_of>};
constexpr OracleRow energy_function{all_entries<&Mechanics::energy_function>};

constexpr OracleRow forward_dynamics{all_entries<forward_dynamics_entries>};
constexpr OracleRow linearization{all_entries<state_matrices>, contract<state_contraction>};
constexpr OracleRow inverse_dynamics_derivatives{all_entries<inverse_derivatives>,
                                                 contract<inverse_contraction>};
constexpr OracleRow forward_dynamics_derivatives{all_entries<forward_derivatives>,
                                                 contract<forward_contraction>};

constexpr OracleRow input_force_derivatives{all_entries<input_force_slopes>,
                                            contract<input_force_slope>};
constexpr OracleRow inverse_mass_matrix{all_entries<inverse_mass_entries>};

constexpr OracleRow hamiltonian{hamiltonian_of};
constexpr OracleRow velocities_of_momenta{[](const OutputQuery& of) {
  return oracle::velocities_of_momenta(of.model, of.state, of.state.momenta);
}};
constexpr OracleRow hamilton_equations{canonical_rates};

constexpr OracleRow coordinate_rates{rates_of_coordinates};
constexpr OracleRow normalized{
    [](const OutputQuery& of) { return oracle::normalize_quaternions(of.model, of.state.q); }};

constexpr OracleRow cyclic_rates{cyclic_rate_entries};

template <Values (*values)(const Model&, const State&)>
Values constraint_entries(const OutputQuery& query) {
  return values(query.model, query.state);
}

constexpr OracleRow constraint_residual{constraint_entries<oracle::constraint_residual>};
constexpr OracleRow constraint_jacobian{constraint_entries<oracle::constraint_jacobian>};
constexpr OracleRow constraint_bias{constraint_entries<oracle::constraint_bias>};
constexpr OracleRow projected{constraint_entries<oracle::project_state>};
constexpr OracleRow constrained_inverse_dynamics{
    constraint_entries<oracle::constrained_inverse_dynamics>};

constexpr OracleRow completed{completed_values};

constexpr OracleRow regressor{regressor_entries, contract_regressor};
constexpr OracleRow regressor_reference = regressor;
constexpr OracleRow regressor_parameters{
    [](const OutputQuery& of) { return oracle::regressor_parameters(of.model, of.state); }};

constexpr OracleRow user_value{user_output_values};
constexpr OracleRow user_jacobian{user_output_jacobian};
constexpr OracleRow user_bias{user_output_bias};
constexpr OracleRow user_derivatives{user_output_derivatives};
constexpr OracleRow user_operational{user_operational_dynamics};

constexpr OracleRow step{step_entries};
constexpr OracleRow step_derivatives{
    [](const OutputQuery& of) { return oracle::step_derivatives(of.model, of.output, of.state); },
    [](const OutputQuery& of, const Contraction& by) {
      return step_contraction(of.model, of.output, of.state, by);
    }};

constexpr OracleRow no_entries{[](const OutputQuery&) { return Values(); }};

constexpr OracleRow table[] = {
#define ELGEN_OUTPUT(name) name,
#define ELGEN_SUMMARY(name) no_entries,
#include "elgen/outputs.def"
};

}  // namespace rows

const OracleRow& oracle_row(const OutputRequest& output) {
  return rows::table[static_cast<std::size_t>(output.kind)];
}

}  // namespace

Values output_values(const Model& model, const OutputRequest& output, const State& state) {
  return oracle_row(output).values({model, output, state});
}

cl_R contract_output(const Model& model, const OutputRequest& output, const State& state,
                     const Contraction& by) {
  const OutputQuery of{model, output, state};
  return needs_entries(output) ? contract_entries(model, output, oracle_row(output).values(of), by)
                               : oracle_row(output).contraction(of, by);
}

bool needs_entries(const OutputRequest& output) {
  return oracle_row(output).contraction == nullptr;
}

}  // namespace elgen::oracle
