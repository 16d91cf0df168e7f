// exact_states: see states.hpp. All numbers are rational.
#include <array>
#include <utility>

#include "elgen/leaf_names.hpp"
#include "sample/states.hpp"

namespace elgen {
namespace {

using cln::cl_R;

/// A rational approximation of pi, so that states are exact.
const cln::cl_RA half_turn = cln::cl_RA(355) / 113;

/// The largest magnitudes of variables without a range. Turn i of draw_motion() uses element i
/// mod 3.
const std::array<cln::cl_RA, 3>& scales() {
  static const std::array<cln::cl_RA, 3> all{1, cln::cl_RA(1) / 1000, 1000};
  return all;
}

cl_R draw_rational_in(const Interval& range, Sampler& draw) {
  return range.low + (range.high - range.low) * cln::abs(draw.number());
}

void draw_parameters(const Model& model, const FixedParameters& fixed, Sampler& draw,
                     std::size_t turn, State& state) {
  for (std::uint32_t i = 0; i < state.parameters.size(); ++i) {
    if (fixed.count(i) > 0) continue;
    cl_R& parameter = state.parameters[i];
    const auto range = declared_range(model, Opcode::parameter, i);
    if (range && turn % 2 != 0) {
      parameter = draw_rational_in(*range, draw);
      continue;
    }
    const cln::cl_RA r = cln::abs(draw.number());
    parameter = cln::zerop(parameter) ? cl_R(r) : parameter * (cln::cl_RA(1) / 2 + r * 3 / 2);
    if (range) parameter = cln::max(range->low, cln::min(range->high, parameter));
  }
}

}  // namespace

void draw_motion(const Model& model, Sampler& draw, std::size_t turn, State& state) {
  const cln::cl_RA& scale = scales()[turn % scales().size()];
  const auto set = [&](Opcode kind, std::uint32_t number, cl_R& value) {
    if (!is_in_state(kind) || leaf_row(kind).argument_rule == ArgumentRule::if_used) return;
    if (const auto range = declared_range(model, kind, number)) {
      value = draw_rational_in(*range, draw);
    } else {
      const bool turns = kind == Opcode::coordinate && is_angle(model.coordinates[number]);
      value = draw.number() * (turns ? half_turn : scale);
    }
  };
  for_each_leaf(set, state);
  // The copy draws the optional leaves, so that they do not change the numbers that `draw` returns
  // later.
  Sampler optional_sampler = draw;
  const auto set_used = [&](const LeafRow& row, std::vector<cl_R>& list) {
    if (row.argument_rule != ArgumentRule::if_used) return;
    for (cl_R& value : list) value = optional_sampler.number() * scale;
  };
  for_each_list(set_used, state);
  set_rational_quaternions(model, state);
}

State draw_state(const Model& model, const Scene& scene, Sampler& draw, std::size_t turn) {
  State state = nominal_state(model, scene);
  if (turn > 0) draw_parameters(model, scene.specialisation.fixed, draw, turn, state);
  draw_motion(model, draw, turn, state);
  return state;
}

void normalize_state_quaternions(const Model& model, State& state) {
  if (model.rotations.empty()) return;
  OracleValues scaled = oracle_values(model, {.kind = OutputKind::normalized}, state);
  if (scaled) state.q = std::move(*scaled);
}

std::optional<State> move_onto_constraints(const Model& model, const State& state) {
  if (model.constraints.empty()) return state;
  std::optional<State> there = oracle_assembled_state(model, state);
  if (!there) return std::nullopt;
  const OracleValues moved = oracle_values(model, {.kind = OutputKind::projected}, *there);
  if (!moved) return std::nullopt;
  const auto middle = moved->begin() + static_cast<std::ptrdiff_t>(there->q.size());
  there->q.assign(moved->begin(), middle);
  there->v.assign(middle, moved->end());
  return there;
}

bool is_compared_on_constraints(const Model& model, OutputKind output) {
  return !model.constraints.empty() && !output_row(output).takes_unprojected;
}

State compared_state(const Model& model, OutputKind output, const State& drawn, State kept) {
  const OutputRow& row = output_row(output);
  // The output computes the dependent rates from the independent rates.
  if (row.options.has(OutputOption::independent)) kept.v = drawn.v;
  if (row.argument_kinds.has_any(Opcode::momentum)) {
    OracleValues momenta = oracle_values(model, {.kind = OutputKind::momentum}, kept);
    if (momenta) kept.momenta = std::move(*momenta);
  }
  return kept;
}

State with_leaves(const Model& model, State state, const std::vector<LeafAssignment>& leaves) {
  const auto place = [&leaves](Opcode kind, std::uint32_t number, cl_R& value) {
    for (const LeafAssignment& leaf : leaves) {
      if (leaf.kind == kind && leaf.number == number) value = leaf.value;
    }
  };
  for_each_leaf(place, state);
  normalize_state_quaternions(model, state);
  OracleValues momenta = oracle_values(model, {.kind = OutputKind::momentum}, state);
  if (momenta) state.momenta = std::move(*momenta);
  const auto take_velocities = [&state](const LeafRow& row, std::vector<cl_R>& list) {
    if (row.argument_rule == ArgumentRule::if_used && row.id != Opcode::momentum) list = state.v;
  };
  for_each_list(take_velocities, state);
  const auto place_used = [&place](Opcode kind, std::uint32_t number, cl_R& value) {
    if (leaf_row(kind).argument_rule == ArgumentRule::if_used) place(kind, number, value);
  };
  for_each_leaf(place_used, state);
  return state;
}

}  // namespace elgen
