// sample_tradeoff_states: draws random states inside the ranges, and computes the exact values at
// these states.
#include "sample/states.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "elgen/leaf_names.hpp"
#include "elgen/wording.hpp"
#include "program/evaluate/subject.hpp"
#include "run/tradeoff/errors.hpp"

namespace elgen {
namespace {

/// Sets the range of the leaf that has the name of `narrowed`.
void narrow_range(const Model& model, const NamedRange& narrowed, LeafValues<Range>& ranges) {
  const auto visit = [&](Opcode kind, std::uint32_t i, Range& range) {
    const bool is_named = is_in_state(kind) && leaf_text(model, kind, i) == narrowed.name;
    if (is_named) range = {narrowed.low, narrowed.high};
  };
  for_each_leaf(visit, ranges);
}

/// Draws the varied parameters. Each end of a range has a quarter of the draws, because extreme
/// ratios of parameters lose most digits.
void draw_parameters(const Numerics& numerics, Sampler& draw, std::vector<double>& parameters) {
  for (const auto& [i, range] : numerics.varied_parameters) {
    const double low = to_double(range.low);
    const double high = to_double(range.high);
    const double share = std::clamp(draw.uniform({-0.5, 1.5}), 0.0, 1.0);
    const double value = low > 0 ? std::exp(std::lerp(std::log(low), std::log(high), share))
                                 : std::lerp(low, high, share);
    parameters[i] = std::clamp(value, low, high);
  }
}

/// Sets the leaves in the log to the values of the row for state `number` of the sample.
void set_logged_leaves(const Model& model, const TradeoffSampling& sampling, std::size_t number,
                       Arguments<double>& state) {
  const auto& [leaves, rows] = sampling.log;
  if (rows.empty()) return;
  const std::size_t place = sampling.samples * number + sampling.seed - 1;
  const std::size_t row = place * rows.size() / (sampling.samples * sampling.count);
  for (std::size_t k = 0; k < leaves.size(); ++k) {
    set_leaf(state, leaves[k].first, leaves[k].second, rows[row % rows.size()][k]);
  }
  normalize_quaternions(model, state);
}

TwoDoubleNumber exact_number(const cln::cl_R& value) {
  const double high = to_double(value);
  return {high, to_double(value - exact_value(high))};
}

}  // namespace

std::optional<std::vector<TwoDoubleNumber>> exact_entries(const CheckedModel& checked,
                                                          const Program& program,
                                                          const Arguments<double>& state) {
  Arguments<Real> arguments = map_leaves([](double x) { return Real(exact_value(x)); }, state);
  const State nominal = nominal_state(checked.model, checked.scene);
  for (std::size_t i = 0; i < arguments.parameters.size(); ++i) {
    arguments.parameters[i] = Real(nominal.parameters[i]);
  }
  for (const auto& [i, range] : checked.scene.numerics.varied_parameters) {
    arguments.parameters[i] = Real(exact_value(state.parameters[i]));
  }
  std::vector<TwoDoubleNumber> entries;
  for (const Real& value : evaluate(program, program.functions.front(), arguments)) {
    if (!value.is_defined()) return std::nullopt;
    entries.push_back(exact_number(value.value()));
  }
  return entries;
}

Result<TradeoffStates> sample_tradeoff_states(const CheckedModel& exact, const Program& program,
                                              const TradeoffSampling& sampling) {
  const SystemUnderTest subject{exact.model, exact.scene, program};
  LeafValues<Range> within = ranges_of(subject);
  for (const NamedRange& range : exact.scene.numerics.ranges) {
    narrow_range(exact.model, range, within);
  }
  Sampler draw(sampling.seed);
  TradeoffStates result;
  result.seed = sampling.seed;
  result.low = map_leaves([](const Range& range) { return range.low; }, within);
  result.high = map_leaves([](const Range& range) { return range.high; }, within);
  for (const auto& [kind, number] : sampling.log.leaves) {
    set_leaf(result.low, kind, number, 0);
    set_leaf(result.high, kind, number, 0);
  }
  const std::size_t count = sampling.count;
  std::vector<double> parameters;
  for (std::size_t tried = 0; result.states.size() < count && tried < 2 * count; ++tried) {
    Arguments<double> state = draw_in_ranges(subject, within, draw);
    if (result.states.size() % states_of_draw == 0) {
      parameters = state.parameters;
      draw_parameters(exact.scene.numerics, draw, parameters);
    }
    state.parameters = parameters;
    set_logged_leaves(exact.model, sampling, tried, state);
    auto entries = exact_entries(exact, program, state);
    if (!entries) continue;
    result.states.push_back(std::move(state));
    result.exact.push_back(std::move(*entries));
  }
  if (result.states.size() < count) {
    return Diagnostic{Code::E521,
                      {},
                      fmt::format("{} has no value at most states that were tried",
                                  quote_text(program.functions.front().name)),
                      "`--range NAME=LOW..HIGH` narrows the ranges"};
  }
  for (const Field& field : program.functions.front().fields) {
    result.field_sizes.push_back(field.entries.size());
  }
  return result;
}

}  // namespace elgen
