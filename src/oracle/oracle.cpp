// The oracle's interface: turns every failure of the domain into an empty value.
#include "elgen/oracle.hpp"

#include <array>

#include "elgen/leaf_names.hpp"
#include "elgen/references.hpp"
#include "numbers/random.hpp"
#include "oracle/mechanics.hpp"
#include "oracle/output_values.hpp"
#include "oracle/solved_dynamics.hpp"

namespace elgen {
namespace {

using cln::cl_R;
using oracle::attempt;
using oracle::guarded;

const cln::cl_RA half_turn = cln::cl_RA(355) / 113;  // rational, so that states are exact

/// Lengths, rates and forces without a range have one of these magnitudes, in turn.
const std::array<cln::cl_RA, 3>& scales() {
  static const std::array<cln::cl_RA, 3> all{1, cln::cl_RA(1) / 1000, 1000};
  return all;
}

cl_R within(const Interval& range, Random& random) {
  return range.low + (range.high - range.low) * cln::abs(random.rational());
}

}  // namespace

State nominal_state(const Model& model, const Scene& scene) {
  State state = leaves_of<cl_R>(
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

void draw_parameters(const Model& model, const FixedParameters& fixed, Random& random,
                     std::size_t turn, State& state) {
  for (std::uint32_t i = 0; i < state.parameters.size(); ++i) {
    if (fixed.count(i) > 0) continue;
    cl_R& parameter = state.parameters[i];
    const auto range = declared_range(model, Opcode::parameter, i);
    if (range && turn % 2 != 0) {
      parameter = within(*range, random);
      continue;
    }
    const cln::cl_RA r = cln::abs(random.rational());
    parameter = cln::zerop(parameter) ? cl_R(r) : parameter * (cln::cl_RA(1) / 2 + r * 3 / 2);
    if (range) parameter = cln::max(range->low, cln::min(range->high, parameter));
  }
}

void draw_motion(const Model& model, Random& random, std::size_t turn, State& state) {
  constexpr LeafSet undrawn =
      Opcode::parameter | Opcode::step | Opcode::momentum | Opcode::energy | Opcode::multiplier;
  const cln::cl_RA& scale = scales()[turn % scales().size()];
  const auto draw = [&](Opcode kind, std::uint32_t number, cl_R& value) {
    if (undrawn.has_any(kind)) return;
    if (const auto range = declared_range(model, kind, number)) {
      value = within(*range, random);
    } else {
      const bool turns = kind == Opcode::coordinate && is_angle(model.coordinates[number]);
      value = random.rational() * (turns ? half_turn : scale);
    }
  };
  for_each_leaf(draw, state);
  // By a copy, so that momenta leave all that follows as it is.
  Random of_momenta = random;
  for (cl_R& p : state.momenta) p = of_momenta.rational() * scale;
  make_unit_quaternions(model, state);
}

OracleValues oracle_values(const Model& model, const OutputRequest& output, const State& state) {
  return guarded([&] { return oracle::output_values(model, output, state); });
}

std::optional<cl_R> oracle_residual_slope(const Model& model, const State& state,
                                          const std::vector<cl_R>& w, const std::vector<cl_R>& x,
                                          const std::vector<cl_R>& y) {
  return guarded([&] {
    return oracle::Mechanics(model, state).residual_slope(w, {x, y}, state.a, state.u);
  });
}

std::optional<cl_R> oracle_contraction(const Model& model, const OutputRequest& output,
                                       const State& state, const Contraction& by) {
  return guarded([&] { return oracle::contracted_values(model, output, state, by); });
}

std::optional<cl_R> oracle_energy_magnitude(const Model& model, const State& state) {
  return guarded([&] { return oracle::Mechanics(model, state).energy_magnitude(); });
}

OracleValues oracle_relative_pivots(std::vector<cl_R> matrix, std::size_t n) {
  return attempt(
      [&] { return oracle::solve_symmetric(matrix, std::vector<cl_R>(n)).relative_pivots; });
}

std::optional<cl_R> oracle_expression(const Model& model, ExpressionId expression,
                                      const State& state) {
  return guarded(
      [&] { return oracle::Evaluation(model, oracle::motion_of(state)).value(expression).real(); });
}

std::optional<cl_R> oracle_slope(const Model& model, ExpressionId expression, const State& state,
                                 const State& direction) {
  constexpr oracle::Generators along = oracle::generator(0);
  const oracle::Motion motion = map_leaves(
      [](const cl_R& at, const cl_R& by) { return oracle::Jet(at) + oracle::Jet(along, by); },
      state, direction);
  return guarded(
      [&] { return oracle::Evaluation(model, motion).value(expression).coefficient(along); });
}

std::optional<cl_R> oracle_rate(const Model& model, ExpressionId expression, const State& state) {
  constexpr oracle::Generators along = oracle::generator(1);
  return guarded([&] {
    oracle::Motion motion = oracle::motion_of(state);
    oracle::move_on(model, motion, motion.a, along);
    if (holds_leaf(model, expression, Opcode::momentum | Opcode::energy)) {
      oracle::Mechanics(model, state).add_momenta(motion);
    }
    return oracle::Evaluation(model, motion).value(expression).coefficient(along);
  });
}

bool oracle_meets(const Model& model, const Condition& condition, const State& state) {
  const std::optional<cl_R> excess = oracle_expression(model, condition.excess, state);
  return excess && (condition.is_strict ? *excess > 0 : *excess >= 0);
}

std::optional<State> oracle_point(const Model& model, const StatedPoint& point, State state) {
  const State given = state;
  const auto place = [&](const std::vector<std::optional<ExpressionId>>& values,
                         std::vector<cl_R>& entries) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!values[i]) continue;
      const std::optional<cl_R> value = oracle_expression(model, *values[i], given);
      if (!value) return false;
      entries[i] = *value;
    }
    return true;
  };
  state.v.assign(state.v.size(), cl_R(0));
  state.a = state.v;
  state.u.assign(state.u.size(), cl_R(0));
  const bool exists = place(point.coordinates, state.q) && place(point.inputs, state.u);
  return exists ? std::optional(std::move(state)) : std::nullopt;
}

}  // namespace elgen
