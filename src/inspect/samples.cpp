// Sampled states: the model at its own values, moving anywhere.
#include "inspect/samples.hpp"

#include "base/random.hpp"

namespace elgen {
namespace {

constexpr unsigned attempts = 8;  // a model undefined at all of them has no domain worth the name

}  // namespace

State sampled_state(const Inspected& subject, unsigned seed) {
  Random random(seed);
  State state = nominal_state(subject.model, subject.scene);
  for (std::uint32_t i = 0; i < state.parameters.size(); ++i) {
    const bool fixed = subject.scene.specialisation.fixed.count(i) > 0;
    if (!fixed && cln::zerop(state.parameters[i]))
      state.parameters[i] = cln::abs(random.rational());
  }
  draw_motion(subject.model, random, state);
  return state;
}

std::optional<MassSample> sampled_mass_matrix(const Inspected& subject, unsigned seed) {
  for (unsigned attempt = 0; attempt < attempts; ++attempt) {
    State state = sampled_state(subject, seed * attempts + attempt);
    OracleValues matrix = oracle_values(subject.model, {.kind = OutputKind::mass_matrix}, state);
    if (matrix) return MassSample{std::move(state), std::move(*matrix)};
  }
  return std::nullopt;
}

}  // namespace elgen
