// Draws states inside the declared ranges, then changes them for their situation.
#include "verify/foreign/situations.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "numbers/exact_number.hpp"
#include "sample/states.hpp"

namespace elgen {
namespace {

Arguments<double> draw_state(Situation situation, const SystemUnderTest& subject,
                             const LeafValues<Range>& ranges, Sampler& draw) {
  Arguments<double> state = draw_in_ranges(subject, ranges, draw);
  const bool is_at_rest = situation == Situation::rest;
  if (is_at_rest || situation == Situation::driven) {
    for (auto* const rates : {&state.v, &state.momenta}) std::ranges::fill(*rates, 0.0);
  }
  if (is_at_rest || situation == Situation::moving) {
    for (auto* const drive : {&state.a, &state.u}) std::ranges::fill(*drive, 0.0);
  }
  if (situation == Situation::varied_parameters) {
    constexpr std::size_t half_to_twice = 2;  // parameters: half to twice
    const State drawn = draw_state(subject.model, subject.scene, draw, half_to_twice);
    state.parameters = arguments_at<double>(drawn).parameters;
  }
  return state;
}

/// Projects q and v onto the constraints; false if Newton's method does not converge.
bool project_onto_constraints(const SystemUnderTest& subject, OutputKind output,
                              Arguments<double>& state) {
  const State drawn = exact_state(subject, state);
  std::optional<State> kept = move_onto_constraints(subject.model, drawn);
  if (!kept) return false;
  const auto moved =
      arguments_at<double>(compared_state(subject.model, output, drawn, std::move(*kept)));
  state.q = moved.q;
  state.v = moved.v;
  if (!state.momenta.empty()) state.momenta = moved.momenta;
  return true;
}

double changed_parameter_value(const Model& model, std::uint32_t parameter, double value) {
  const auto range = declared_range(model, Opcode::parameter, parameter);
  const double larger = value == 0 ? 1 : value * 1.25;
  return range && range->high < exact_value(larger) ? value * 0.75 : larger;
}

}  // namespace

ForeignStates draw_foreign_states(const SystemUnderTest& subject, const ForeignOptions& options,
                                  OutputKind output, bool is_moved) {
  Sampler draw(options.seed);
  const LeafValues<Range> ranges = ranges_of(subject);
  ForeignStates states;
  for (std::size_t i = 0; i < options.states; ++i) {
    const auto situation = static_cast<Situation>(i % situation_count);
    Arguments<double> state = draw_state(situation, subject, ranges, draw);
    if (is_moved && !project_onto_constraints(subject, output, state)) {
      ++states.unmet;
      continue;
    }
    states.values.push_back(std::move(state));
    states.situations.push_back(situation);
  }
  return states;
}

std::string_view drive_text(const OutputRequest& output) {
  const LeafSet takes = output.argument_kinds;
  if (!takes.has_any(Opcode::acceleration)) return "inputs";
  return takes.has_any(Opcode::input) ? "inputs or accelerations" : "accelerations";
}

std::vector<std::uint32_t> add_parameter_variations(const SystemUnderTest& subject,
                                                    std::vector<Arguments<double>>& states) {
  std::vector<std::uint32_t> changed;
  for (std::uint32_t i = 0; i < subject.model.parameters.size(); ++i) {
    if (subject.scene.specialisation.fixed.count(i) > 0) continue;
    changed.push_back(i);
    states.push_back(states.front());
    double& value = states.back().parameters[i];
    value = changed_parameter_value(subject.model, i, value);
  }
  return changed;
}

}  // namespace elgen
