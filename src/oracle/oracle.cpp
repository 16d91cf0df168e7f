// The oracle's public functions. They return empty values if a quantity is undefined
// (OutsideDomain).
#include "elgen/oracle.hpp"

#include "elgen/leaf_names.hpp"
#include "elgen/references.hpp"
#include "model/requests.hpp"
#include "oracle/mechanics.hpp"
#include "oracle/output_values.hpp"
#include "oracle/solved_dynamics.hpp"

namespace elgen {
namespace {

using cln::cl_R;
using oracle::attempt;
using oracle::attempt_with_enough_digits;

}  // namespace

State nominal_state(const Model& model, const Scene& scene) {
  State state = make_leaf_values<cl_R>(
      model, [](Opcode, const auto&) { return cl_R(0); }, [](Opcode) { return cl_R(0); });
  for (std::uint32_t i = 0; i < model.parameters.size(); ++i) {
    const auto fixed = scene.specialisation.fixed.find(i);
    const bool is_fixed = fixed != scene.specialisation.fixed.end();
    state.parameters[i] = is_fixed ? fixed->second.number : model.parameters[i].value;
  }
  for (const Rotation& rotation : model.rotations) state.q[rotation.first_coordinate] = 1;
  return state;
}

State start_state(const Model& model, const Scene& scene) {
  State state = nominal_state(model, scene);
  for (std::size_t i = 0; i < state.q.size(); ++i) state.q[i] = model.coordinates[i].start_value;
  for (std::size_t i = 0; i < state.v.size(); ++i) state.v[i] = model.velocities[i].start_rate;
  return state;
}

OracleValues oracle_values(const Model& model, const OutputRequest& output, const State& state) {
  return attempt_with_enough_digits([&] { return oracle::output_values(model, output, state); });
}

std::optional<cl_R> oracle_residual_slope(const Model& model, const State& state,
                                          const std::vector<cl_R>& w, const std::vector<cl_R>& x,
                                          const std::vector<cl_R>& y) {
  return attempt_with_enough_digits([&] {
    return oracle::Mechanics(model, state).residual_slope(w, {x, y}, state.a, state.u);
  });
}

std::optional<cl_R> oracle_contraction(const Model& model, const OutputRequest& output,
                                       const State& state, const Contraction& by) {
  return attempt_with_enough_digits(
      [&] { return oracle::contract_output(model, output, state, by); });
}

cl_R contract_entries(const Model& model, const OutputRequest& output,
                      const std::vector<cl_R>& values, const Contraction& by) {
  const std::size_t first = first_entry_index(model, output, by.field);
  const std::size_t columns = by.y.empty() ? 1 : by.y.size();
  cl_R sum = 0;
  for (std::size_t k = 0; k < by.w.size() * columns; ++k) {
    const cl_R& factor = by.w[k / columns];
    sum = sum + values[first + k] * (by.y.empty() ? factor : factor * by.y[k % columns]);
  }
  return sum;
}

bool oracle_needs_entries(const OutputRequest& output) { return oracle::needs_entries(output); }

std::optional<cl_R> oracle_energy_magnitude(const Model& model, const State& state) {
  return attempt_with_enough_digits(
      [&] { return oracle::Mechanics(model, state).energy_magnitude(); });
}

OracleValues oracle_relative_pivots(std::vector<cl_R> matrix, std::size_t n) {
  return attempt(
      [&] { return oracle::solve_symmetric(matrix, std::vector<cl_R>(n)).relative_pivots; });
}

std::optional<cl_R> oracle_expression_value(const Model& model, ExpressionId expression,
                                            const State& state) {
  return attempt_with_enough_digits([&] {
    return oracle::Evaluation(model, oracle::make_motion(state)).value(expression).real();
  });
}

std::optional<cl_R> oracle_directional_derivative(const Model& model, ExpressionId expression,
                                                  const State& state, const State& direction) {
  constexpr oracle::Generators along = oracle::generator(0);
  const oracle::Motion motion = map_leaves(
      [](const cl_R& at, const cl_R& by) { return oracle::Jet(at) + oracle::Jet(along, by); },
      state, direction);
  return attempt_with_enough_digits(
      [&] { return oracle::Evaluation(model, motion).value(expression).coefficient(along); });
}

std::optional<cl_R> oracle_expression_rate(const Model& model, ExpressionId expression,
                                           const State& state) {
  constexpr oracle::Generators along = oracle::generator(1);
  return attempt_with_enough_digits([&] {
    oracle::Motion motion = oracle::make_motion(state);
    oracle::advance_time(model, motion, motion.a, along);
    if (contains_leaf(model, expression, Opcode::momentum | Opcode::energy)) {
      oracle::Mechanics(model, state).set_momenta_and_energy(motion);
    }
    return oracle::Evaluation(model, motion).value(expression).coefficient(along);
  });
}

bool oracle_satisfies(const Model& model, const Condition& condition, const State& state) {
  const std::optional<cl_R> excess = oracle_expression_value(model, condition.excess, state);
  return excess && (condition.is_strict ? *excess > 0 : *excess >= 0);
}

std::optional<State> oracle_rest_state(const Model& model, const OperatingPoint& point,
                                       State state) {
  const State given = state;
  const auto write_values = [&](const std::vector<std::optional<ExpressionId>>& values,
                                std::vector<cl_R>& entries) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!values[i]) continue;
      const std::optional<cl_R> value = oracle_expression_value(model, *values[i], given);
      if (!value) return false;
      entries[i] = *value;
    }
    return true;
  };
  state.v.assign(state.v.size(), cl_R(0));
  state.a = state.v;
  state.u.assign(state.u.size(), cl_R(0));
  const bool exists =
      write_values(point.coordinates, state.q) && write_values(point.inputs, state.u);
  return exists ? std::optional(std::move(state)) : std::nullopt;
}

}  // namespace elgen
